#include "control/arming.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "arming_fixture.h"

namespace tp100::control {
namespace {

TEST_F(ArmingTest, AStartArmsOnceSomeCommandsAreOnTheWayAndBeginsWhenAnswerAndSampleSaySo) {
  for (const bool answered_first : {true, false}) {
    arming_ = {};
    connect();
    arming_.start();
    EXPECT_EQ(run(9), RobotRequest::kNone) << "the robot needs a fresh command before it arms";
    EXPECT_EQ(run(2), RobotRequest::kArm);
    const auto answer = [this] { in_.answer = RequestAnswer::kAcknowledged; };
    const auto show = [this] { sample_.state = RobotState::kArmed; };
    answered_first ? answer() : show();
    EXPECT_EQ(run(30), RobotRequest::kNone);
    EXPECT_EQ(arming_.state(), RunState::kArming) << "another host may have armed it";
    answered_first ? show() : answer();
    EXPECT_EQ(run(1), RobotRequest::kNone);
    EXPECT_EQ(arming_.state(), RunState::kRunning);
    EXPECT_TRUE(arming_.just_began());
    EXPECT_EQ(run(100), RobotRequest::kNone);
    EXPECT_FALSE(arming_.just_began());
  }
}

TEST_F(ArmingTest, AStartThatCannotBeginWithin3SIsRefusedOnceWithItsReason) {
  connect();
  in_.refusal = StartRefusal::kNotStill;
  arming_.start();
  int refusals = 0, steps = 0;
  for (; arming_.state() == RunState::kArming && steps < 2000; ++steps) {
    EXPECT_EQ(run(1), RobotRequest::kNone);
    if (arming_.refused() == StartRefusal::kNotStill) ++refusals;
  }
  EXPECT_NEAR(steps * kCycleS, 3.0, 2 * kCycleS);
  EXPECT_EQ(arming_.state(), RunState::kIdle);
  run(1);
  EXPECT_EQ(arming_.refused(), StartRefusal::kNone);
  EXPECT_EQ(refusals, 1);
  in_.refusal = StartRefusal::kNone;
  EXPECT_EQ(run(2000), RobotRequest::kNone) << "a refused start must not take effect later";
  EXPECT_EQ(arming_.faults(), 0u);
  request_arm();
}

TEST_F(ArmingTest, AReasonThatPassesWithinThatTimeDelaysTheStart) {
  connect();
  in_.refusal = StartRefusal::kNotStill;
  arming_.start();
  for (int i = 0; i < 40; ++i) {
    // The commands that the robot needs first are counted anew.
    in_.refusal = i % 2 == 0 ? StartRefusal::kNotStill : StartRefusal::kNone;
    ASSERT_EQ(run(i % 2 == 0 ? 5 : 8), RobotRequest::kNone);
  }
  EXPECT_EQ(run(100), RobotRequest::kArm);
}

TEST_F(ArmingTest, AStartWaitsForASessionThoughAnEarlierStartHadOne) {
  connect();
  in_.refusal = StartRefusal::kNotStill;
  arming_.start();
  run(1);
  arming_.hold();
  ASSERT_EQ(run(1), RobotRequest::kDisarm);
  in_.session = SessionState::kSyncing;
  run(1);
  arming_.start();
  EXPECT_EQ(run(400), RobotRequest::kNone);
  EXPECT_EQ(arming_.state(), RunState::kArming);
  connect();
  EXPECT_EQ(run(100), RobotRequest::kArm);
}

/// Something that happens to a run, a drive or a start, and the fault that it is.
struct Cause {
  const char* name;
  Fault fault;
  std::function<void(ArmingInputs&, Sample&)> happen;
  bool robot_is_there = true;  ///< that can confirm that its motors are off
};

const std::vector<Cause>& causes_of_any_end() {
  static const std::vector<Cause> causes = {
      {"session lost", Fault::link_lost,
       [](ArmingInputs& in, Sample&) { in.session = SessionState::kClosed; }, false},
      {"session lost and back", Fault::link_lost,
       [](ArmingInputs& in, Sample&) { in.new_session = true; }, false},
      {"no fresh sample", Fault::link_lost, [](ArmingInputs& in, Sample&) { in.sample = nullptr; },
       false},
      {"reboot", Fault::robot_rebooted, [](ArmingInputs& in, Sample&) { in.rebooted = true; },
       false},
      {"reboot that closes the session", Fault::robot_rebooted,
       [](ArmingInputs& in, Sample&) {
         in.rebooted = true;
         in.session = SessionState::kParameters;
       },
       false},
      {"the monitor's fault", Fault::tilt,
       [](ArmingInputs& in, Sample&) { in.aborts = fault_bit(Fault::tilt); }},
      {"a stale sample that the monitor reports", Fault::imu_stale,
       [](ArmingInputs& in, Sample&) {
         in.aborts = fault_bit(Fault::imu_stale);
         in.sample = nullptr;
       },
       false}};
  return causes;
}

TEST_F(ArmingTest, WhatEndsARunOrADriveIsItsFaultAndDisarms) {
  std::vector<Cause> causes = causes_of_any_end();
  causes.push_back({"the robot's fault", Fault::stalled_left, [](ArmingInputs&, Sample& sample) {
                      sample.state = RobotState::kFaulted;
                      sample.faults = fault_bit(Fault::stalled_left);
                    }});
  causes.push_back({"a fault of an armed robot that nobody knows", Fault{15},
                    [](ArmingInputs&, Sample& sample) { sample.faults = FaultMask{1} << 15; }});
  causes.push_back({"switched itself off", Fault::not_acknowledged,
                    [](ArmingInputs&, Sample& sample) { sample.state = RobotState::kDisarmed; }});
  for (const RunState to : {RunState::kRunning, RunState::kDriving}) {
    for (const Cause& cause : causes) {
      SCOPED_TRACE(cause.name);
      arming_ = {};
      begin(to);
      EXPECT_EQ(run(100), RobotRequest::kNone);
      cause.happen(in_, sample_);
      EXPECT_EQ(run(1), RobotRequest::kDisarm);
      EXPECT_EQ(arming_.state(), RunState::kAborted);
      EXPECT_EQ(arming_.faults(), fault_bit(cause.fault));
      EXPECT_EQ(arming_.disarming(), cause.robot_is_there);
      connect();
      confirm_off();
      EXPECT_EQ(run(1000), RobotRequest::kNone) << "what comes back does not start it again";
      EXPECT_FALSE(arming_.disarming());
      EXPECT_TRUE(arming_.at_rest());
      EXPECT_EQ(arming_.state(), RunState::kAborted);
      request_arm();
      EXPECT_EQ(arming_.faults(), 0u);
    }
  }
}

TEST_F(ArmingTest, WhatEndsAStartThatIsNotConfirmedYetIsItsFault) {
  std::vector<Cause> causes = causes_of_any_end();
  causes.push_back({"refused by the robot", Fault::not_acknowledged,
                    [](ArmingInputs& in, Sample&) { in.answer = RequestAnswer::kFailed; }});
  for (const Cause& cause : causes) {
    SCOPED_TRACE(cause.name);
    arming_ = {};
    request_arm();
    run(5);
    cause.happen(in_, sample_);
    EXPECT_EQ(run(1), RobotRequest::kDisarm);
    EXPECT_EQ(arming_.state(), RunState::kAborted);
    EXPECT_EQ(arming_.faults(), fault_bit(cause.fault));
  }
}

TEST_F(ArmingTest, AStartThatWaitsEndsWithItsSession) {
  for (const Cause& cause : causes_of_any_end()) {
    if (cause.fault != Fault::link_lost && cause.fault != Fault::robot_rebooted) continue;
    SCOPED_TRACE(cause.name);
    arming_ = {};
    connect();
    in_.refusal = StartRefusal::kNotStill;
    arming_.start();
    ASSERT_EQ(run(10), RobotRequest::kNone);
    cause.happen(in_, sample_);
    const bool session_stays = in_.sample == nullptr;  // it is only late
    EXPECT_EQ(run(1), session_stays ? RobotRequest::kNone : RobotRequest::kDisarm);
    EXPECT_EQ(arming_.faults(), session_stays ? 0u : fault_bit(cause.fault));
  }
}

TEST_F(ArmingTest, AnArmThatIsAcknowledgedAndChangesNothingIsGivenUpAfterASecond) {
  request_arm();
  in_.answer = RequestAnswer::kAcknowledged;
  EXPECT_EQ(run(198), RobotRequest::kNone);
  EXPECT_EQ(run(5), RobotRequest::kDisarm);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::not_acknowledged));
}

TEST_F(ArmingTest, ACompletedRunIsFinishedAndWhatIsHeldOrDrivenByHandIdle) {
  for (const RunState to : {RunState::kRunning, RunState::kDriving}) {
    for (const bool held : {false, true}) {
      arming_ = {};
      begin(to);
      in_.done = !held;
      if (held) arming_.hold();
      EXPECT_EQ(run(1), RobotRequest::kDisarm);
      EXPECT_TRUE(arming_.disarming());
      EXPECT_FALSE(arming_.at_rest());
      EXPECT_EQ(run(30), RobotRequest::kNone) << "it has time to obey";
      confirm_off();
      EXPECT_EQ(run(1000), RobotRequest::kNone);
      EXPECT_FALSE(arming_.disarming());
      const bool completed = to == RunState::kRunning && !held;
      EXPECT_EQ(arming_.state(), completed ? RunState::kFinished : RunState::kIdle);
      EXPECT_EQ(arming_.faults(), 0u);
    }
  }
}

TEST_F(ArmingTest, StopIsRequestedInEveryStateAndLatches) {
  arming_.stop();
  EXPECT_FALSE(arming_.at_rest());
  EXPECT_EQ(run(1), RobotRequest::kStop);
  for (const bool finished : {false, true}) {
    begin();
    in_.done = finished;
    run(1);
    if (finished) confirm_off();
    run(1);
    arming_.stop();
    EXPECT_EQ(run(1), RobotRequest::kStop);
    sample_.state = RobotState::kFaulted;
    EXPECT_EQ(run(1000), RobotRequest::kNone);
    EXPECT_EQ(arming_.state(), finished ? RunState::kFinished : RunState::kAborted);
    EXPECT_EQ(arming_.faults(), fault_bit(Fault::stop_requested));
    EXPECT_TRUE(arming_.at_rest());
  }
}

TEST_F(ArmingTest, ARunIsNotTurnedIntoADriveNorADriveIntoARun) {
  for (const RunState to : {RunState::kRunning, RunState::kDriving}) {
    arming_ = {};
    begin(to);
    arming_.drive();
    arming_.start();
    EXPECT_EQ(run(10), RobotRequest::kNone);
    EXPECT_EQ(arming_.state(), to);
  }
}

TEST_F(ArmingTest, GoesOnFromAStateWithItsFaultsAndNothingElse) {
  begin();
  arming_.resume(RunState::kAborted, fault_bit(Fault::fence));
  EXPECT_EQ(arming_.state(), RunState::kAborted);
  EXPECT_EQ(arming_.faults(), fault_bit(Fault::fence));
  EXPECT_TRUE(arming_.at_rest());
  EXPECT_FALSE(arming_.just_began());
  begin();
}

TEST(Pause, LastsTwoMinutesAtMostHoweverOftenItIsAskedFor) {
  Pause pause;
  for (int i = 1; i < 120; ++i) {
    pause.begin();
    ASSERT_FALSE(pause.update(1.0));
    ASSERT_EQ(pause.left_s(), 120.0 - i);
  }
  EXPECT_TRUE(pause.update(1.5)) << "the run ends";
  EXPECT_FALSE(pause.active());
  EXPECT_FALSE(pause.update(1.0)) << "once";
  pause.begin();
  pause.update(0.25);
  pause.end();
  EXPECT_FALSE(pause.update(1.0));
  EXPECT_EQ(pause.total_s(), 120.75);
  pause.begin();
  pause.restart();
  EXPECT_FALSE(pause.active());
  EXPECT_EQ(pause.total_s(), 0.0);
}

}  // namespace
}  // namespace tp100::control
