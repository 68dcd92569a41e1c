#include "control/arming.h"

#include <gtest/gtest.h>

namespace tp100::control {
namespace {

constexpr double kDt = 0.005;

class ArmingTest : public testing::Test {
 protected:
  /// Steps until something is requested, or `steps` have passed.
  RobotRequest run(int steps) {
    for (int i = 0; i < steps; ++i) {
      const RobotRequest request = arming_.update(in_, kDt);
      in_.new_session = in_.rebooted = in_.request_refused = false;
      if (request != RobotRequest::kNone) return request;
    }
    return RobotRequest::kNone;
  }
  void connect() {
    in_.session = SessionState::kReady;
    in_.sample = &sample_;
    in_.ready_to_run = true;
    sample_.state = RobotState::kDisarmed;
  }
  void begin() {
    connect();
    arming_.start();
    ASSERT_EQ(run(100), RobotRequest::kArm);
    sample_.state = RobotState::kArmed;
    ASSERT_EQ(run(1), RobotRequest::kNone);
    ASSERT_TRUE(arming_.just_began());
    ASSERT_EQ(arming_.state(), RunState::kRunning);
  }

  Arming arming_;
  ArmingInputs in_{};
  Sample sample_{};
};

TEST_F(ArmingTest, NothingIsRequestedBeforeAStart) {
  connect();
  EXPECT_EQ(run(1000), RobotRequest::kNone);
  EXPECT_EQ(arming_.state(), RunState::kIdle);
}

TEST_F(ArmingTest, AStartBeforeTheSessionWaitsForIt) {
  arming_.start();
  EXPECT_EQ(run(1000), RobotRequest::kNone);
  connect();
  EXPECT_EQ(run(100), RobotRequest::kArm);
}

TEST_F(ArmingTest, ArmsOnceAndBeginsWhenTheRobotSaysSo) {
  begin();
  EXPECT_EQ(run(100), RobotRequest::kNone);
  EXPECT_FALSE(arming_.just_began());
}

TEST_F(ArmingTest, ARefusedArmAbortsAndDisarms) {
  connect();
  arming_.start();
  ASSERT_EQ(run(100), RobotRequest::kArm);
  in_.request_refused = true;
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.state(), RunState::kAborted);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::not_acknowledged));
}

TEST_F(ArmingTest, ALostSessionEndsTheRunAndItsReturnDoesNotRestartIt) {
  begin();
  in_.session = SessionState::kClosed;
  in_.sample = nullptr;
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::link_lost));
  connect();
  in_.new_session = true;
  EXPECT_EQ(run(1000), RobotRequest::kNone);
  EXPECT_EQ(arming_.state(), RunState::kAborted);
  arming_.start();
  EXPECT_EQ(run(100), RobotRequest::kArm);
  EXPECT_EQ(arming_.faults(), 0u);
}

TEST_F(ArmingTest, ASessionThatCameBackWithinOneStepEndsTheRunToo) {
  begin();
  in_.new_session = true;
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
}

TEST_F(ArmingTest, ARestartOfTheRobotIsNotALostLinkToo) {
  begin();
  in_.session = SessionState::kParameters;
  in_.rebooted = true;
  in_.sample = nullptr;
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::robot_rebooted));
}

TEST_F(ArmingTest, ARobotThatSwitchesItselfOffEndsTheRunWithItsOwnFault) {
  begin();
  sample_.state = RobotState::kFaulted;
  sample_.faults = fault_bit(Fault::stalled_left);
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::stalled_left));
}

TEST_F(ArmingTest, CompletionDisarms) {
  begin();
  in_.path_done = true;
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.state(), RunState::kFinished);
}

TEST_F(ArmingTest, StopIsRequestedInEveryStateAndLatches) {
  arming_.stop();
  EXPECT_EQ(run(1), RobotRequest::kStop);
  begin();
  arming_.stop();
  EXPECT_EQ(run(1), RobotRequest::kStop);
  EXPECT_EQ(run(1000), RobotRequest::kNone);
  EXPECT_EQ(arming_.state(), RunState::kAborted);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::stop_requested));
}

}  // namespace
}  // namespace tp100::control
