// The monitors of a run, together and each by itself.

#include "control/monitor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "lagging_robot.h"
#include "support/sequence.h"

namespace tp100::control {
namespace {

/// A run or drive whose sensor values the tests set: at rest, with healthy sensors.
class MonitoredRun : public testing::Test {
 protected:
  MonitoredRun() {
    sample_.imu_age = 0;
    sample_.accel_mps2 = {0.0, 0.0, 9.81};
    sample_.battery_v = 7.4;
    seen_.sample = &sample_;
    seen_.gyro_in_use = true;
    seen_.dt_s = 0.005;
  }
  /// In a fence of 2 m by 2 m with an area to keep out of.
  static Monitor monitor_of(MonitoredRobot robot) {
    robot.motor = {.dead_band = 0.09, .feed_forward = 3.4};
    const course::Polygon area{{0.5, 0.5}, {0.9, 0.5}, {0.5, 0.9}};
    return {Parameters{}, {-1.0, 1.0, -1.0, 1.0, {}, {area}}, 20.0, robot};
  }
  FaultMask run(double duration_s) {
    FaultMask faults = 0;
    for (double t = 0; t < duration_s && faults == 0; t += seen_.dt_s) {
      faults = monitor_.update(seen_);
      lasted_s_ = t;
    }
    return faults;
  }
  /// Straight on, with consistent sensor values.
  void drive(double track_mps) {
    seen_.left_mps = seen_.right_mps = seen_.commanded_left_mps = seen_.commanded_right_mps =
        track_mps;
    sample_.left_duty = sample_.right_duty = 0.08 + 3.1 * track_mps;
  }
  /// On the spot: the command, and what the robot does.
  void turn(double commanded_mps, double radps) {
    seen_.commanded_right_mps = commanded_mps;
    seen_.commanded_left_mps = -commanded_mps;
    seen_.gyro_yaw_rate_radps = seen_.encoder_yaw_rate_radps = radps;
    seen_.right_mps = 0.137 * radps;
    seen_.left_mps = -seen_.right_mps;
    sample_.right_duty = 3.4 * seen_.right_mps;
    sample_.left_duty = -sample_.right_duty;
  }

  Sample sample_{};
  Observation seen_{};
  double lasted_s_ = 0.0;
  Monitor monitor_ = monitor_of({});
};

/// A condition that ends a run. `apply` makes a value `share` times the one from which on it holds.
struct Case {
  const char* name;
  Fault fault;
  double after_s;  ///< that it must last
  std::function<void(Observation&, Sample&, double share)> apply;
};

class MonitorTest : public MonitoredRun, public testing::WithParamInterface<Case> {};

TEST_P(MonitorTest, ARunGoesOnUpToTheLimitAndEndsBeyondItInItsTimeWithItsOwnCause) {
  const Case& of = GetParam();
  EXPECT_EQ(run(10.0), 0u);
  of.apply(seen_, sample_, 0.999);
  EXPECT_EQ(run(10.0), 0u);
  of.apply(seen_, sample_, 1.001);
  EXPECT_EQ(run(of.after_s - 0.02), 0u);
  monitor_.restart();
  EXPECT_EQ(run(of.after_s - 0.02), 0u) << "the run before does not count";
  of.apply(seen_, sample_, 0.999);
  EXPECT_EQ(run(0.01), 0u);
  of.apply(seen_, sample_, 1.001);
  EXPECT_EQ(run(10.0), fault_bit(of.fault));
  EXPECT_NEAR(lasted_s_, of.after_s, 0.011);
}

INSTANTIATE_TEST_SUITE_P(
    EveryAbort, MonitorTest,
    testing::Values(
        Case{"CrossTrack", Fault::cross_track, 0.0,
             [](Observation& o, Sample&, double x) { o.target.off_path_m = 0.2 * x; }},
        Case{"Heading", Fault::heading, 0.5,
             [](Observation& o, Sample&, double x) { o.target.heading_error_rad = -kPi / 3 * x; }},
        Case{"Tilt", Fault::tilt, 0.3,
             [](Observation&, Sample& s, double x) {
               const double a = 50.0 * kRadPerDeg * x;
               s.accel_mps2 = {6.0 * std::sin(a), 8.0 * std::sin(a), 10.0 * std::cos(a)};
             }},
        Case{"Fence", Fault::fence, 0.0, [](Observation& o, Sample&, double x) { o.pose.y_m = x; }},
        Case{"KeepOut", Fault::fence, 0.0,
             [](Observation& o, Sample&, double x) {
               o.pose.x_m = 0.5 * x;
               o.pose.y_m = 0.6;
             }},
        Case{"CommandsNotTaken", Fault::command_timeout, 0.3,
             [](Observation& o, Sample&, double x) { o.commanded = x > 1.0; }},
        Case{"TimeLimit", Fault::time_limit, 0.0,
             [](Observation& o, Sample&, double x) { o.elapsed_s = 60.0 * x; }},
        Case{"StalledLeft", Fault::stalled_track, 1.0,
             [](Observation& o, Sample&, double x) { o.commanded_left_mps = -0.03 * x; }},
        Case{"StalledRight", Fault::stalled_track, 1.0,
             [](Observation& o, Sample&, double x) {
               o.commanded_right_mps = 0.1;
               o.right_mps = -0.003 / x;
             }},
        Case{"LowBattery", Fault::battery_below_minimum, 2.0,
             [](Observation&, Sample& s, double x) { s.battery_v = 6.2 / x; }},
        Case{"LeftAgainstDuty", Fault::encoders_against_duty, 0.5,
             [](Observation& o, Sample& s, double x) {
               o.on_obstacle = true;  // explains the duty by itself
               s.left_duty = 0.3 * x;
               o.left_mps = -0.05;
             }},
        Case{"RightAgainstDuty", Fault::encoders_against_duty, 0.5,
             [](Observation& o, Sample& s, double x) {
               o.on_obstacle = true;
               s.right_duty = -0.4;
               o.right_mps = 0.02 * x;
             }},
        Case{"Immobilised", Fault::immobilised, 0.0,
             [](Observation& o, Sample&, double x) { o.immobilised = x > 1.0; }}),
    [](const testing::TestParamInfo<Case>& param) { return param.param.name; });

TEST_F(MonitoredRun, AStaleImuShowsNoTilt) {
  sample_.accel_mps2 = {9.0, 0.0, 3.0};
  sample_.imu_age = 1;
  EXPECT_EQ(run(5.0), 0u);
}

TEST_F(MonitoredRun, ADriveByHandHasNoPathFenceOrTimeLimit) {
  seen_.by_hand = true;
  seen_.pose.x_m = 5.0;
  seen_.target.off_path_m = seen_.elapsed_s = 100.0;
  seen_.target.heading_error_rad = 2.0;
  EXPECT_EQ(run(5.0), 0u);
}

TEST_F(MonitoredRun, CommandsThatAreTakenOrNotSentAreNoFault) {
  for (int i = 0; i < 400; ++i) {
    seen_.commanded = i % 100 < 50;
    if (i % 40 == 0) ++sample_.last_command;
    ASSERT_EQ(monitor_.update(seen_), 0u) << i;
  }
}

// Before a robot is identified, its tracks may turn it otherwise than its file says.
TEST_F(MonitoredRun, GyroAndEncodersOfARobotThatIsNotIdentifiedMayDifferByALittle) {
  for (const double side : {1.0, -1.0}) {
    monitor_ = monitor_of({.identified = false});
    seen_.gyro_yaw_rate_radps = side * 0.599;
    EXPECT_EQ(run(10.0), 0u);
    seen_.gyro_yaw_rate_radps = side * 0.601;
    EXPECT_EQ(run(10.0), fault_bit(Fault::gyro_against_encoders));
    EXPECT_NEAR(lasted_s_, Parameters{}.disagreement_s, 0.011);
    seen_.gyro_in_use = false;
    EXPECT_EQ(run(10.0), 0u) << "on a stand the gyro shows nothing";
    seen_.gyro_in_use = true;
  }
}

// The yaw loop keeps the heading by the gyro: one track's target falls to zero, the other doubles.
TEST_F(MonitoredRun, ADeadEncoderIsNoticedThoughTheYawLoopHidesIt) {
  drive(0.0714);
  EXPECT_EQ(run(3.0), 0u);
  seen_.left_mps = seen_.commanded_left_mps = 0.0;
  seen_.right_mps = seen_.commanded_right_mps = 0.143;
  seen_.encoder_yaw_rate_radps = 0.143 * 0.84 / 0.274;
  sample_.left_duty = sample_.right_duty = 0.47;
  EXPECT_EQ(run(1.0), fault_bit(Fault::gyro_against_encoders));
}

TEST_F(MonitoredRun, CountsThatNoTrackCanMakeEndTheRun) {
  monitor_ = monitor_of({.max_counts_per_s = 6000.0});
  for (const bool restarted : {true, false}) {
    EXPECT_EQ(run(0.1), 0u);
    if (restarted) monitor_.restart();
    sample_.device_us += 5000;
    sample_.right_counts += 40;
    EXPECT_EQ(monitor_.update(seen_), restarted ? 0u : fault_bit(Fault::encoders_against_duty));
  }
}

// A turn that was there before may go on for a moment, but not begin again.
TEST_F(MonitoredRun, ATurnTheOtherWayEndsTheRunWithinTenDegreesWhateverItsRate) {
  for (const double side : {1.0, -1.0}) {
    for (const double radps : {0.3, 0.6, 1.2}) {
      monitor_.restart();
      turn(side * 0.16, side * 1.2);
      EXPECT_EQ(run(0.5), 0u);
      turn(-side * 0.08, 0.0);
      EXPECT_EQ(run(0.05), 0u);
      turn(-side * 0.08, side * radps);
      EXPECT_EQ(run(3.0), fault_bit(Fault::heading));
      EXPECT_LT(lasted_s_ * radps, 10.0 * kRadPerDeg) << side << ' ' << radps;
    }
  }
}

// Between two arcs in opposite directions, tracks at their limit need a quarter of a second.
TEST_F(MonitoredRun, ATurnAtTheFullRateMayBeTurnedBack) {
  for (const double side : {1.0, -1.0}) {
    monitor_.restart();
    turn(side * 0.16, side * 1.2);
    EXPECT_EQ(run(1.0), 0u);
    for (double radps = 1.2; radps > -1.2; radps -= 4.0 * seen_.dt_s) {
      turn(-side * 0.16, side * radps);
      ASSERT_EQ(monitor_.update(seen_), 0u) << radps;
    }
  }
}

TEST_F(MonitoredRun, ARobotThatIsHeldForLessThanHalfASecondGoesOn) {
  for (const double track_mps : {0.036, 0.0714, 0.119, 0.2}) {
    monitor_.restart();
    drive(track_mps);
    EXPECT_EQ(run(3.0), 0u);
    seen_.left_mps = seen_.right_mps = 0.0;
    sample_.left_duty = sample_.right_duty = 1.0;
    EXPECT_EQ(run(0.49), 0u) << track_mps;
    // The robot accelerates again and makes up the lag.
    for (int i = 1; i <= 10; ++i) {
      seen_.left_mps = seen_.right_mps = 0.28 * (1.0 - std::exp(-0.01 * i / 0.08));
      EXPECT_EQ(run(0.01), 0u) << track_mps;
    }
    drive(track_mps);
    EXPECT_EQ(run(5.0), 0u);
  }
}

constexpr MotorModel kMotor{.dead_band = 0.1, .feed_forward = 4.0};

// Else a slope or an obstacle would be taken for a blocked track. The duty above the dead band, a
// margin of 2 % and the load is 1/4 m/s for each unit.
TEST(DutyMonitor, ALoadExplainsTheDutyThatItTakes) {
  const auto reported_after_s = [](double beyond, const Load& load) {
    DutyMonitor monitor(kMotor);
    double after_s = kDt;
    while (after_s < 5.0 && !monitor.update(0.12 + beyond, 0.0, load, kDt)) after_s += kDt;
    return after_s;
  };
  for (const auto& [load, duty] : {std::pair{Load{}, 0.0},
                                   {Load{.turning = 0.4}, 0.4},
                                   {Load{.pitch_rad = 0.1}, 0.08},
                                   {Load{.pitch_rad = -0.1}, 0.08},
                                   {Load{.on_obstacle = true}, 0.4}}) {
    EXPECT_GE(reported_after_s(duty - 0.01, load), 5.0) << duty;
    EXPECT_NEAR(reported_after_s(duty + 0.1, load), 0.04 / (0.1 / 4.0), 0.05) << duty;
  }
  DutyMonitor monitor(kMotor);
  monitor.update(0.5, 0.0, {.on_obstacle = true}, kDt);
  double after_s = 0.0;
  while (after_s < 5.0 && !monitor.update(0.5, 0.0, {}, kDt)) after_s += kDt;
  EXPECT_NEAR(after_s, 1.0 + 0.7, 0.05) << "an obstacle is forgotten after a second";
}

TEST(JumpMonitor, CountsOfEitherTrackGrowAsFastAsATrackCanAndNoFaster) {
  const auto jumped = [](double max_per_s, int left, int right, bool restart = false) {
    JumpMonitor monitor(max_per_s);
    Sample sample;
    sample.device_us = 123456;
    sample.left_counts = 777;
    sample.right_counts = -555;
    EXPECT_FALSE(monitor.update(sample)) << "nothing is known before";
    EXPECT_FALSE(monitor.update(sample)) << "the same sample again";
    if (restart) monitor.restart();
    sample.device_us += 5000;
    sample.left_counts += left;
    sample.right_counts += right;
    const bool result = monitor.update(sample);
    EXPECT_FALSE(monitor.update(sample)) << "counts go on from there";
    return result;
  };
  for (const int side : {1, -1}) {
    EXPECT_FALSE(jumped(6000.0, side * 34, -side * 34)) << "30 in 5 ms, and 4 edges of slack";
    EXPECT_TRUE(jumped(6000.0, side * 35, 0));
    EXPECT_TRUE(jumped(6000.0, 0, side * 35));
    EXPECT_FALSE(jumped(6000.0, side * 500, 0, true));
    EXPECT_FALSE(jumped(0.0, side * 500, 0)) << "no limit is known";
  }
}

}  // namespace
}  // namespace tp100::control
