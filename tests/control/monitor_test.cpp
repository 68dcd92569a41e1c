#include "control/monitor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "monitored_run.h"

namespace tp100::control {
namespace {

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
  const MotorModel motor{.dead_band = 0.09, .feed_forward = 3.4};
  for (const double side : {1.0, -1.0}) {
    monitor_ = Monitor{Parameters{}, course::Fence{-1.0, 1.0, -1.0, 1.0}, 20.0,
                       MonitoredRobot{.motor = motor, .identified = false}};
    seen_.gyro_yaw_rate_radps = side * 0.599;
    EXPECT_EQ(run(10.0), 0u);
    seen_.gyro_yaw_rate_radps = side * 0.601;
    EXPECT_EQ(run(10.0), kTurn);
    EXPECT_NEAR(lasted_s_, Parameters{}.disagreement_s, 0.011);
    seen_.gyro_in_use = false;
    EXPECT_EQ(run(10.0), 0u) << "on a stand the gyro shows nothing";
    seen_.gyro_in_use = true;
  }
}

// The yaw loop keeps the heading by the gyro: one track's target falls to zero, the other doubles.
TEST_F(EncoderMonitorTest, ADeadEncoderIsNoticedThoughTheYawLoopHidesIt) {
  const double after_s = noticed_after(3.0, kTurn, [](Observation& o, Sample& s) {
    o.left_mps = o.commanded_left_mps = 0.0;
    o.right_mps = o.commanded_right_mps = 0.143;
    o.encoder_yaw_rate_radps = 0.143 * 0.84 / 0.274;
    s.left_duty = s.right_duty = 0.47;
  });
  EXPECT_GT(after_s, 0.0);
  EXPECT_LT(after_s, 1.0);
}

TEST_F(EncoderMonitorTest, CountsThatNoTrackCanMakeEndTheRun) {
  monitor_ = Monitor{Parameters{}, course::Fence{-1.0, 1.0, -1.0, 1.0}, 20.0,
                     MonitoredRobot{.motor = {.dead_band = 0.09, .feed_forward = 3.4},
                                    .max_counts_per_s = 6000.0}};
  for (const bool restarted : {true, false}) {
    EXPECT_EQ(run(0.1), 0u);
    if (restarted) monitor_.restart();
    sample_.device_us += 5000;
    sample_.right_counts += 40;
    EXPECT_EQ(monitor_.update(seen_), restarted ? 0u : kDuty);
  }
}

TEST_F(EncoderMonitorTest, ATurnTheOtherWayEndsTheRunWithinTenDegreesWhateverItsRate) {
  for (const double radps : {0.3, 0.6, 1.2}) {
    monitor_.restart();
    drive(0.0);
    seen_.commanded_left_mps = -0.08;
    seen_.commanded_right_mps = 0.08;
    seen_.gyro_yaw_rate_radps = seen_.encoder_yaw_rate_radps = -radps;
    seen_.left_mps = 0.137 * radps;
    seen_.right_mps = -0.137 * radps;
    EXPECT_EQ(run(3.0), fault_bit(Fault::heading));
    EXPECT_LT(lasted_s_ * radps, 10.0 * kRadPerDeg);
  }
}

TEST_F(EncoderMonitorTest, ATurnThatHasStoppedExplainsNoTurnAgainstTheCommand) {
  const auto turn = [&](double commanded_mps, double radps) {
    seen_.commanded_right_mps = commanded_mps;
    seen_.commanded_left_mps = -commanded_mps;
    seen_.gyro_yaw_rate_radps = seen_.encoder_yaw_rate_radps = radps;
    seen_.right_mps = 0.137 * radps;
    seen_.left_mps = -seen_.right_mps;
  };
  for (const double side : {1.0, -1.0}) {
    monitor_.restart();
    drive(0.0);
    turn(side * 0.16, side * 1.2);
    EXPECT_EQ(run(0.5), 0u);
    turn(-side * 0.08, 0.0);
    EXPECT_EQ(run(0.05), 0u);
    turn(-side * 0.08, side * 0.6);
    EXPECT_EQ(run(3.0), fault_bit(Fault::heading));
    EXPECT_LT(lasted_s_ * 0.6, 10.0 * kRadPerDeg) << side;
  }
}

// Between two arcs in opposite directions, tracks at their limit need a quarter of a second.
TEST_F(EncoderMonitorTest, ATurnAtTheFullRateMayBeTurnedBack) {
  for (const double side : {1.0, -1.0}) {
    monitor_.restart();
    drive(0.0);
    double radps = 1.2;
    for (int i = 0; i < 400; ++i) {
      const bool back = i >= 200;
      if (back) radps = std::max(-1.2, radps - 4.0 * seen_.dt_s);
      seen_.commanded_right_mps = side * (back ? -0.16 : 0.16);
      seen_.commanded_left_mps = -seen_.commanded_right_mps;
      seen_.gyro_yaw_rate_radps = seen_.encoder_yaw_rate_radps = side * radps;
      seen_.right_mps = 0.137 * side * radps;
      seen_.left_mps = -seen_.right_mps;
      sample_.right_duty = 3.4 * seen_.right_mps;
      sample_.left_duty = -sample_.right_duty;
      ASSERT_EQ(monitor_.update(seen_), 0u) << i;
    }
  }
}

// With 300 counts/m a track at rest oscillates about one edge: the robot reacts to each count with
// duty of the other sign, and the speed, which lags, has the sign of the previous duty.
TEST_F(EncoderMonitorTest, ATrackThatSwingsAboutOneEdgeMissesNothing) {
  EXPECT_EQ(run(3.0), 0u);
  drive(0.0);
  for (int i = 0; i < 1200; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    for (const double lagging_mps : {-0.047, -0.041, -0.036, -0.032, 0.056}) {
      seen_.left_mps = seen_.right_mps = side * lagging_mps;
      sample_.left_duty = sample_.right_duty = side * 0.333;
      ASSERT_EQ(monitor_.update(seen_), 0u) << i;
    }
  }
}

TEST_F(EncoderMonitorTest, ARobotThatIsHeldForLessThanHalfASecondGoesOn) {
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

}  // namespace
}  // namespace tp100::control
