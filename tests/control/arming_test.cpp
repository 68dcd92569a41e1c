#include "control/arming.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

namespace tp100::control {
namespace {

constexpr double kCycleS = 0.005;

class ArmingTest : public testing::Test {
 protected:
  /// Steps until something is requested, or `steps` have passed.
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
    sample_.state = RobotState::kDisarmed;
  }
  void begin(RunState to = RunState::kRunning) {
    connect();
    to == RunState::kDriving ? arming_.drive() : arming_.start();
    ASSERT_EQ(run(100), RobotRequest::kArm);
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

TEST_F(ArmingTest, NothingIsRequestedBeforeAStart) {
  connect();
  EXPECT_EQ(run(1000), RobotRequest::kNone);
  EXPECT_EQ(arming_.state(), RunState::kIdle);
}

TEST_F(ArmingTest, AStartThatCannotBeginWithin3SIsRefusedWithItsReason) {
  connect();
  in_.refusal = StartRefusal::kNotStill;
  arming_.start();
  EXPECT_EQ(run(599), RobotRequest::kNone);
  EXPECT_EQ(arming_.state(), RunState::kArming);
  EXPECT_EQ(run(5), RobotRequest::kNone);
  EXPECT_EQ(arming_.state(), RunState::kIdle);
  in_.refusal = StartRefusal::kNone;
  EXPECT_EQ(run(20000), RobotRequest::kNone) << "a refused start must not take effect later";
  EXPECT_EQ(arming_.faults(), 0u);
  arming_.start();
  EXPECT_EQ(run(100), RobotRequest::kArm);
}

TEST_F(ArmingTest, TheReasonOfARefusalIsSaidOnce) {
  connect();
  in_.refusal = StartRefusal::kNoWorld;
  arming_.start();
  int refusals = 0;
  for (int i = 0; i < 2000; ++i) {
    run(1);
    if (arming_.refused() == StartRefusal::kNoWorld) ++refusals;
  }
  EXPECT_EQ(refusals, 1);
}

TEST_F(ArmingTest, AStartWaitsThatLongForTheSession) {
  in_.refusal = StartRefusal::kNoSession;
  arming_.start();
  EXPECT_EQ(run(400), RobotRequest::kNone);
  connect();
  EXPECT_EQ(run(100), RobotRequest::kArm);
}

TEST_F(ArmingTest, AStartThatWaitsEndsWithItsSession) {
  struct {
    SessionState session;
    bool new_session, rebooted;
    Fault fault;
  } constexpr kEnds[] = {{SessionState::kClosed, false, false, Fault::link_lost},
                         {SessionState::kReady, true, false, Fault::link_lost},
                         {SessionState::kReady, false, true, Fault::robot_rebooted}};
  for (const auto& end : kEnds) {
    connect();
    in_.refusal = StartRefusal::kNotStill;
    arming_.start();
    ASSERT_EQ(run(10), RobotRequest::kNone);
    in_.session = end.session;
    in_.new_session = end.new_session;
    in_.rebooted = end.rebooted;
    EXPECT_EQ(run(1), RobotRequest::kDisarm);
    EXPECT_EQ(arming_.state(), RunState::kAborted);
    EXPECT_EQ(arming_.faults(), fault_bit(end.fault));
  }
}

TEST_F(ArmingTest, NothingBeginsBeforeTheArmIsAcknowledged) {
  connect();
  arming_.start();
  ASSERT_EQ(run(100), RobotRequest::kArm);
  sample_.state = RobotState::kArmed;
  EXPECT_EQ(run(30), RobotRequest::kNone);
  EXPECT_EQ(arming_.state(), RunState::kArming);
  in_.answer = RequestAnswer::kFailed;
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.state(), RunState::kAborted);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::not_acknowledged));
}

TEST_F(ArmingTest, AnAcknowledgementBeforeTheSampleThatShowsItCounts) {
  connect();
  arming_.start();
  ASSERT_EQ(run(100), RobotRequest::kArm);
  in_.answer = RequestAnswer::kAcknowledged;
  EXPECT_EQ(run(3), RobotRequest::kNone);
  EXPECT_EQ(arming_.state(), RunState::kArming);
  sample_.state = RobotState::kArmed;
  run(1);
  EXPECT_EQ(arming_.state(), RunState::kRunning);
}

TEST_F(ArmingTest, AnArmThatIsAcknowledgedAndChangesNothingIsGivenUp) {
  connect();
  arming_.start();
  ASSERT_EQ(run(100), RobotRequest::kArm);
  in_.answer = RequestAnswer::kAcknowledged;
  EXPECT_EQ(run(210), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::not_acknowledged));
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
  in_.answer = RequestAnswer::kFailed;
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
  EXPECT_FALSE(arming_.disarming()) << "no robot is connected that could confirm it";
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

TEST_F(ArmingTest, ARestartWhileItArmsEndsTheStartWithItsCause) {
  connect();
  arming_.start();
  ASSERT_EQ(run(100), RobotRequest::kArm);
  in_.rebooted = true;
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.state(), RunState::kAborted);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::robot_rebooted));
}

TEST_F(ArmingTest, AnAbortWhileItArmsEndsTheStartWithItsCause) {
  connect();
  arming_.start();
  ASSERT_EQ(run(100), RobotRequest::kArm);
  in_.aborts = fault_bit(Fault::world_lost);
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::world_lost));
}

TEST_F(ArmingTest, WhatTheMonitorFindsEndsTheRunWithItsCause) {
  begin();
  in_.aborts = fault_bit(Fault::stalled_right);
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.state(), RunState::kAborted);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::stalled_right));
}

TEST_F(ArmingTest, AFaultInASampleEndsTheRunWhateverItsStateAndName) {
  for (const FaultMask fault : {FaultMask{1}, fault_bit(Fault::stalled_left), FaultMask{1} << 15}) {
    SetUp();
    begin();
    sample_.faults = fault;
    EXPECT_EQ(run(1), RobotRequest::kDisarm);
    EXPECT_EQ(arming_.faults(), fault);
    sample_.faults = 0;
    confirm_off();
    run(1);
  }
}

TEST_F(ArmingTest, ARobotThatIsNoLongerArmedEndsTheRunWithoutAFaultOfItsOwn) {
  begin();
  sample_.state = RobotState::kDisarmed;
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::not_acknowledged));
}

TEST_F(ArmingTest, WithoutAFreshSampleTheRunEnds) {
  begin();
  in_.sample = nullptr;
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::link_lost));
}

TEST_F(ArmingTest, CompletionDisarms) {
  begin();
  in_.done = true;
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.state(), RunState::kFinished);
  EXPECT_TRUE(arming_.disarming());
  confirm_off();
  EXPECT_EQ(run(1000), RobotRequest::kNone);
  EXPECT_FALSE(arming_.disarming());
  EXPECT_EQ(arming_.state(), RunState::kFinished);
}

TEST_F(ArmingTest, ACompletionThatIsNotConfirmedIsNone) {
  // In turn: the disarm is not acknowledged; it is acknowledged, but the motors stay on; the link
  // breaks.
  for (int i = 0; i < 3; ++i) {
    begin();
    in_.done = true;
    ASSERT_EQ(run(1), RobotRequest::kDisarm);
    in_.done = false;
    if (i == 0) {
      sample_.state = RobotState::kDisarmed;
      in_.answer = RequestAnswer::kFailed;
    } else if (i == 1) {
      in_.answer = RequestAnswer::kAcknowledged;
    } else {
      in_.sample = nullptr;
    }
    run(1);
    in_.answer = RequestAnswer::kNone;
    run(51);
    EXPECT_EQ(arming_.state(), RunState::kAborted) << i;
    constexpr std::array kCauses{Fault::not_acknowledged, Fault::moves_unasked, Fault::link_lost};
    EXPECT_EQ(arming_.faults(), fault_bit(kCauses.at(static_cast<std::size_t>(i)))) << i;
    EXPECT_EQ(arming_.disarming(), i == 1) << "disarming lasts as long as the motors are on";
  }
}

TEST_F(ArmingTest, MotorsThatNobodyAskedForAreStoppedAgainAndAgain) {
  const auto armed = [](Sample& sample) { sample.state = RobotState::kArmed; };
  const auto running = [](Sample& sample) { sample.state = RobotState::kRunning; };
  const auto driven = [](Sample& sample) { sample.right_duty = -0.1; };
  for (const auto& oddity : {std::function<void(Sample&)>(armed), {running}, {driven}}) {
    arming_ = {};
    sample_ = {};
    connect();
    ASSERT_EQ(run(100), RobotRequest::kNone);
    oddity(sample_);
    EXPECT_EQ(run(10), RobotRequest::kNone) << "a single sample may be an old one";
    EXPECT_EQ(run(2), RobotRequest::kStop);
    EXPECT_EQ(arming_.state(), RunState::kAborted);
    EXPECT_EQ(arming_.faults(), fault_bit(Fault::moves_unasked));
    for (int again = 0; again < 5; ++again) {
      EXPECT_EQ(run(38), RobotRequest::kNone);
      EXPECT_EQ(run(4), RobotRequest::kStop);
    }
    sample_.state = RobotState::kFaulted;
    sample_.right_duty = 0.0;
    EXPECT_EQ(run(1000), RobotRequest::kNone);
    EXPECT_EQ(arming_.faults(), fault_bit(Fault::moves_unasked));
  }
}

TEST_F(ArmingTest, MotorsThatStayOnAfterARunAreStopped) {
  begin();
  in_.done = true;
  ASSERT_EQ(run(1), RobotRequest::kDisarm);
  in_.answer = RequestAnswer::kFailed;
  EXPECT_EQ(run(80), RobotRequest::kStop);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::not_acknowledged) | fault_bit(Fault::moves_unasked));
}

TEST_F(ArmingTest, AStartIsVoidIfTheMotorsAreOnBeforeItArms) {
  connect();
  in_.refusal = StartRefusal::kMotorsOn;
  sample_.state = RobotState::kRunning;
  arming_.start();
  EXPECT_EQ(run(30), RobotRequest::kStop);
  EXPECT_EQ(arming_.state(), RunState::kAborted);
}

TEST_F(ArmingTest, ARobotThatIsPushedByHandIsNoFault) {
  connect();
  for (int i = 0; i < 1000; ++i) {
    sample_.left_counts += 50;
    ASSERT_EQ(run(1), RobotRequest::kNone);
  }
  EXPECT_EQ(arming_.faults(), 0u);
}

TEST_F(ArmingTest, ARobotThatIsBeingDisarmedHasTimeToObey) {
  begin();
  arming_.hold();
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(run(30), RobotRequest::kNone);
  confirm_off();
  EXPECT_EQ(run(1000), RobotRequest::kNone);
  EXPECT_EQ(arming_.state(), RunState::kIdle);
  EXPECT_EQ(arming_.faults(), 0u);
}

TEST_F(ArmingTest, StopIsRequestedInEveryStateAndLatches) {
  arming_.stop();
  EXPECT_EQ(run(1), RobotRequest::kStop);
  begin();
  arming_.stop();
  EXPECT_EQ(run(1), RobotRequest::kStop);
  sample_.state = RobotState::kFaulted;
  EXPECT_EQ(run(1000), RobotRequest::kNone);
  EXPECT_EQ(arming_.state(), RunState::kAborted);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::stop_requested));
}

TEST_F(ArmingTest, DrivingByHandArmsLikeARunAndEndsIdle) {
  begin(RunState::kDriving);
  arming_.start();
  EXPECT_EQ(arming_.state(), RunState::kDriving) << "a start does not take over";
  in_.done = true;
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.state(), RunState::kIdle);
  EXPECT_EQ(arming_.faults(), 0u);
}

TEST_F(ArmingTest, ARunIsNotTurnedIntoADrive) {
  begin();
  arming_.drive();
  EXPECT_EQ(run(10), RobotRequest::kNone);
  EXPECT_EQ(arming_.state(), RunState::kRunning);
}

TEST_F(ArmingTest, ADriveIsAbortedByWhatAbortsARun) {
  begin(RunState::kDriving);
  in_.aborts = fault_bit(Fault::tilt);
  EXPECT_EQ(run(1), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.state(), RunState::kAborted);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::tilt));
}

}  // namespace
}  // namespace tp100::control
