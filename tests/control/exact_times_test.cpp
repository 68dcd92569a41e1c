// Limits of times, to the nanosecond.

#include <gtest/gtest.h>

#include "control/arming.h"
#include "control/hand_drive.h"

namespace tp100::control {
namespace {

/// The speed that follows an input of this age. It may rise by 0.5 m/s in the step.
double speed_after_mps(HostNs age) {
  HandDrive drive(std::nullopt);
  drive.restart(kNsPerS);
  drive.take({kNsPerS, 0.1, 0.0}, kNsPerS);
  Parameters parameters;
  parameters.acceleration_mps2 = 50.0;
  return drive.update({}, parameters, kNsPerS + age, 0.01).speed_mps;
}

TEST(ExactTimes, AnInputCountsForAsLongAsItIsFresh) {
  EXPECT_EQ(speed_after_mps(0), 0.1);
  EXPECT_EQ(speed_after_mps(kFreshInputNs), 0.1);
  EXPECT_EQ(speed_after_mps(kFreshInputNs + 1), 0.0);
}

TEST(ExactTimes, ADriveIsSilentAfterMoreThanTheSilence) {
  HandDrive drive(std::nullopt);
  drive.restart(kNsPerS);
  EXPECT_FALSE(drive.silent(kNsPerS + HandDrive::kSilenceNs));
  EXPECT_TRUE(drive.silent(kNsPerS + HandDrive::kSilenceNs + 1));
}

TEST(ExactTimes, OfTwoInputsOfTheSameTimeTheLaterOneCounts) {
  HandDrive drive(std::nullopt);
  drive.restart(kNsPerS);
  drive.take({kNsPerS, -0.1, 0.0}, kNsPerS);
  drive.take({kNsPerS, 0.1, 0.0}, kNsPerS);
  EXPECT_GT(drive.update({}, {}, kNsPerS, 0.01).speed_mps, 0.0);
}

TEST(ExactTimes, MotorsThatNobodyAskedForAreStoppedAfterFiftyMilliseconds) {
  Arming arming;
  Sample sample;
  sample.state = RobotState::kArmed;
  sample.measured_ns = 7 * kNsPerS;
  ArmingInputs in;
  in.session = SessionState::kReady;
  in.sample = &sample;
  EXPECT_EQ(arming.update(in, 0.005), RobotRequest::kNone);
  sample.measured_ns += 50 * kNsPerMs - 1;
  EXPECT_EQ(arming.update(in, 0.005), RobotRequest::kNone);
  sample.measured_ns += 1;
  EXPECT_EQ(arming.update(in, 0.005), RobotRequest::kStop);
}

}  // namespace
}  // namespace tp100::control
