#include "link/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "session_rig.h"

namespace tp100::link {
namespace {

TEST(Session, PassesItsStatesInOrderAndDeliversSamples) {
  SessionRig rig;
  rig.connect();
  EXPECT_EQ(rig.states, "listening parameters syncing ready");
  EXPECT_EQ(rig.session.session_number(), 1u);
  ASSERT_GT(rig.samples.size(), 20u);
  EXPECT_EQ(rig.session.counters().lost, 0u);
  EXPECT_TRUE(rig.robot.received.hello_requests.empty());
  ASSERT_EQ(rig.robot.received.parameters.size(), 1u);
  EXPECT_EQ(rig.robot.received.parameters[0].boot_nonce, rig.robot.boot_nonce);
}

TEST(Session, StaysSilentUntilTheRobotSpeaks) {
  SessionRig rig;
  rig.robot.silent = true;
  rig.session.open(rig.now);
  rig.run(3000);
  const std::vector<std::uint8_t> banner(100, 'U');
  rig.session.receive(banner, rig.now);
  rig.run(100);
  EXPECT_TRUE(rig.session.output().empty());
  EXPECT_TRUE(rig.robot.received.types.empty());
  EXPECT_EQ(rig.states, "listening");
}

TEST(Session, WarnsWhenNothingIsHeardAndKeepsListening) {
  SessionRig rig;
  rig.robot.silent = true;
  rig.session.open(rig.now);
  rig.run(5200);
  EXPECT_EQ(rig.count<Silence>(), 1);
  EXPECT_EQ(rig.session.state(), SessionState::kListening);
  rig.robot.silent = false;
  rig.run(400);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

TEST(Session, AsksForAHelloWhenItJoinsInTheMiddle) {
  SessionRig rig;
  rig.robot.state = wire::State::kRunning;
  rig.connect();
  EXPECT_EQ(rig.states, "listening hello parameters syncing ready");
  EXPECT_EQ(rig.robot.received.hello_requests.size(), 1u);
}

TEST(Session, GivesTheSameSamplesHoweverTheBytesAreSplit) {
  SessionRig whole;
  whole.connect();
  for (std::size_t split = 1; split <= wire::kMaxFrame; ++split) {
    SessionRig rig;
    rig.split = split;
    rig.connect();
    ASSERT_EQ(rig.samples.size(), whole.samples.size()) << split;
    ASSERT_EQ(rig.samples.back().device_us, whole.samples.back().device_us) << split;
    ASSERT_EQ(rig.states, whole.states) << split;
  }
}

TEST(Session, RefusesAnotherProtocolOrSchemaAndFallsSilent) {
  for (const bool older : {true, false}) {
    SessionRig rig;
    if (older) rig.robot.protocol = 7;
    if (!older) rig.robot.schema ^= 1;
    rig.connect();
    EXPECT_EQ(rig.session.state(), SessionState::kRefused);
    EXPECT_EQ(rig.count<VersionMismatch>(), 1);
    EXPECT_EQ(rig.session.hello().protocol, rig.robot.protocol);
    EXPECT_EQ(rig.session.counters().refused, 1u);
    EXPECT_TRUE(rig.robot.received.types.empty());
  }
}

TEST(Session, ABoardThatSpeaksAnotherProtocolAfterARestartIsRefusedToo) {
  SessionRig rig;
  rig.connect();
  ASSERT_EQ(rig.session.state(), SessionState::kReady);
  rig.robot.protocol = 7;
  rig.robot.reboot(rig.now);
  rig.run(400);
  EXPECT_EQ(rig.session.state(), SessionState::kRefused);
  EXPECT_EQ(rig.count<VersionMismatch>(), 1);
}

TEST(Session, UnpluggedInAnyMillisecondItConnectsAgainDisarmed) {
  for (int ms = 1; ms <= 400; ++ms) {
    SessionRig rig;
    rig.commands = true;
    rig.session.open(rig.now);
    rig.run(ms);
    rig.session.request(RobotRequest::kArm, rig.now);
    rig.run(2);
    rig.session.close(rig.now);
    EXPECT_TRUE(rig.session.output().empty()) << ms;
    EXPECT_FALSE(rig.session.request_pending()) << ms;
    rig.run(20);
    rig.robot.reboot(rig.now);
    rig.robot.received = {};
    rig.connect();
    ASSERT_EQ(rig.session.state(), SessionState::kReady) << ms;
    ASSERT_TRUE(rig.robot.received.arms.empty()) << ms;
  }
}

TEST(Session, LostAnswersToClockRequestsAreAskedForAgain) {
  SessionRig rig;
  rig.robot.answers_sync = false;
  rig.commands = true;
  rig.connect();
  EXPECT_EQ(rig.session.state(), SessionState::kSyncing);
  EXPECT_TRUE(rig.robot.received.commands.empty())
      << "a command needs an expiry, and that needs a clock";
  rig.robot.answers_sync = true;
  rig.run(1000);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  // From here on, three of four exchanges are lost.
  for (int i = 0; i < 4000; ++i) {
    rig.robot.answers_sync = rig.robot.received.sync_requests % 4 == 0;
    rig.step();
  }
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  EXPECT_TRUE(rig.session.clock().valid);
  EXPECT_LT(rig.session.clock().uncertainty_us, 1000.0);
}

TEST(Session, ClockRequestsAreSpreadOverAMillisecondOfTheWire) {
  SessionRig rig;
  rig.connect();
  rig.port_takes = false;
  std::set<std::size_t> spare;
  for (int ms = 0; ms < 20'000; ++ms) {
    rig.step();
    const auto out = rig.session.output();
    if (out.empty()) continue;
    spare.insert(static_cast<std::size_t>(
        std::find_if(out.begin(), out.end(), [](std::uint8_t byte) { return byte != 0; }) -
        out.begin()));
    rig.robot.hear(out, rig.now);
    rig.session.written(out.size());
  }
  EXPECT_GT(spare.size(), 20u);
  EXPECT_LT(*spare.rbegin(), 51u);
}

TEST(Session, ABoardThatIsNotKnownIsCountedAndToldAndMayDrive) {
  SessionRig rig;
  rig.robot.board = 77;
  rig.connect();
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  EXPECT_GE(rig.session.counters().unknown_board, 1u);
  ASSERT_GE(rig.count<UnknownBoard>(), 1);
  const auto told = std::find_if(rig.events.begin(), rig.events.end(), [](const auto& event) {
    return as<UnknownBoard>(event) != nullptr;
  });
  EXPECT_EQ(std::get<UnknownBoard>(told->what).board, 77);
  SessionRig known;
  known.connect();
  EXPECT_EQ(known.session.counters().unknown_board, 0u);
}

TEST(Session, AHelloThatNoBoardOfOursSendsIsRefusedOnceAndNotSpokenTo) {
  for (const bool nonce : {true, false}) {
    SessionRig rig;
    rig.robot.boot_nonce = nonce ? 0 : 5;
    // The robot reports an unknown state and keeps sending hellos.
    rig.mangle = [&](std::vector<std::uint8_t>& bytes) {
      if (bytes.empty() || nonce) return;
      wire::Hello hello{wire::kProtocolVersion, {0, 1, 0}, wire::kSchemaHash, 2, 5, 0, 9, 0};
      bytes = frame_of(hello);
    };
    rig.session.open(rig.now);
    rig.run(1000);
    EXPECT_EQ(rig.session.state(), SessionState::kRefused);
    EXPECT_EQ(rig.count<BadHello>(), 1);
    EXPECT_EQ(rig.session.counters().refused, 1u);
    EXPECT_EQ(rig.session.counters().implausible, 0u);
    EXPECT_TRUE(rig.robot.received.types.empty());
    rig.mangle = {};
    rig.robot.reboot(rig.now);
    rig.run(500);
    EXPECT_EQ(rig.session.state(), SessionState::kReady);
  }
}

TEST(Session, ReadsTheVersionOfAHelloWithMoreFields) {
  SessionRig rig;
  rig.session.open(rig.now);
  std::vector<std::uint8_t> payload(30, 0x11);
  payload[0] = 9;
  payload[1] = 0;
  std::vector<std::uint8_t> frame(wire::kMaxFrame);
  frame.resize(wire::encode_frame(static_cast<std::uint8_t>(wire::Type::kHello), payload.data(),
                                  payload.size(), frame.data()));
  rig.session.receive(frame, rig.now);
  EXPECT_EQ(rig.session.state(), SessionState::kRefused);
  EXPECT_EQ(rig.session.hello().protocol, 9);
}

TEST(Session, ConnectsOnceTheRefusedBoardWasFlashed) {
  SessionRig rig;
  rig.robot.protocol = 7;
  rig.connect();
  rig.robot.protocol = wire::kProtocolVersion;
  rig.robot.reboot(rig.now);
  rig.run(500);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  EXPECT_FALSE(rig.session.take_rebooted());
}

TEST(Session, NoticesARebootAndStartsAnew) {
  SessionRig rig;
  rig.connect();
  rig.robot.reboot(rig.now);
  rig.run(400);
  EXPECT_EQ(rig.count<Rebooted>(), 1);
  EXPECT_EQ(rig.session.counters().reboots, 1u);
  EXPECT_EQ(rig.session.counters().reconnects, 1u);
  EXPECT_TRUE(rig.session.take_rebooted());
  EXPECT_FALSE(rig.session.take_rebooted());
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  EXPECT_EQ(rig.session.session_number(), 2u);
  EXPECT_EQ(rig.robot.received.parameters.back().boot_nonce, rig.robot.boot_nonce);
}

TEST(Session, ShakesHandsAgainWhenTheRobotLostTheHost) {
  SessionRig rig;
  rig.connect();
  rig.robot.state = wire::State::kHello;
  rig.run(500);
  EXPECT_EQ(rig.session.counters().reboots, 0u);
  EXPECT_FALSE(rig.session.take_rebooted());
  EXPECT_EQ(rig.session.session_number(), 2u);
  EXPECT_THAT(rig.states, ::testing::EndsWith("ready parameters syncing ready"));
}

TEST(Session, OtherParametersGoToTheSameBootInANewSession) {
  SessionRig rig;
  rig.connect();
  wire::Parameters other = SessionRig::settings().parameters;
  other.wheelbase_m = 0.77F;
  rig.session.use(other, rig.now);
  rig.run(500);
  EXPECT_EQ(rig.robot.received.parameters.back().wheelbase_m, 0.77F);
  EXPECT_EQ(rig.robot.received.parameters.back().boot_nonce, rig.robot.boot_nonce);
  EXPECT_EQ(rig.session.counters().reboots, 0u);
  EXPECT_EQ(rig.session.session_number(), 2u);
  EXPECT_THAT(rig.states, ::testing::EndsWith("ready hello parameters syncing ready"));
}

// Without commands the robot would latch a fault after 200 ms.
TEST(Session, ChangesInQuickSuccessionAreNotSlowedDown) {
  SessionRig rig;
  rig.connect();
  for (int i = 0; i < 5; ++i) {
    rig.session.use(SessionRig::settings().parameters, rig.now);
    rig.run(20);
    EXPECT_EQ(rig.session.state(), SessionState::kSyncing) << i;
  }
}

TEST(Session, ARobotThatRefusedItsParametersTakesOthers) {
  SessionRig rig;
  rig.robot.parameters_result = wire::Result::kOutOfRange;
  rig.connect();
  ASSERT_EQ(rig.session.state(), SessionState::kRefused);
  rig.robot.parameters_result = wire::Result::kAccepted;
  rig.session.use(SessionRig::settings().parameters, rig.now);
  rig.run(500);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

TEST(Session, OtherParametersWithoutARobotWaitForOne) {
  SessionRig rig;
  wire::Parameters other = SessionRig::settings().parameters;
  other.wheelbase_m = 0.77F;
  rig.session.use(other, rig.now);
  EXPECT_EQ(rig.session.state(), SessionState::kClosed);
  rig.connect();
  EXPECT_EQ(rig.robot.received.parameters.back().wheelbase_m, 0.77F);
}

TEST(Session, RepeatsParametersUntilTheyAreAcknowledged) {
  SessionRig rig;
  rig.robot.answers_parameters = false;
  rig.session.open(rig.now);
  rig.run(1000);
  EXPECT_EQ(rig.session.state(), SessionState::kParameters);
  const auto& sent = rig.robot.received.parameters;
  ASSERT_GE(sent.size(), 9u);
  ASSERT_LE(sent.size(), 11u);
  EXPECT_EQ(sent.front().token, sent.back().token);
  rig.robot.answers_parameters = true;
  rig.run(400);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

TEST(Session, StopsWithAnEventWhenParametersAreOutOfRange) {
  SessionRig rig;
  rig.robot.parameters_result = wire::Result::kOutOfRange;
  rig.connect();
  EXPECT_EQ(rig.session.state(), SessionState::kRefused);
  EXPECT_EQ(rig.robot.received.parameters.size(), 1u);
  EXPECT_EQ(rig.count<Acknowledged>(), 1);
}

TEST(Session, TimesOutWhenGoodFramesStopAndRecovers) {
  SessionRig rig;
  rig.connect();
  rig.robot.silent = true;
  rig.run(480);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  rig.run(25);
  EXPECT_EQ(rig.count<Silence>(), 1);
  EXPECT_EQ(rig.session.state(), SessionState::kListening);
  EXPECT_FALSE(rig.session.clock().valid);
  rig.robot.silent = false;
  rig.run(600);
  EXPECT_EQ(rig.session.state(), SessionState::kReady) << rig.states;
  EXPECT_EQ(rig.session.session_number(), 2u);
}

TEST(Session, OnlySamplesKeepASessionAlive) {
  SessionRig rig;
  rig.connect();
  rig.robot.samples = false;
  rig.run(510);
  EXPECT_GT(rig.robot.received.sync_requests, 3);
  EXPECT_EQ(rig.count<Silence>(), 1) << "replies to clock requests do not count as samples";
  EXPECT_NE(rig.session.state(), SessionState::kReady);
  SessionRig chatter;
  chatter.connect();
  chatter.robot.samples = false;
  for (int i = 0; i < 510; ++i) {
    chatter.robot.say(wire::Log{});
    chatter.step();
  }
  EXPECT_EQ(chatter.count<Silence>(), 1);
}

TEST(Session, ARobotWithWhichNoSessionLastsIsAskedLaterAndLater) {
  SessionRig rig;
  // The samples' sequence number never changes: each session ends as soon as this is detected.
  rig.connect();
  int sessions = 0;
  for (int i = 0; i < 30000; ++i) {
    rig.robot.sequence = 7;
    const std::uint32_t before = rig.session.session_number();
    rig.step();
    sessions += static_cast<int>(rig.session.session_number() - before);
  }
  // The waits are 0.2, 0.4, 0.8, 1.6, 3.2, 5, 5 ... seconds, each followed by an attempt of 0.5 s.
  EXPECT_GE(sessions, 5);
  EXPECT_LE(sessions, 10);
  // A robot that works again is retried without a long wait, and after its next failure at once.
  rig.run(7000);
  ASSERT_EQ(rig.session.state(), SessionState::kReady);
  rig.robot.state = wire::State::kHello;
  rig.run(600);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

TEST(Session, APortThatGoesIsNoReasonToWait) {
  SessionRig rig;
  for (int i = 0; i < 10; ++i) {
    rig.robot.reboot(rig.now);
    rig.connect();
    ASSERT_EQ(rig.session.state(), SessionState::kReady) << i;
    rig.session.close(rig.now);
  }
}

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

TEST(Session, CountsAndTimesOfAnEarlierBootAreForgotten) {
  SessionRig rig;
  // The robot has been up for more than half an hour, so its time is far from that of the next
  // boot.
  rig.robot.device_offset_us = 2'400'000'000U;
  rig.robot.metres_per_s = 0.1;
  rig.connect();
  const DeviceUs before_us = rig.samples.back().device_us;
  const std::int64_t before_counts = rig.samples.back().left_counts;
  rig.run(2000);
  EXPECT_GT(rig.samples.back().left_counts, before_counts);
  rig.robot.device_offset_us = 0;
  rig.robot.metres_per_s = 0.0;
  rig.robot.reboot(rig.now);
  rig.samples.clear();
  rig.run(500);
  ASSERT_EQ(rig.session.state(), SessionState::kReady);
  ASSERT_FALSE(rig.samples.empty());
  EXPECT_LT(rig.samples.back().device_us, 1'000'000);
  EXPECT_LT(rig.samples.back().device_us, before_us);
  EXPECT_EQ(rig.samples.back().left_counts, 0);
  EXPECT_EQ(rig.session.counters().implausible, 0u);
}

// The robot is as old after its next boot as it was before: only the nonce tells the new counts
// from a jump.
TEST(Session, CountsOfANewBootAreNoJumpOfTheOldOne) {
  SessionSettings settings = SessionRig::settings();
  settings.parameters.max_track_mps = 0.1f;
  settings.parameters.counts_per_metre = 11140.0f;
  SessionRig rig(settings);
  rig.robot.metres_per_s = 0.1;
  rig.connect();
  rig.run(10'000);
  const Sample before = rig.samples.back();
  EXPECT_GT(before.left_counts, 11'000);
  rig.session.close(rig.now);
  rig.robot.metres_per_s = 0.0;
  rig.robot.reboot(rig.now);
  rig.run(11'500);
  rig.connect();
  ASSERT_EQ(rig.session.state(), SessionState::kReady);
  const Sample& after = rig.samples.back();
  EXPECT_GT(after.device_us, before.device_us);
  EXPECT_LT(after.device_us, before.device_us + 1'000'000);
  EXPECT_EQ(after.left_counts, 0);
  EXPECT_EQ(after.right_counts, 0);
  EXPECT_EQ(rig.session.counters().implausible, 0u);
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
  rig.robot.say(wire::Acknowledge{static_cast<std::uint8_t>(wire::Type::kDisarm),
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

TEST(Session, GarbageAloneIsNoLife) {
  SessionRig rig;
  rig.connect();
  rig.robot.silent = true;
  for (int i = 0; i < 600; ++i) {
    const std::vector<std::uint8_t> noise{0x17, 0x99, 0x00, 0x55};
    rig.session.receive(noise, rig.now);
    rig.step();
  }
  EXPECT_EQ(rig.session.state(), SessionState::kListening);
  const LinkCounters& counters = rig.session.counters();
  EXPECT_GT(counters.crc_errors + counters.cobs_errors + counters.undersize, 400u);
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
    rig.robot.say(
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

TEST(Session, HalfOpenLinkIsNoticedByTheRobotsHello) {
  SessionRig rig;
  rig.connect();
  rig.loses_output = true;
  rig.run(300);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  rig.robot.state = wire::State::kHello;
  rig.run(300);
  EXPECT_EQ(rig.session.state(), SessionState::kParameters);
}

TEST(Session, SaysThatARobotAnswersNothingAndGoesOnAsking) {
  const auto unanswered = [](SessionRig& rig) {
    std::vector<SessionState> states;
    for (const SessionEvent& event : rig.events)
      if (const Unanswered* silent = as<Unanswered>(event)) states.push_back(silent->state);
    EXPECT_EQ(rig.session.counters().unanswered, states.size());
    return states;
  };
  using testing::ElementsAre;
  SessionRig deaf;
  deaf.robot.answers_parameters = false;
  deaf.session.open(deaf.now);
  deaf.run(5200);
  EXPECT_THAT(unanswered(deaf), ElementsAre(SessionState::kParameters));
  deaf.run(5000);
  EXPECT_THAT(unanswered(deaf), ElementsAre(SessionState::kParameters, SessionState::kParameters));
  deaf.robot.answers_parameters = true;
  deaf.run(400);
  EXPECT_EQ(deaf.session.state(), SessionState::kReady);
  deaf.run(20000);
  EXPECT_THAT(unanswered(deaf), testing::SizeIs(2));

  SessionRig timeless;
  timeless.robot.answers_sync = false;
  timeless.session.open(timeless.now);
  timeless.run(5200);
  EXPECT_THAT(unanswered(timeless), ElementsAre(SessionState::kSyncing));
}

TEST(Session, CountsWhatTheRobotSaysCameCorrupted) {
  SessionRig rig;
  rig.robot.corrupted = 65530;
  rig.connect();
  rig.run(1000);
  EXPECT_EQ(rig.session.counters().robot_corrupted, 0u);
  rig.robot.corrupted = 4;
  rig.run(1000);
  EXPECT_EQ(rig.session.counters().robot_corrupted, 10u);
  rig.robot.corrupted = 2;
  rig.run(1000);
  EXPECT_EQ(rig.session.counters().robot_corrupted, 10u) << "an old reply changed the counter";
}

TEST(Session, CountsTheEncoderEdgesThatTheRobotMissedInThisSession) {
  SessionRig rig;
  rig.robot.missed_edges = 65530;
  rig.connect();
  rig.run(1000);
  EXPECT_EQ(rig.session.counters().missed_edges, 0u);
  rig.robot.missed_edges = 4;
  rig.run(1000);
  EXPECT_EQ(rig.session.counters().missed_edges, 10u);
  rig.robot.reboot(rig.now);
  rig.robot.missed_edges = 0;
  rig.run(1000);
  rig.robot.missed_edges = 3;
  rig.run(1000);
  EXPECT_EQ(rig.session.counters().missed_edges, 13u);
}

TEST(Session, CountsForeignBytesBeforeTheFirstFrameOnly) {
  SessionRig rig;
  rig.session.open(rig.now);
  const std::string banner = "AT+GCAP\r\nboot v1\r\n";
  std::vector<std::uint8_t> bytes(banner.begin(), banner.end());
  bytes.push_back(0);
  rig.session.receive(bytes, rig.now);
  rig.run(400);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  EXPECT_EQ(rig.session.counters().foreign_bytes, bytes.size());
  EXPECT_EQ(rig.session.counters().cobs_errors + rig.session.counters().crc_errors, 0u);
}

TEST(Session, PassesRobotFaultsAndCleansItsTexts) {
  SessionRig rig;
  rig.connect();
  wire::Log log{};
  log.device_us = 4711;
  log.text[0] = 'h';
  log.text[1] = 0x1B;
  log.text[2] = 'i';
  rig.robot.say(log);
  rig.robot.say(wire::FaultReport{1, static_cast<std::uint8_t>(Fault::battery_low), 0, 5900});
  rig.run(2);
  ASSERT_EQ(rig.count<RobotLog>(), 1);
  ASSERT_EQ(rig.count<RobotFault>(), 1);
  for (const SessionEvent& event : rig.events) {
    if (const RobotLog* said = as<RobotLog>(event)) {
      EXPECT_STREQ(said->text.data(), "h?i");
      EXPECT_EQ(said->device_us, 4711);
    }
    if (const RobotFault* fault = as<RobotFault>(event)) {
      EXPECT_EQ(fault->value, 5900);
    }
  }
}

TEST(Session, AFloodOfLogsDisplacesNoStateChange) {
  SessionRig rig;
  rig.connect();
  for (int i = 0; i < 200; ++i) rig.robot.say(wire::Log{});
  rig.robot.reboot(rig.now);
  rig.robot.say(wire::Log{});
  rig.events.clear();
  rig.run(300);
  EXPECT_EQ(rig.count<Rebooted>(), 1);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

}  // namespace
}  // namespace tp100::link
