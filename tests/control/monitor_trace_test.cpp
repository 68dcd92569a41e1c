#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "control/monitor.h"
#include "support/golden_trace.h"
#include "support/sequence.h"

namespace tp100::control {
namespace {

constexpr std::array kMonitored{Fault::cross_track,
                                Fault::heading,
                                Fault::tilt,
                                Fault::fence,
                                Fault::time_limit,
                                Fault::stalled_track,
                                Fault::immobilised,
                                Fault::command_timeout,
                                Fault::battery_below_minimum,
                                Fault::encoders_against_duty,
                                Fault::gyro_against_encoders};

constexpr double kMonitorStepS = 0.0047;
constexpr int kRestartStep = 1100;

const MonitoredRobot kMeasured{.motor = {.dead_band = 0.09, .feed_forward = 3.4},
                               .wheelbase_m = 0.26,
                               .max_counts_per_s = 5000.0};

/// A drive around, consistent but for what `corrupt` changes.
class MonitoredTrace {
 public:
  MonitoredTrace(double mps, double radps) : mps_(mps), radps_(radps) {}

  /// For each fault the step in which it was raised first (0: never), and in how many.
  std::vector<double> run(const std::function<void(Observation&, Sample&, int)>& corrupt,
                          const Parameters& parameters = {}, const MonitoredRobot& robot = {}) {
    Monitor monitor{parameters,
                    course::Fence{-1.0, 1.2, -0.8, 0.9, {}, {{{0.5, 0.5}, {0.7, 0.5}, {0.5, 0.7}}}},
                    7.0, robot};
    std::vector<double> first(kMonitored.size(), 0.0), often(kMonitored.size(), 0.0);
    double left_counts = 0.0, right_counts = 0.0;
    for (int step = 1; step <= 1500; ++step) {
      Sample sample;
      Observation seen;
      const double radps = radps_ * std::sin(0.003 * step), mps = mps_;
      seen.left_mps = mps - radps * robot.wheelbase_m / 2.0;
      seen.right_mps = mps + radps * robot.wheelbase_m / 2.0;
      seen.commanded_left_mps = seen.left_mps;
      seen.commanded_right_mps = seen.right_mps;
      seen.encoder_yaw_rate_radps = radps;
      seen.gyro_yaw_rate_radps = radps;
      seen.gyro_in_use = true;
      seen.elapsed_s = step * kMonitorStepS;
      seen.dt_s = kMonitorStepS;
      seen.commanded = true;
      sample.imu_age = 0;
      sample.accel_mps2 = {0.3, -0.2, 9.8};
      sample.battery_v = 7.4;
      sample.last_command = static_cast<std::uint16_t>(step);
      sample.left_duty = std::copysign(0.08, seen.left_mps) + 3.1 * seen.left_mps - 0.3 * radps;
      sample.right_duty = std::copysign(0.08, seen.right_mps) + 3.1 * seen.right_mps + 0.3 * radps;
      sample.device_us = step * 4700;
      left_counts += 7000.0 * seen.left_mps * kMonitorStepS;
      right_counts += 7000.0 * seen.right_mps * kMonitorStepS;
      sample.left_counts = static_cast<std::int64_t>(left_counts);
      sample.right_counts = static_cast<std::int64_t>(right_counts);
      corrupt(seen, sample, step);
      seen.sample = &sample;
      const FaultMask faults = monitor.update(seen);
      for (std::size_t k = 0; k < kMonitored.size(); ++k) {
        if ((faults & fault_bit(kMonitored[k])) == 0) continue;
        if (first[k] == 0.0) first[k] = step;
        ++often[k];
      }
      if (step == kRestartStep) monitor.restart();
    }
    first.insert(first.end(), often.begin(), often.end());
    return first;
  }

 private:
  double mps_, radps_;
};

std::vector<std::function<void(Observation&, Sample&, int)>> corruptions(double side) {
  const auto ramp = [](int step) { return step / 1500.0; };
  const auto flicker = [ramp](int step) { return std::sin(60.0 * std::sqrt(ramp(step))); };
  return {
      [](Observation&, Sample&, int) {},
      [=](Observation& o, Sample&, int n) { o.target.off_path_m = 0.31 * ramp(n); },
      [=](Observation& o, Sample&, int n) { o.target.heading_error_rad = side * 1.9 * ramp(n); },
      [=](Observation& o, Sample&, int n) {
        o.target.heading_error_rad = side * (1.1 + 0.5 * flicker(n));
      },
      [=](Observation&, Sample& s, int n) {
        const double a = side * 2.0 * ramp(n);
        s.accel_mps2 = {7.0 * std::sin(a), 6.0 * std::sin(a), 9.2 * std::cos(a)};
      },
      [=](Observation&, Sample& s, int n) {
        s.accel_mps2 = {side * (7.0 + 9.0 * flicker(n)), 1.0, 9.0};
      },
      [=](Observation&, Sample& s, int n) {
        s.accel_mps2 = {9.0, 9.0, 1.0};
        s.imu_age = n % 90 < 70 ? 0 : 1;
      },
      [=](Observation&, Sample& s, int) {
        s.accel_mps2 = {9.0, 9.0, 1.0};
        s.imu_age = 2;
      },
      [=](Observation&, Sample& s, int n) { s.battery_v = 7.0 - 2.1 * ramp(n); },
      [=](Observation&, Sample& s, int n) { s.battery_v = 6.15 + 0.1 * (n % 450 > 440); },
      [=](Observation& o, Sample&, int n) { o.pose.x_m = side * 1.5 * ramp(n); },
      [=](Observation& o, Sample&, int n) { o.pose.y_m = side * 1.4 * ramp(n); },
      [=](Observation& o, Sample&, int n) { o.pose.x_m = o.pose.y_m = 0.8 * ramp(n); },
      [=](Observation& o, Sample&, int n) { o.elapsed_s = 40.0 * ramp(n); },
      [=](Observation& o, Sample&, int n) {
        o.commanded_left_mps = side * 0.08 * ramp(n);
        o.left_mps = side * 0.0025;
      },
      [=](Observation& o, Sample&, int n) {
        o.commanded_right_mps = -side * 0.05;
        o.right_mps = side * 0.01 * (1.0 - ramp(n));
      },
      [=](Observation& o, Sample&, int n) {
        o.right_mps = o.left_mps = 0.001;
        o.commanded_right_mps = n % 260 < 200 ? 0.05 : 0.0;
        o.commanded_left_mps = n % 260 > 190 ? -0.05 : 0.0;
      },
      [=](Observation& o, Sample& s, int n) {
        s.left_duty = side * 0.55 * ramp(n);
        o.left_mps = -side * 0.025;
      },
      [=](Observation& o, Sample& s, int n) {
        s.right_duty = -side * 0.45;
        o.right_mps = side * 0.06 * ramp(n);
      },
      [=](Observation& o, Sample& s, int n) {
        s.right_duty = side * (0.3 + 0.3 * flicker(n));
        o.right_mps = -side * 0.05;
      },
      [=](Observation&, Sample& s, int n) {
        if (n % 150 < n / 10) s.last_command = 12;
      },
      [=](Observation& o, Sample& s, int n) {
        s.last_command = 12;
        o.commanded = n % 100 < n / 15;
      },
      [=](Observation& o, Sample&, int n) { o.immobilised = n > 801; },
      [=](Observation& o, Sample&, int n) {
        o.by_hand = true;
        o.immobilised = n == 802;
        o.pose.x_m = 5.0;
        o.target.off_path_m = o.elapsed_s = 100.0;
        o.target.heading_error_rad = 2.0;
        o.commanded_right_mps = -o.commanded_right_mps * ramp(n);
      },
      [=](Observation& o, Sample&, int n) { o.gyro_yaw_rate_radps += side * 1.3 * ramp(n); },
      [=](Observation& o, Sample&, int n) { o.gyro_yaw_rate_radps += side * 0.2 * ramp(n); },
      [=](Observation& o, Sample&, int n) {
        o.gyro_yaw_rate_radps += side * 0.9 * (n % 300 < n / 5 ? 1.0 : -1.0);
        o.on_obstacle = true;
      },
      [=](Observation& o, Sample&, int n) {
        o.gyro_yaw_rate_radps += side * 1.3 * ramp(n);
        o.gyro_in_use = n % 400 < n / 4;
      },
      [=](Observation& o, Sample&, int n) { o.gyro_yaw_rate_radps *= 1.0 - side * 0.9 * ramp(n); },
      [=](Observation& o, Sample&, int n) {
        const double turned = 0.5 * ramp(n);
        o.commanded_right_mps = side * 0.06;
        o.commanded_left_mps = -side * 0.06;
        o.encoder_yaw_rate_radps = o.gyro_yaw_rate_radps = -side * turned;
      },
      [=](Observation& o, Sample&, int n) {
        const double asked = 0.06 * ramp(n);
        o.commanded_right_mps = side * asked;
        o.commanded_left_mps = -side * asked;
        o.encoder_yaw_rate_radps = o.gyro_yaw_rate_radps = -side * 0.16;
      },
      [=](Observation& o, Sample&, int n) {
        const double asked = n % 300 < 150 ? 0.12 : -0.12;
        o.commanded_right_mps = asked;
        o.commanded_left_mps = -asked;
        o.encoder_yaw_rate_radps = o.gyro_yaw_rate_radps =
            side * (0.2 + 2.0 * ramp(n)) * std::cos(2.0 * kPi * (n - 20 - n / 20) / 300.0);
      },
      [=](Observation& o, Sample&, int n) { o.left_mps *= 1.0 - ramp(n); },
      [=](Observation& o, Sample&, int n) { o.right_mps *= 1.0 - ramp(n); },
      [=](Observation& o, Sample& s, int n) {
        s.left_duty += side * 0.7 * ramp(n);
        o.gyro_in_use = false;
      },
      [=](Observation& o, Sample& s, int n) {
        s.right_duty += side * 0.9 * ramp(n);
        o.on_obstacle = n > 200;
      },
      [=](Observation& o, Sample& s, int n) {
        s.right_duty += side * 0.9 * ramp(n);
        o.pitch_rad = 0.4 * side;
      },
      [=](Observation& o, Sample& s, int n) {
        s.left_duty += 0.9 * ramp(n);
        o.gyro_yaw_rate_radps = o.encoder_yaw_rate_radps = side * 0.4;
      },
      [=](Observation&, Sample& s, int n) { s.left_counts += n > 901 ? 50 : 0; },
      [=](Observation&, Sample& s, int n) { s.left_counts += n > kRestartStep ? 50 : 0; },
      [=](Observation&, Sample& s, int n) { s.right_counts -= n > 901 && n < 950 ? 50 : 0; },
      [=](Observation& o, Sample& s, int n) {
        o.left_mps = o.right_mps = 0.01;
        s.left_duty = s.right_duty = 0.09 + 0.4 * ramp(n);
        o.gyro_yaw_rate_radps = o.encoder_yaw_rate_radps = side * 0.05;
      },
      [=](Observation& o, Sample& s, int n) {
        if (n < 600) s.last_command = 0;
        o.commanded_right_mps = side * 0.06;
        o.commanded_left_mps = -side * 0.06;
        o.encoder_yaw_rate_radps = o.gyro_yaw_rate_radps = n < 400 ? -side * 0.4 : side * 0.4;
      },
      [=](Observation& o, Sample&, int n) {
        if (n > 1000) o.encoder_yaw_rate_radps = o.commanded_left_mps = -side * 0.5;
      },
      [=](Observation& o, Sample&, int) {
        o.left_mps = o.right_mps = 0.02;
        o.gyro_yaw_rate_radps = 0.2 * side;
        o.encoder_yaw_rate_radps = -0.15 * side;
      },
      [=](Observation& o, Sample&, int n) {
        o.left_mps = o.right_mps = side * 0.004;
        o.gyro_yaw_rate_radps = 0.1 * side;
        o.encoder_yaw_rate_radps = -0.2 * side * ramp(n);
      },
  };
}

TEST(MonitorTrace, EachConditionEndsARunInItsTime) {
  std::vector<std::string> columns = {"side", "case"};
  for (const char* what : {"first ", "steps of "}) {
    for (const Fault fault : kMonitored)
      columns.push_back(what + std::string(describe(fault).name));
  }
  test::GoldenTrace trace("control/monitor.csv", columns);
  Parameters strict;
  strict.max_cross_track_m = 0.1;
  strict.max_heading_error_rad = 0.7;
  strict.stall_s = 0.6;
  strict.disagreement_radps = 0.4;
  strict.disagreement_s = 0.5;
  strict.turn_slip_share = 0.02;
  strict.min_battery_v = 6.5;
  for (const double side : {1.0, -1.0}) {
    const auto all = corruptions(side);
    for (std::size_t i = 0; i < all.size(); ++i) {
      MonitoredTrace drive(i % 2 == 0 ? 0.07 : 0.13, i % 3 == 0 ? -0.3 : (side > 0.0 ? 0.2 : 0.01));
      std::vector<double> row = {side, static_cast<double>(i)};
      const std::vector<double> raised =
          side > 0.0
              ? drive.run(all[i], {}, kMeasured)
              : drive.run(all[i], strict, {.motor = kMeasured.motor, .identified = i % 4 != 0});
      row.insert(row.end(), raised.begin(), raised.end());
      trace.row(row);
    }
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(MonitorTrace, ATrackThatMissesDistanceIsNoticedInItsTime) {
  test::GoldenTrace trace("control/missing_distance.csv",
                          {"case", "left", "right", "turn", "steps_left", "steps_right"});
  test::Sequence any(41);
  for (int i = 0; i < 70; ++i) {
    const double mps = any.between(0.02, 0.16), radps = i % 4 == 0 ? 0.0 : any.between(-0.4, 0.4);
    const double pitch_rad = i % 3 == 0 ? any.between(-0.2, 0.2) : 0.0;
    const double counted = any.between(0.0, 0.75), gyro_radps = any.between(-0.25, 0.25);
    const bool gyro_in_use = i % 5 != 0, on_obstacle = i % 7 == 0, left = i % 2 == 0;
    const double direction = i % 6 == 0 ? -1.0 : 1.0, more_duty = any.between(0.0, 0.5);
    const std::vector<double> raised =
        MonitoredTrace(direction * mps, radps)
            .run(
                [&](Observation& o, Sample& s, int n) {
                  o.gyro_in_use = gyro_in_use;
                  o.on_obstacle = on_obstacle && n % 900 < 300;
                  o.pitch_rad = pitch_rad;
                  o.commanded_left_mps = o.commanded_right_mps = 0.0;
                  if (n < 250) return;
                  (left ? o.left_mps : o.right_mps) *= counted;
                  (left ? s.left_duty : s.right_duty) += direction * more_duty;
                  o.gyro_yaw_rate_radps += gyro_radps * std::sin(0.004 * n);
                },
                {}, kMeasured);
    trace.row({static_cast<double>(i), left ? raised[9] : 0.0, left ? 0.0 : raised[9], raised[10],
               left ? raised[20] : 0.0, left ? 0.0 : raised[20]});
  }
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::control
