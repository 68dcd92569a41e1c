#include "control/monitor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "monitored_run.h"

namespace tp100::control {
namespace {

struct Case {
  const char* name;
  Fault fault;
  double after_s;  ///< must not abort earlier than this
  std::function<void(Observation&, Sample&)> corrupt;
};

class MonitorTest : public MonitoredRun, public testing::WithParamInterface<Case> {};

TEST_P(MonitorTest, AHealthyRunGoesOnAndTheCorruptedOneEndsWithItsOwnCause) {
  EXPECT_EQ(run(10.0), 0u);
  GetParam().corrupt(seen_, sample_);
  EXPECT_EQ(run(10.0), fault_bit(GetParam().fault));
  EXPECT_GE(lasted_s_, GetParam().after_s - 0.02);
}

INSTANTIATE_TEST_SUITE_P(
    EveryAbort, MonitorTest,
    testing::Values(Case{"CrossTrack", Fault::cross_track, 0.0,
                         [](Observation& o, Sample&) { o.target.off_path_m = 0.21; }},
                    Case{"Heading", Fault::heading, 0.5,
                         [](Observation& o, Sample&) { o.target.heading_error_rad = 1.2; }},
                    Case{"Tilt", Fault::tilt, 0.3,
                         [](Observation&, Sample& s) {
                           s.accel_mps2 = {9.0, 0.0, 3.0};
                         }},
                    Case{"Fence", Fault::fence, 0.0,
                         [](Observation& o, Sample&) { o.pose.y_m = 1.01; }},
                    Case{"KeepOut", Fault::fence, 0.0,
                         [](Observation& o, Sample&) { o.pose.x_m = o.pose.y_m = 0.6; }},
                    Case{"CommandsNotTaken", Fault::command_timeout, 0.3,
                         [](Observation& o, Sample&) { o.commanded = true; }},
                    Case{"TimeLimit", Fault::time_limit, 0.0,
                         [](Observation& o, Sample&) { o.elapsed_s = 60.1; }},
                    Case{"StalledTrack", Fault::stalled_track, 1.0,
                         [](Observation& o, Sample&) { o.commanded_right_mps = 0.1; }},
                    Case{"LowBattery", Fault::battery_below_minimum, 2.0,
                         [](Observation&, Sample& s) { s.battery_v = 6.0; }},
                    Case{"EncodersAgainstDuty", Fault::encoders_against_duty, 0.5,
                         [](Observation& o, Sample& s) {
                           s.left_duty = 0.5;
                           o.left_mps = -0.05;
                         }},
                    Case{"GyroAgainstEncoders", Fault::gyro_against_encoders, 0.3,
                         [](Observation& o, Sample&) {
                           o.gyro_yaw_rate_radps = -0.4;
                           o.encoder_yaw_rate_radps = 0.4;
                         }}),
    [](const testing::TestParamInfo<Case>& param) { return param.param.name; });

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

TEST_F(EncoderMonitorTest, ThirtyDegreesASecondAreQuestionedWithinTwentyDegrees) {
  for (const double sign : {1.0, -1.0}) {
    monitor_.restart();
    seen_.gyro_yaw_rate_radps = 0.0;
    const double after_s = noticed_after(3.0, kTurn, [sign](Observation& o, Sample&) {
      o.gyro_yaw_rate_radps = sign * 30.0 * kRadPerDeg;
    });
    EXPECT_GT(after_s, 0.0);
    EXPECT_LT(after_s * 30.0, 20.0);
  }
}

TEST_F(EncoderMonitorTest, CountsThatNoTrackCanMakeEndTheRun) {
  monitor_ = Monitor{Parameters{}, course::Fence{-1.0, 1.0, -1.0, 1.0}, 20.0,
                     MonitoredRobot{.motor = {.dead_band = 0.09, .feed_forward = 3.4},
                                    .max_counts_per_s = 6000.0}};
  const auto drive_on = [&](int samples, std::int64_t counts) {
    for (int i = 0; i < samples; ++i) {
      sample_.device_us += 5000;
      sample_.left_counts += counts;
      sample_.right_counts += counts;
      EXPECT_EQ(monitor_.update(seen_), 0u);
      EXPECT_EQ(monitor_.update(seen_), 0u) << "there was no new sample";
    }
  };
  for (const std::int64_t jump : {40, -40}) {
    monitor_.restart();
    drive_on(100, 7);
    drive_on(3, 30);
    sample_.device_us += 50000;
    sample_.left_counts += 300;
    EXPECT_EQ(monitor_.update(seen_), 0u) << "the counts come after a gap";
    sample_.device_us += 5000;
    sample_.right_counts += jump;
    EXPECT_EQ(monitor_.update(seen_), kDuty);
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

TEST_F(EncoderMonitorTest, ATurnThatIsTurnedBackRunsOnForAMoment) {
  sample_.left_duty = sample_.right_duty = 0.0;
  for (int i = 0; i < 20; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    seen_.commanded_left_mps = -0.08 * side;
    seen_.commanded_right_mps = 0.08 * side;
    for (const double radps : {-0.6, 0.6}) {
      seen_.gyro_yaw_rate_radps = seen_.encoder_yaw_rate_radps = side * radps;
      seen_.right_mps = 0.137 * side * radps;
      seen_.left_mps = -seen_.right_mps;
      EXPECT_EQ(run(radps < 0.0 ? 0.12 : 1.0), 0u) << i;
    }
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

TEST_F(EncoderMonitorTest, APushIsNone) {
  EXPECT_EQ(run(3.0), 0u);
  seen_.gyro_yaw_rate_radps = 15.0 * kRadPerDeg / 0.3;
  EXPECT_EQ(run(0.3), 0u);
  seen_.gyro_yaw_rate_radps = 0.0;
  EXPECT_EQ(run(10.0), 0u);
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

TEST_F(EncoderMonitorTest, LoadIsNoFault) {
  EXPECT_EQ(run(3.0), 0u);
  // The robot turns on the spot, and its tracks scrub.
  seen_.left_mps = -0.08;
  seen_.right_mps = 0.08;
  seen_.gyro_yaw_rate_radps = seen_.encoder_yaw_rate_radps = 0.6;
  sample_.right_duty = 0.08 + 3.1 * 0.08 + 0.25;
  sample_.left_duty = -sample_.right_duty;
  EXPECT_EQ(run(10.0), 0u);
  drive(0.0714);
  seen_.gyro_yaw_rate_radps = seen_.encoder_yaw_rate_radps = 0.0;
  EXPECT_EQ(run(3.0), 0u);
  // The robot climbs a slope of 20 deg, then a real block.
  seen_.pitch_rad = 20.0 * kRadPerDeg;
  sample_.left_duty = sample_.right_duty += 0.13;
  EXPECT_EQ(run(10.0), 0u);
  drive(0.0714);
  seen_.pitch_rad = 0.0;
  seen_.on_obstacle = true;
  sample_.left_duty = sample_.right_duty += 0.33;
  EXPECT_EQ(run(10.0), 0u);
}

// The resistance against turning falls slowly with the radius (Nikitin's formula); on soft tracks
// wide arcs take a third of the duty of the spot.
TEST_F(EncoderMonitorTest, TheResistanceOfAnArcIsNoFault) {
  constexpr double kOnTheSpotDuty = 0.36, kGaugeM = 0.155, kWheelbaseM = 0.274;
  for (const double mps : {0.05, 0.1, 0.15}) {
    for (const double radius_m : {0.4, 0.8, 1.2, 1.6, 2.4, 4.0}) {
      monitor_.restart();
      seen_.gyro_yaw_rate_radps = seen_.encoder_yaw_rate_radps = 0.0;
      drive(mps);
      EXPECT_EQ(run(3.0), 0u);
      const double rate_radps = mps / radius_m;
      const double scrub_duty = kOnTheSpotDuty / (0.925 + 0.15 * radius_m / kGaugeM);
      seen_.gyro_yaw_rate_radps = seen_.encoder_yaw_rate_radps = rate_radps;
      seen_.left_mps = seen_.commanded_left_mps = mps - rate_radps * kWheelbaseM / 2.0;
      seen_.right_mps = seen_.commanded_right_mps = mps + rate_radps * kWheelbaseM / 2.0;
      sample_.left_duty = 0.08 + 3.1 * seen_.left_mps - scrub_duty;
      sample_.right_duty = 0.08 + 3.1 * seen_.right_mps + scrub_duty;
      EXPECT_EQ(run(20.0), 0u) << mps << " m/s, radius " << radius_m << " m";
    }
  }
}

}  // namespace
}  // namespace tp100::control
