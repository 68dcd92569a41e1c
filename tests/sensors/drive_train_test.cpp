// Motors, battery and body together: the robot's response to the firmware's duties.

#include "sim/sensors/drive_train.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "course/bundled_files.h"
#include "firmware/quadrature.h"
#include "sim/body/body.h"
#include "sim/sensors/quadrature_encoder.h"

namespace tp100::sim {
namespace {

double speed_after(double duty, double load_n = 0.0, int steps = 1500, double volts = 7.6) {
  Motor motor({}, 1.0);
  for (int i = 0; i < steps; ++i) motor.step(duty, volts, load_n);
  return motor.track_mps();
}

TEST(Motor, RunsFromItsDeadBandToTheTopSpeedOfTheRealKindBothWays) {
  EXPECT_EQ(speed_after(0.05), 0.0);
  EXPECT_EQ(speed_after(-0.05), 0.0);
  EXPECT_GT(speed_after(0.15), 0.005);
  EXPECT_GT(speed_after(1.0), 0.14);
  EXPECT_LT(speed_after(1.0), 0.29);
  EXPECT_NEAR(speed_after(-1.0), -speed_after(1.0), 1e-12);
  EXPECT_NEAR(speed_after(0.8, 0.0, 80), speed_after(0.8) * (1.0 - std::exp(-1.0)),
              0.05 * speed_after(0.8))
      << "in its time constant";
}

TEST(Motor, CarriesTheLoadOfASpinAndOfARampAtTestSpeed) {
  EXPECT_GT(speed_after(1.0, 3.0), 0.12);
  const double ramp_n = 0.922 * 9.81 * std::sin(28.0 * M_PI / 180.0) / 2.0;
  EXPECT_GT(speed_after(1.0, ramp_n, 1500, 6.2), 0.12) << "on an empty battery";
}

TEST(Motor, AStalledMotorMakesNoMoreThanTheCurrentLimit) {
  course::EmulatedMotor values;
  values.current_limit_n = 3.0;
  Motor motor(values, 1.0);
  motor.step(1.0, 8.2, 0.0);
  EXPECT_EQ(motor.force_n(), 3.0);
}

TEST(Battery, RunsDown) {
  course::EmulatedBattery values;
  values.capacity_as = 1.0;
  Battery battery(values);
  for (int i = 0; i < 10000; ++i) battery.step(10.0);
  EXPECT_LT(battery.volts(), 6.2);
}

struct DriveTrain {
  explicit DriveTrain(const course::EmulatedMotor& motor = {})
      : left(motor, 1.0), right(motor, 1.0) {}
  explicit DriveTrain(const course::Emulated& values)
      : body(make_body(values, {}, false)), left(values.motor, 1.0), right(values.motor, 1.0) {}

  void run(double left_duty, double right_duty, int steps) {
    for (int i = 0; i < steps; ++i) {
      left.step(left_duty, battery.volts(), body->state().left_load_n);
      right.step(right_duty, battery.volts(), body->state().right_load_n);
      battery.step(std::abs(left.force_n()) + std::abs(right.force_n()));
      body->step(left.track_mps(), right.track_mps());
    }
  }

  std::unique_ptr<Body> body = make_body({}, {}, false);
  Battery battery{{}};
  Motor left, right;
};

TEST(DriveTrain, AQuickMotorDoesNotFightTheBody) {
  course::EmulatedMotor quick;
  quick.lag_s = 0.005;
  DriveTrain robot(quick);
  robot.run(-0.6, 0.6, 1000);
  const double settled = robot.right.track_mps();
  for (int i = 0; i < 200; ++i) {
    robot.run(-0.6, 0.6, 1);
    ASSERT_NEAR(robot.right.track_mps(), settled, 1e-4);
  }
}

// A spin, a straight line or any curve, ended at once or by a ramp: the robot stands still 2 s
// after it.
TEST(DriveTrain, EveryStopEndsAtRest) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (const std::string& name : course::bundled_names(course::Bundled::kRobots)) {
    const std::string text = course::read_bundled(course::Bundled::kRobots, name).text;
    const course::Emulated values = course::parse_robot(text, name).emulated;
    for (int run = 0; run < 12; ++run) {
      DriveTrain robot(values);
      const double left = any(random);
      const double right = run % 3 == 0 ? left : run % 3 == 1 ? -left : any(random);
      robot.run(left, right, 400);
      for (int step = run % 2 == 0 ? 0 : 400; step > 0; --step)
        robot.run(left * step / 400.0, right * step / 400.0, 1);
      robot.run(0.0, 0.0, 2000);
      double tracks_m = 0.0, turned_rad = 0.0;
      for (int step = 0; step < 500; ++step) {
        robot.run(0.0, 0.0, 1);
        tracks_m += (std::abs(robot.left.track_mps()) + std::abs(robot.right.track_mps())) * 1e-3;
        turned_rad += std::abs(robot.body->state().rate_radps[2]) * 1e-3;
      }
      EXPECT_LT(tracks_m, 1e-6) << name << ", duties " << left << ' ' << right;
      EXPECT_LT(turned_rad, 5e-5) << name << ", duties " << left << ' ' << right;
    }
  }
}

TEST(QuadratureEncoder, EdgesDecodeToTheTravelUnderAnySpeedProfile) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> speed(-0.25, 0.25);
    course::EmulatedEncoder values;
    values.phase_error = 0.3;
    QuadratureEncoder encoder(values, 2, seed);
    firmware::Quadrature counter{};
    double travel = 0.0;
    std::int64_t last_ns = 0;
    for (int ms = 0; ms < 3000; ++ms) {
      const double step_m = speed(random) * 1e-3;
      travel += step_m;
      std::vector<EncoderEdge> edges;
      encoder.move(step_m, ms * 1'000'000LL, (ms + 1) * 1'000'000LL, edges);
      for (const EncoderEdge& edge : edges) {
        ASSERT_GE(edge.at_ns, last_ns);
        ASSERT_LE(edge.at_ns, (ms + 1) * 1'000'000LL);
        ASSERT_GE(edge.channel, 2);
        last_ns = edge.at_ns;
        const unsigned bit = 1U << edge.channel % 2U;
        ASSERT_NE((counter.phase & bit) != 0, edge.level) << "an edge must change its level";
        firmware::take_edge<1>(counter, static_cast<std::uint8_t>(counter.phase ^ bit));
      }
    }
    EXPECT_EQ(firmware::extended_counts(counter), encoder.counts());
    EXPECT_NEAR(static_cast<double>(encoder.counts()), travel * values.counts_per_metre, 1.5);
  }
}

}  // namespace
}  // namespace tp100::sim
