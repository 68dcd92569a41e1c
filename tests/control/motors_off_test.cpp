// Motors that are on without a request, and ends that the robot must confirm.

#include <gtest/gtest.h>

#include <functional>

#include "arming_fixture.h"
#include "support/sequence.h"

namespace tp100::control {
namespace {

TEST_F(ArmingTest, ACompletionThatIsNotConfirmedIsNone) {
  const struct {
    const char* name;
    Fault fault;
    std::function<void()> happen;
    bool stays_on;
  } cases[] = {
      {"refused", Fault::not_acknowledged,
       [&] {
         sample_.state = RobotState::kDisarmed;
         in_.answer = RequestAnswer::kFailed;
       },
       false},
      {"no answer", Fault::not_acknowledged, [&] { sample_.state = RobotState::kDisarmed; }, false},
      {"acknowledged, but the motors stay on", Fault::moves_unasked,
       [&] { in_.answer = RequestAnswer::kAcknowledged; }, true},
      {"the link breaks", Fault::link_lost, [&] { in_.sample = nullptr; }, false},
      {"the robot restarts", Fault::robot_rebooted,
       [&] {
         sample_.state = RobotState::kDisarmed;
         in_.rebooted = true;
       },
       false}};
  for (const auto& of : cases) {
    SCOPED_TRACE(of.name);
    arming_ = {};
    begin();
    in_.done = true;
    ASSERT_EQ(run(1), RobotRequest::kDisarm);
    in_.done = false;
    of.happen();
    run(48);
    run(5);
    EXPECT_EQ(arming_.state(), RunState::kAborted);
    EXPECT_EQ(arming_.faults(), fault_bit(of.fault));
    EXPECT_EQ(arming_.disarming(), of.stays_on) << "it lasts as long as the motors are on";
  }
}

TEST_F(ArmingTest, MotorsThatNobodyAskedForAreStoppedAgainAndAgain) {
  const std::function<void()> oddities[] = {
      [&] { sample_.state = RobotState::kArmed; }, [&] { sample_.state = RobotState::kRunning; },
      [&] { sample_.left_duty = 0.1; }, [&] { sample_.right_duty = -0.1; }};
  for (const auto& oddity : oddities) {
    arming_ = {};
    sample_ = {};
    connect();
    ASSERT_EQ(run(100), RobotRequest::kNone);
    oddity();
    EXPECT_EQ(run(10), RobotRequest::kNone) << "a single sample may be an old one";
    EXPECT_FALSE(arming_.at_rest());
    EXPECT_EQ(run(2), RobotRequest::kStop);
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

// The times are those of the samples: without a new one nothing is known.
TEST_F(ArmingTest, MotorsThatNobodyAskedForAreStoppedAfterExactlyFiftyMilliseconds) {
  connect();
  sample_.state = RobotState::kArmed;
  for (const HostNs after : {HostNs{0}, 50 * kNsPerMs - 1}) {
    sample_.measured_ns = 7 * kNsPerS + after;
    for (int i = 0; i < 100; ++i) EXPECT_EQ(arming_.update(in_, kCycleS), RobotRequest::kNone);
  }
  sample_.measured_ns = 7 * kNsPerS + 50 * kNsPerMs;
  EXPECT_EQ(arming_.update(in_, kCycleS), RobotRequest::kStop);
}

TEST_F(ArmingTest, MotorsThatStayOnAfterARunAreStopped) {
  begin();
  in_.done = true;
  ASSERT_EQ(run(1), RobotRequest::kDisarm);
  in_.answer = RequestAnswer::kFailed;
  EXPECT_EQ(run(48), RobotRequest::kNone) << "the link repeats the request for 0.2 s";
  EXPECT_EQ(run(4), RobotRequest::kStop);
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

// An operator who presses anything, and a robot that mostly obeys.
TEST_F(ArmingTest, WhateverHappensNothingMovesWithoutAStartAndEveryEndDisarms) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::Sequence any(seed);
    arming_ = {};
    connect();
    int wanted = 0, due = 0;  // starts that were not used; steps until the robot answers
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
        any.chance(0.5) ? arming_.start() : arming_.drive();
        if (!under_way(before)) wanted = 1;
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
      const RobotRequest request = run(1);
      const RunState after = arming_.state();
      if (request == RobotRequest::kArm) {
        ASSERT_EQ(wanted, 1) << step;
        ASSERT_EQ(in.refusal, StartRefusal::kNone) << step;
        wanted = 0;
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
