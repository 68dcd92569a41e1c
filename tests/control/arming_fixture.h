#pragma once
// Arming with a robot whose samples and answers the tests set.

#include <gtest/gtest.h>

#include "control/arming.h"

namespace tp100::control {

inline constexpr double kCycleS = 0.005;

class ArmingTest : public testing::Test {
 protected:
  /// Steps until something is requested, or `steps` have passed. Each step has a newer sample.
  RobotRequest run(int steps) {
    for (int i = 0; i < steps; ++i) {
      const RobotRequest request = arming_.update(in_, kCycleS);
      in_.new_session = in_.rebooted = false;
      in_.answer = RequestAnswer::kNone;
      sample_.measured_ns += 5 * kNsPerMs;
      if (request != RobotRequest::kNone) return request;
    }
    return RobotRequest::kNone;
  }
  void connect() {
    in_.session = SessionState::kReady;
    in_.sample = &sample_;
    in_.refusal = StartRefusal::kNone;
    in_.aborts = 0;
    in_.done = false;
    sample_.state = RobotState::kDisarmed;
    sample_.faults = 0;
  }
  void request_arm(RunState to = RunState::kRunning) {
    connect();
    to == RunState::kDriving ? arming_.drive() : arming_.start();
    ASSERT_EQ(run(100), RobotRequest::kArm);
  }
  void begin(RunState to = RunState::kRunning) {
    request_arm(to);
    sample_.state = RobotState::kArmed;
    in_.answer = RequestAnswer::kAcknowledged;
    ASSERT_EQ(run(1), RobotRequest::kNone);
    ASSERT_TRUE(arming_.just_began());
    ASSERT_EQ(arming_.state(), to);
  }
  /// The robot has obeyed the disarm and confirms it.
  void confirm_off() {
    sample_.state = RobotState::kDisarmed;
    in_.answer = RequestAnswer::kAcknowledged;
  }

  Arming arming_;
  ArmingInputs in_{};
  Sample sample_{};
};

}  // namespace tp100::control
