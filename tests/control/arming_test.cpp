// The start and the end of a run or drive: arming, motors that are on without a request, ends that
// the robot must confirm, and the pause.

#include "control/arming.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>
#include <vector>

#include "support/sequence.h"

namespace tp100::control {
namespace {

constexpr double kCycleS = 0.005;

/// Arming with a robot whose samples and answers the tests set.
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

TEST_F(ArmingTest, AStartThatWaitsEndsWithItsSessionAndTheNextWaitsForAnother) {
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
    arming_.start();
    EXPECT_EQ(run(400), RobotRequest::kNone);
    EXPECT_EQ(arming_.state(), RunState::kArming);
    connect();
    EXPECT_EQ(run(100), RobotRequest::kArm);
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

TEST_F(ArmingTest, ACompletionThatIsNotConfirmedIsNone) {
  constexpr FaultMask not_acknowledged = fault_bit(Fault::not_acknowledged);
  constexpr FaultMask unasked = fault_bit(Fault::moves_unasked);
  const struct {
    const char* name;
    FaultMask faults;
    RequestAnswer answer = RequestAnswer::kNone;
    bool motors_on = false, link_breaks = false, restarts = false;
  } cases[] = {{"refused", not_acknowledged, RequestAnswer::kFailed},
               {"no answer", not_acknowledged},
               {"acknowledged, but on", unasked, RequestAnswer::kAcknowledged, true},
               {"refused and on", not_acknowledged | unasked, RequestAnswer::kFailed, true},
               {"the link breaks", fault_bit(Fault::link_lost), RequestAnswer::kNone, false, true},
               {"the robot restarts", fault_bit(Fault::robot_rebooted), RequestAnswer::kNone, false,
                false, true}};
  for (const auto& of : cases) {
    SCOPED_TRACE(of.name);
    arming_ = {};
    begin();
    in_.done = true;
    ASSERT_EQ(run(1), RobotRequest::kDisarm);
    in_.done = false;
    in_.answer = of.answer;
    in_.rebooted = of.restarts;
    if (of.link_breaks) in_.sample = nullptr;
    if (!of.motors_on) sample_.state = RobotState::kDisarmed;
    run(48);
    run(5);
    EXPECT_EQ(arming_.state(), RunState::kAborted);
    EXPECT_EQ(arming_.faults(), of.faults);
    EXPECT_EQ(arming_.disarming(), of.motors_on) << "it lasts as long as the motors are on";
  }
}

// The times are those of the samples: without a new one nothing is known.
TEST_F(ArmingTest, MotorsThatNobodyAskedForAreStoppedAfterFiftyMillisecondsAndAgainAndAgain) {
  const std::function<void()> oddities[] = {
      [&] { sample_.state = RobotState::kArmed; }, [&] { sample_.state = RobotState::kRunning; },
      [&] { sample_.left_duty = 0.1; }, [&] { sample_.right_duty = -0.1; }};
  for (std::size_t i = 0; i < 2 * std::size(oddities); ++i) {
    arming_ = {};
    sample_ = {};
    connect();
    in_.refusal = StartRefusal::kMotorsOn;
    if (i % 2 == 0) arming_.start();  // a start that waits
    ASSERT_EQ(run(100), RobotRequest::kNone);
    oddities[i / 2]();
    for (int again = 0; again < 100; ++again)
      ASSERT_EQ(arming_.update(in_, kCycleS), RobotRequest::kNone) << "the same sample";
    EXPECT_EQ(run(10), RobotRequest::kNone) << "a single sample may be an old one";
    EXPECT_FALSE(arming_.at_rest());
    EXPECT_EQ(run(1), RobotRequest::kStop);
    EXPECT_EQ(arming_.state(), RunState::kAborted);
    EXPECT_EQ(arming_.faults(), fault_bit(Fault::moves_unasked));
    for (int again = 0; again < 5; ++again) {
      EXPECT_EQ(run(38), RobotRequest::kNone);
      EXPECT_EQ(run(4), RobotRequest::kStop);
    }
    sample_.state = RobotState::kFaulted;
    sample_.left_duty = sample_.right_duty = 0.0;
    EXPECT_EQ(run(1000), RobotRequest::kNone);
    EXPECT_FALSE(arming_.disarming());
    EXPECT_EQ(arming_.faults(), fault_bit(Fault::moves_unasked));
  }
}

// An operator who presses anything, and a robot that mostly obeys.
TEST_F(ArmingTest, WhateverHappensNothingMovesWithoutAStartAndEveryEndDisarms) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::Sequence any(seed);
    arming_ = {};
    connect();
    int due = 0, free = 0;  // steps until the robot answers; since a reason refused a start
    RunState wanted = RunState::kIdle;  // by the last start that was not used
    RunState meant = RunState::kIdle;   // by the one that armed
    RobotRequest told = RobotRequest::kNone;
    bool acknowledged = false;
    for (int step = 0; step < 20000; ++step) {
      if (any.chance(0.02)) connect();
      if (any.chance(0.01)) in_.session = SessionState::kSyncing;
      if (any.chance(0.01)) in_.sample = nullptr;
      if (any.chance(0.002)) in_.refusal = StartRefusal::kNotStill;
      if (any.chance(0.002)) sample_.faults = fault_bit(Fault::stalled_left);
      if (any.chance(0.002)) sample_.state = RobotState::kRunning;
      in_.new_session = any.chance(0.002);
      in_.rebooted = any.chance(0.002);
      in_.aborts = any.chance(0.002) ? fault_bit(Fault::fence) : 0;
      in_.done = any.chance(0.005);
      const RunState before = arming_.state();
      const bool starts = any.chance(0.03), holds = any.chance(0.002), stops = any.chance(0.002);
      if (starts) {
        const bool by_hand = any.chance(0.5);
        by_hand ? arming_.drive() : arming_.start();
        if (!under_way(before)) wanted = by_hand ? RunState::kDriving : RunState::kRunning;
      }
      if (holds) arming_.hold();
      if (stops) arming_.stop();
      if (due > 0 && --due == 0) {
        in_.answer = any.chance(0.9) ? RequestAnswer::kAcknowledged : RequestAnswer::kFailed;
        if (in_.answer == RequestAnswer::kAcknowledged) {
          acknowledged = told == RobotRequest::kArm;
          sample_.state = acknowledged ? RobotState::kArmed : RobotState::kDisarmed;
        }
      }
      const ArmingInputs in = in_;
      free = in.refusal == StartRefusal::kNone ? free + 1 : 0;
      const RobotRequest request = run(1);
      const RunState after = arming_.state();
      if (request == RobotRequest::kArm) {
        ASSERT_NE(wanted, RunState::kIdle) << step;
        ASSERT_GE(free, 10) << step << ": fresh commands come first";
        meant = std::exchange(wanted, RunState::kIdle);
        acknowledged = false;
      }
      if (request != RobotRequest::kNone) {
        told = request;
        due = request == RobotRequest::kStop ? 0 : 1 + any.below(20);
        if (request == RobotRequest::kStop) sample_.state = RobotState::kFaulted;
      }
      if (armed(after)) {
        const bool healthy = in.session == SessionState::kReady && in.sample != nullptr &&
                             !in.new_session && !in.rebooted && in.aborts == 0;
        ASSERT_TRUE(healthy && acknowledged) << step;
        ASSERT_EQ(after, meant) << step;
        ASSERT_EQ(arming_.just_began(), !armed(before)) << step;
      }
      if (under_way(before) && !under_way(after) && arming_.refused() == StartRefusal::kNone) {
        ASSERT_TRUE(request == RobotRequest::kDisarm || request == RobotRequest::kStop) << step;
      }
      if (holds || stops) {
        ASSERT_NE(request, RobotRequest::kNone) << step;
      }
      ASSERT_TRUE(after != RunState::kAborted || arming_.faults() != 0) << step;
      ASSERT_TRUE(!under_way(after) || arming_.faults() == 0) << step;
    }
  }
}

}  // namespace
}  // namespace tp100::control
