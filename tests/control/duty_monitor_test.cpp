// The monitor of the encoders by each track's duty, and the gain that it learns.

#include <gtest/gtest.h>

#include "control/monitor.h"
#include "monitored_run.h"

namespace tp100::control {
namespace {

TEST_F(EncoderMonitorTest, TheDutyTellsIfTheGyroIsNotInUse) {
  seen_.gyro_in_use = false;
  const double after_s = noticed_after(3.0, kDuty, [](Observation& o, Sample& s) {
    o.left_mps = o.commanded_left_mps = 0.0;
    s.left_duty = 0.47;
  });
  EXPECT_GT(after_s, 0.5);
  EXPECT_LT(after_s, 1.0);
}

TEST_F(EncoderMonitorTest, TheDutyTellsBackwardsToo) {
  seen_.gyro_in_use = false;
  drive(-0.0714);
  sample_.left_duty = sample_.right_duty = -(0.08 + 3.1 * 0.0714);
  const double after_s = noticed_after(3.0, kDuty, [](Observation& o, Sample& s) {
    o.left_mps = o.commanded_left_mps = 0.0;
    s.left_duty = -0.47;
  });
  EXPECT_GT(after_s, 0.5);
  EXPECT_LT(after_s, 1.0);
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

TEST_F(EncoderMonitorTest, AShareOfTheEdgesOfBothTracksIsMissedByTheirDuty) {
  const double after_s = noticed_after(5.0, kDuty, [](Observation&, Sample& s) {
    s.left_duty = s.right_duty = 0.08 + 3.1 * 0.0714 / 0.7;
  });
  EXPECT_GT(after_s, 0.5);
  EXPECT_LT(after_s, 3.0);
}

// Steering alternately loads one track and relieves the other: both gains become the mean.
TEST_F(EncoderMonitorTest, SmallTurnsOnAStraightTeachNoLowerGain) {
  const double usual = sample_.left_duty;
  for (int i = 0; i < 40; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    seen_.gyro_yaw_rate_radps = seen_.encoder_yaw_rate_radps = side * 0.02;
    sample_.left_duty = usual - side * 0.035;
    sample_.right_duty = usual + side * 0.035;
    EXPECT_EQ(run(0.5), 0u) << i;
  }
  seen_.gyro_yaw_rate_radps = seen_.encoder_yaw_rate_radps = 0.073;
  sample_.left_duty = usual - 0.15;
  sample_.right_duty = usual + 0.15;
  EXPECT_EQ(run(30.0), 0u);
}

TEST_F(EncoderMonitorTest, ARobotsFileMayBeOffByAThird) {
  for (const double factor : {0.6, 0.8, 1.3}) {
    for (const double track_mps : {0.036, 0.0714, 0.119, 0.2}) {
      monitor_.restart();
      drive(track_mps);
      sample_.left_duty = sample_.right_duty = 0.09 + factor * 3.4 * track_mps;
      EXPECT_EQ(run(30.0), 0u) << factor << " " << track_mps;
    }
  }
}

TEST_F(EncoderMonitorTest, ACreepTeachesNothingAboutTheSpeedsAfterIt) {
  seen_.gyro_in_use = false;
  drive(0.1087);
  EXPECT_EQ(run(5.0), 0u);
  drive(0.0222);
  sample_.left_duty = sample_.right_duty = 0.09 + 0.052;
  EXPECT_EQ(run(5.0), 0u);
  drive(0.16);
  sample_.left_duty = sample_.right_duty = 0.09 + 0.9 * 3.4 * 0.16;
  EXPECT_EQ(run(20.0), 0u);
}

// A track that spins freely needs less than the dead band of the robot's file: at 0.03 m/s this
// looks like a gain of 0.7.
TEST_F(EncoderMonitorTest, AGainLearntAtALowSpeedIsNotThatOfAHigherOne) {
  seen_.gyro_in_use = false;
  for (const double slow_mps : {0.03, 0.036, 0.05}) {
    for (const double fast_mps : {0.06, 0.1, 0.2}) {
      for (const double gain : {0.9, 1.0, 1.2}) {
        monitor_.restart();
        for (int i = 0; i < 3; ++i) {
          drive(slow_mps);
          sample_.left_duty = sample_.right_duty = 0.09 + gain * 3.4 * slow_mps - 0.03;
          EXPECT_EQ(run(5.0), 0u) << slow_mps;
          drive(fast_mps);
          sample_.left_duty = sample_.right_duty = 0.09 + gain * 3.4 * fast_mps;
          EXPECT_EQ(run(20.0), 0u) << slow_mps << " " << fast_mps << " " << gain;
        }
      }
    }
  }
}

TEST_F(EncoderMonitorTest, ABatteryMaySag) {
  for (int i = 0; i < 600; ++i) {
    drive(0.0714);
    sample_.left_duty = sample_.right_duty *= 0.8 + 0.3 * i / 600.0;
    EXPECT_EQ(run(1.0), 0u) << i;
  }
}

// While it is pushed, its speed rises but not its duty.
TEST_F(EncoderMonitorTest, ATrackThatIsPushedOnForAMomentTeachesNothing) {
  drive(0.1);
  sample_.left_duty = sample_.right_duty = 0.09 + 1.3 * 3.4 * 0.1;
  EXPECT_EQ(run(3.0), 0u);
  seen_.left_mps = seen_.right_mps = 0.18;
  EXPECT_EQ(run(0.25), 0u);
  seen_.left_mps = seen_.right_mps = 0.1;
  EXPECT_EQ(run(20.0), 0u);
}

TEST_F(EncoderMonitorTest, EdgesThatAreMissedOnlyAtAHigherSpeedAreNotTakenForItsGain) {
  drive(0.04);
  sample_.left_duty = sample_.right_duty = 0.09 + 0.9 * 3.4 * 0.04;
  const double after_s = noticed_after(10.0, kDuty, [](Observation& o, Sample& s) {
    o.left_mps = o.right_mps = 0.6 * 0.2;
    s.left_duty = s.right_duty = 0.09 + 0.9 * 3.4 * 0.2;
  });
  EXPECT_GT(after_s, 0.5);
}

}  // namespace
}  // namespace tp100::control
