// Motors, battery and body together: the robot's response to the firmware's duties.

#include "sim/sensors/drive_train.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "course/bundled_files.h"
#include "sim/body/body.h"

namespace tp100::sim {
namespace {

double speed_after(double duty, double load_n, int steps = 1500) {
  Motor motor({}, 1.0);
  for (int i = 0; i < steps; ++i) motor.step(duty, 7.6, load_n);
  return motor.track_mps();
}

TEST(Motor, RunsFromItsDeadBandToTheTopSpeedOfTheRealKindBothWays) {
  EXPECT_EQ(speed_after(0.05, 0.0), 0.0);
  EXPECT_EQ(speed_after(-0.05, 0.0), 0.0);
  EXPECT_GT(speed_after(0.15, 0.0), 0.005);
  EXPECT_GT(speed_after(1.0, 0.0), 0.14);
  EXPECT_LT(speed_after(1.0, 0.0), 0.29);
  EXPECT_NEAR(speed_after(-1.0, 0.0), -speed_after(1.0, 0.0), 1e-12);
}

TEST(Motor, CarriesTheLoadOfASpinAtTestSpeed) { EXPECT_GT(speed_after(1.0, 3.0), 0.12); }

TEST(Motor, ClimbsTwentyEightDegreesAtTestSpeedOnAnEmptyBattery) {
  const double load_n = 0.922 * 9.81 * std::sin(28.0 * M_PI / 180.0) / 2.0;
  Motor motor({}, 1.0);
  for (int i = 0; i < 1500; ++i) motor.step(1.0, 6.2, load_n);
  EXPECT_GT(motor.track_mps(), 0.12);
}

TEST(Motor, ReachesTwoThirdsOfItsSpeedInItsTimeConstant) {
  const double end = speed_after(0.8, 0.0);
  EXPECT_NEAR(speed_after(0.8, 0.0, 80), end * (1.0 - std::exp(-1.0)), 0.05 * end);
}

TEST(Motor, CoastsToRestWithoutDutyAndStaysThere) {
  Motor motor({}, 1.0);
  for (int i = 0; i < 500; ++i) motor.step(0.6, 7.6, 0.0);
  for (int i = 0; i < 1000; ++i) motor.step(0.0, 7.6, 0.3);
  EXPECT_EQ(motor.track_mps(), 0.0);
}

TEST(Motor, AStalledMotorMakesNoMoreThanTheCurrentLimit) {
  course::EmulatedMotor values;
  values.current_limit_n = 3.0;
  Motor motor(values, 1.0);
  motor.step(1.0, 8.2, 0.0);
  EXPECT_EQ(motor.force_n(), 3.0);
}

TEST(Battery, SagsUnderLoadAndRecovers) {
  Battery battery({});
  battery.step(0.0);
  const double rested = battery.volts();
  battery.step(20.0);
  EXPECT_NEAR(rested - battery.volts(), 0.12 * 0.10 * 20.0, 1e-4);
  battery.step(0.0);
  EXPECT_NEAR(battery.volts(), rested, 1e-4);
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

TEST(DriveTrain, TheBodyLosesTheSlipOfItsTracks) {
  DriveTrain robot;
  robot.run(1.0, 1.0, 1500);
  EXPECT_GT(robot.left.track_mps(), 0.14);
  EXPECT_NEAR(robot.body->state().velocity_mps[0], 0.84 * robot.left.track_mps(), 1e-3);
}

TEST(DriveTrain, ASpinTakesBothMotorsAndSagsTheBattery) {
  DriveTrain robot;
  robot.run(0.0, 0.0, 1);
  const double rested_v = robot.battery.volts();
  robot.run(-1.0, 1.0, 1500);
  EXPECT_GT(robot.right.track_mps(), 0.15);
  EXPECT_GT(robot.right.force_n(), 3.0);
  EXPECT_LT(robot.battery.volts(), rested_v - 0.05);
}

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

}  // namespace
}  // namespace tp100::sim
