// Requests and commands that a session sends to the robot.
#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"
#include "session_rig.h"

namespace tp100::link {
namespace {

TEST(Session, ADisarmUnderWayEndsWithItsSession) {
  SessionRig rig;
  rig.connect();
  rig.robot.answers_requests = false;
  rig.session.request(RobotRequest::kDisarm, rig.now);
  rig.run(20);
  ASSERT_TRUE(rig.session.request_pending());
  rig.robot.reboot(rig.now);
  rig.robot.received = {};
  rig.run(400);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  EXPECT_FALSE(rig.session.request_pending());
  EXPECT_TRUE(rig.robot.received.disarms.empty()) << "its token belongs to another boot";
}

TEST(Session, CommandsGoOnWhereTheRobotIsInTheNextSession) {
  SessionRig rig;
  rig.commands = true;
  rig.connect();
  // Another host has controlled the robot in the meantime.
  rig.robot.state = wire::State::kHello;
  rig.robot.received.commands.push_back({});
  rig.robot.received.commands.back().sequence = 40000;
  rig.commands = false;
  rig.run(20);
  rig.commands = true;
  rig.run(400);
  ASSERT_EQ(rig.session.state(), SessionState::kReady);
  EXPECT_GT(rig.robot.received.commands.back().sequence, 40000);
}

// Commands that are refused or lost in one direction for minutes must not make those after them
// look old: the robot could not be armed for as long again.
TEST(Session, CommandsAreNewHoweverManyWereRefusedBefore) {
  SessionRig rig;
  rig.commands = true;  // each millisecond
  rig.connect();
  ASSERT_EQ(rig.session.state(), SessionState::kReady);
  for (const int refused : {1'000, 16'000, 16'400, 20'000, 33'000, 50'000, 66'000, 140'000}) {
    auto& commands = rig.robot.received.commands;
    const std::uint16_t accepted = commands.back().sequence;
    for (int ms = 0; ms < refused; ++ms) {
      rig.run(1);
      // The robot has accepted none of them.
      commands.back().sequence = accepted;
    }
    rig.run(20);
    EXPECT_GT(wrapped_difference(commands.back().sequence, accepted), 0) << refused;
    for (std::size_t i = commands.size() - 10; i < commands.size(); ++i)
      EXPECT_EQ(wrapped_difference(commands[i].sequence, commands[i - 1].sequence), 1) << refused;
  }
}

// A robot that has turned 159 times would refuse every command.
TEST(Session, YawsStayInTheRobotsRangeWithTheirDifference) {
  SessionRig rig;
  rig.connect();
  for (double yaw_rad = 0.1; yaw_rad < 1e7; yaw_rad *= 1.07) {
    for (const double sign : {-1.0, 1.0}) {
      for (const double ahead_rad : {-0.3, 0.0, 0.14}) {
        rig.command.pose.yaw_rad = sign * yaw_rad;
        rig.command.desired_yaw_rad = sign * yaw_rad + ahead_rad;
        rig.session.send(rig.command, rig.now);
        rig.run(1);
        const wire::Command& sent = rig.robot.received.commands.back();
        EXPECT_LE(std::abs(sent.yaw_rad), 100.0f);
        EXPECT_NEAR(sent.desired_yaw_rad - sent.yaw_rad, ahead_rad, 1e-5) << sign * yaw_rad;
        EXPECT_NEAR(wrap_angle(static_cast<double>(sent.yaw_rad) - sign * yaw_rad), 0.0, 1e-5);
        EXPECT_EQ(sent.desired_yaw_rad == sent.yaw_rad, ahead_rad == 0.0);
        // What was recorded and judged before is sent as it was.
        if (yaw_rad > 100.0) continue;
        EXPECT_EQ(sent.yaw_rad, static_cast<float>(sign * yaw_rad));
      }
    }
  }
}

TEST(Session, TellsWhatBecameOfArmAndDisarm) {
  SessionRig rig;
  rig.connect();
  rig.session.request(RobotRequest::kArm, rig.now);
  EXPECT_EQ(rig.session.take_answer(), RequestAnswer::kNone);
  rig.run(20);
  EXPECT_EQ(rig.session.take_answer(), RequestAnswer::kAcknowledged);
  EXPECT_EQ(rig.session.take_answer(), RequestAnswer::kNone);
  rig.session.request(RobotRequest::kDisarm, rig.now);
  rig.run(20);
  EXPECT_EQ(rig.session.take_answer(), RequestAnswer::kAcknowledged);
  rig.robot.answers_requests = false;
  rig.session.request(RobotRequest::kDisarm, rig.now);
  rig.run(210);
  EXPECT_EQ(rig.session.take_answer(), RequestAnswer::kFailed);
}

TEST(Session, ADisarmThatIsRefusedIsNotConfirmed) {
  SessionRig rig;
  rig.connect();
  rig.robot.answers_requests = false;
  rig.session.request(RobotRequest::kDisarm, rig.now);
  rig.run(20);
  rig.robot.send(wire::Acknowledge{static_cast<std::uint8_t>(wire::Type::kDisarm),
                                   rig.robot.received.disarms.back().token,
                                   static_cast<std::uint8_t>(wire::Result::kWrongState), 0});
  rig.run(5);
  EXPECT_EQ(rig.session.take_answer(), RequestAnswer::kFailed);
}

TEST(Session, AStopThatIsAskedForAgainIsTheSameOne) {
  SessionRig rig;
  rig.connect();
  rig.robot.answers_requests = false;
  for (int i = 0; i < 10; ++i) {
    rig.session.request(RobotRequest::kStop, rig.now);
    rig.run(100);
  }
  EXPECT_EQ(rig.count<NotAcknowledged>(), 1);
  EXPECT_EQ(rig.robot.received.stops.front().token, rig.robot.received.stops.back().token);
}

TEST(Session, ArmIsAcknowledgedOnceWithAFreshToken) {
  SessionRig rig;
  rig.connect();
  rig.session.request(RobotRequest::kArm, rig.now);
  rig.run(50);
  rig.session.request(RobotRequest::kDisarm, rig.now);
  rig.run(50);
  rig.session.request(RobotRequest::kArm, rig.now);
  rig.run(50);
  ASSERT_EQ(rig.robot.received.arms.size(), 2u);
  ASSERT_EQ(rig.robot.received.disarms.size(), 1u);
  EXPECT_LT(rig.robot.received.arms[0].token, rig.robot.received.disarms[0].token);
  EXPECT_LT(rig.robot.received.disarms[0].token, rig.robot.received.arms[1].token);
  EXPECT_GT(rig.robot.received.arms[0].token, rig.robot.received.parameters[0].token);
  EXPECT_NE(rig.session.take_answer(), RequestAnswer::kFailed);
  EXPECT_EQ(rig.robot.state, wire::State::kArmed);
}

TEST(Session, TokensExceedThoseOfAnEarlierDaemon) {
  SessionRig first;
  first.connect();
  first.session.request(RobotRequest::kArm, first.now);
  first.run(50);
  SessionRig second;
  second.now = first.now;
  second.robot = first.robot;
  second.robot.received = {};
  second.connect();
  ASSERT_FALSE(second.robot.received.parameters.empty());
  EXPECT_GT(second.robot.received.parameters[0].token, first.robot.received.arms[0].token);
}

TEST(Session, AnUnacknowledgedArmIsRefusedAfter200MsAndALateAnswerDisarms) {
  SessionRig rig;
  rig.connect();
  rig.robot.answers_requests = false;
  rig.session.request(RobotRequest::kArm, rig.now);
  rig.run(190);
  EXPECT_NE(rig.session.take_answer(), RequestAnswer::kFailed);
  rig.run(20);
  EXPECT_EQ(rig.session.take_answer(), RequestAnswer::kFailed);
  EXPECT_EQ(rig.count<NotAcknowledged>(), 1);
  const auto& arms = rig.robot.received.arms;
  EXPECT_GE(arms.size(), 6u);
  EXPECT_LE(arms.size(), 8u);
  EXPECT_EQ(arms.front().token, arms.back().token);
  EXPECT_EQ(arms.front().expiry_us, arms.back().expiry_us);

  rig.robot.answers_requests = true;
  for (int again = 0; again < 2; ++again) {
    rig.robot.send(
        wire::Acknowledge{static_cast<std::uint8_t>(wire::Type::kArm), arms.back().token, 0, 0});
    rig.run(20);
    EXPECT_EQ(rig.robot.received.disarms.size(), 1u);
  }
}

TEST(Session, AnArmWithoutASessionIsRefusedAtOnce) {
  SessionRig rig;
  rig.session.request(RobotRequest::kArm, rig.now);
  EXPECT_EQ(rig.session.take_answer(), RequestAnswer::kFailed);
  rig.connect();
  EXPECT_TRUE(rig.robot.received.arms.empty());
}

TEST(Session, AnArmUnderWayEndsWithItsSession) {
  SessionRig rig;
  rig.connect();
  rig.robot.answers_requests = false;
  rig.session.request(RobotRequest::kArm, rig.now);
  rig.run(20);
  rig.robot.reboot(rig.now);
  const std::size_t before = rig.robot.received.arms.size();
  rig.run(400);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  EXPECT_EQ(rig.robot.received.arms.size(), before);
  EXPECT_EQ(rig.session.take_answer(), RequestAnswer::kFailed);
}

TEST(Session, ARefusedArmIsReported) {
  SessionRig rig;
  rig.robot.arm_result = wire::Result::kFaultPersists;
  rig.connect();
  rig.session.request(RobotRequest::kArm, rig.now);
  rig.run(20);
  EXPECT_EQ(rig.session.take_answer(), RequestAnswer::kFailed);
  EXPECT_EQ(rig.robot.received.arms.size(), 1u);
}

TEST(Session, LearnsFromAStaleToken) {
  SessionRig rig;
  rig.robot.arm_result = wire::Result::kStaleToken;
  rig.connect();
  rig.session.request(RobotRequest::kArm, rig.now);
  rig.run(20);
  rig.session.request(RobotRequest::kArm, rig.now);
  rig.run(20);
  ASSERT_EQ(rig.robot.received.arms.size(), 2u);
  EXPECT_GT(rig.robot.received.arms[1].token, rig.robot.received.arms[0].token + 1000u);
}

TEST(Session, StopSupersedesArmAndIsRepeatedUntilAcknowledged) {
  SessionRig rig;
  rig.connect();
  rig.robot.answers_requests = false;
  rig.session.request(RobotRequest::kArm, rig.now);
  rig.session.request(RobotRequest::kStop, rig.now);
  rig.run(210);
  EXPECT_TRUE(rig.robot.received.arms.empty());
  EXPECT_EQ(rig.session.take_answer(), RequestAnswer::kFailed);
  EXPECT_GE(rig.robot.received.stops.size(), 6u);
  EXPECT_EQ(rig.count<NotAcknowledged>(), 2);
  rig.robot.answers_requests = true;
  rig.run(300);
  EXPECT_FALSE(rig.session.request_pending());
}

TEST(Session, StopIsTheFirstThingSentOnTheNextSession) {
  SessionRig rig;
  rig.connect();
  rig.session.close(rig.now);
  rig.session.request(RobotRequest::kStop, rig.now);
  rig.run(300);
  EXPECT_EQ(rig.count<NotAcknowledged>(), 1);
  rig.robot.received = {};
  rig.robot.state = wire::State::kHello;
  rig.connect();
  ASSERT_FALSE(rig.robot.received.types.empty());
  EXPECT_EQ(rig.robot.received.types[0], static_cast<std::uint8_t>(wire::Type::kStop));
  EXPECT_FALSE(rig.session.request_pending());
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

TEST(Session, CommandsCarryNonceAscendingSequenceAndExpiry) {
  SessionRig rig;
  rig.commands = true;
  rig.connect();
  rig.command.pose.yaw_rad = 0.25;
  rig.command.speed_mps = 0.1;
  rig.command.expiry_us = (DeviceUs{1} << 32U) + 77;
  rig.command.answers = 42;
  rig.run(3);
  const auto& commands = rig.robot.received.commands;
  ASSERT_GT(commands.size(), 10u);
  for (std::size_t i = 1; i < commands.size(); ++i) {
    ASSERT_EQ(commands[i].sequence, static_cast<std::uint16_t>(commands[i - 1].sequence + 1));
  }
  EXPECT_EQ(commands.back().boot_nonce, rig.robot.boot_nonce);
  EXPECT_FLOAT_EQ(commands.back().yaw_rad, 0.25F);
  EXPECT_FLOAT_EQ(commands.back().speed_mps, 0.1F);
  EXPECT_EQ(commands.back().expiry_us, 77u);
  EXPECT_EQ(commands.back().answers, 42);
}

TEST(Session, CommandSequenceContinuesAboveThatOfAnEarlierDaemon) {
  SessionRig first;
  first.commands = true;
  first.connect();
  SessionRig second;
  second.now = first.now;
  second.robot = first.robot;
  second.commands = true;
  second.connect();
  const auto& commands = second.robot.received.commands;
  const std::size_t border = first.robot.received.commands.size();
  ASSERT_GT(commands.size(), border);
  EXPECT_EQ(commands[border].sequence,
            static_cast<std::uint16_t>(commands[border - 1].sequence + 1));
}

TEST(Session, ClockRequestsComeMoreOftenOnlyIfNothingElseIsSent) {
  SessionSettings settings = SessionRig::settings();
  settings.clock_answer_ns = kNsPerS;
  for (const bool commands : {true, false}) {
    SessionRig rig(settings);
    rig.commands = commands;
    rig.connect();
    rig.robot.answers_sync = false;
    rig.robot.received.sync_requests = 0;
    rig.run(8000);
    ASSERT_EQ(rig.session.state(), SessionState::kReady);
    const int requests = rig.robot.received.sync_requests;
    if (commands) {
      EXPECT_LE(requests, 9);
    } else {
      EXPECT_GE(requests, 19) << "the robot must hear the host";
    }
  }
}

TEST(Session, ACommandThatFoundNoRoomIsNoSignOfLife) {
  SessionSettings settings = SessionRig::settings();
  settings.clock_answer_ns = 2 * kNsPerS;
  SessionRig rig(settings);
  rig.connect();
  rig.robot.answers_sync = false;
  rig.run(300);
  rig.commands = true;
  rig.port_takes = false;
  rig.run(350);
  rig.commands = false;
  rig.session.drop_output();
  rig.port_takes = true;
  rig.robot.received.sync_requests = 0;
  rig.run(100);
  ASSERT_EQ(rig.session.state(), SessionState::kReady);
  EXPECT_EQ(rig.robot.received.sync_requests, 1) << "the robot has heard nothing for 0.4 s";
}

TEST(Session, DropsAndCountsWhatThePortDoesNotTake) {
  SessionRig rig;
  rig.commands = true;
  rig.connect();
  rig.port_takes = false;
  rig.run(100);
  const std::uint64_t overflow = rig.session.counters().unwritten;
  EXPECT_GT(overflow, 50u);
  rig.session.written(10);
  rig.session.drop_output();
  EXPECT_GT(rig.session.counters().unwritten, overflow);
  EXPECT_TRUE(rig.session.output().empty());
  rig.port_takes = true;
  const std::size_t before = rig.robot.received.commands.size();
  rig.run(5);
  EXPECT_EQ(rig.robot.received.commands.size(), before + 5);
}

}  // namespace
}  // namespace tp100::link
