#include "link/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "session_bench.h"

namespace tp100::link {
namespace {

TEST(Session, PassesItsStatesInOrderAndDeliversSamples) {
  SessionBench bench;
  bench.connect();
  EXPECT_EQ(bench.states, "listening parameters syncing ready");
  EXPECT_EQ(bench.session.session_number(), 1u);
  ASSERT_GT(bench.samples.size(), 20u);
  EXPECT_EQ(bench.session.counters().lost, 0u);
  EXPECT_TRUE(bench.robot.received.hello_requests.empty());
  ASSERT_EQ(bench.robot.received.parameters.size(), 1u);
  EXPECT_EQ(bench.robot.received.parameters[0].boot_nonce, bench.robot.boot_nonce);
}

TEST(Session, StaysSilentUntilTheRobotSpeaks) {
  SessionBench bench;
  bench.robot.silent = true;
  bench.session.open(bench.now);
  bench.run(3000);
  const std::vector<std::uint8_t> banner(100, 'U');
  bench.session.receive(banner, bench.now);
  bench.run(100);
  EXPECT_TRUE(bench.session.output().empty());
  EXPECT_TRUE(bench.robot.received.types.empty());
  EXPECT_EQ(bench.states, "listening");
}

TEST(Session, WarnsWhenNothingIsHeardAndKeepsListening) {
  SessionBench bench;
  bench.robot.silent = true;
  bench.session.open(bench.now);
  bench.run(5200);
  EXPECT_EQ(bench.count<Silence>(), 1);
  EXPECT_EQ(bench.session.state(), SessionState::kListening);
  bench.robot.silent = false;
  bench.run(400);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
}

TEST(Session, AsksForAHelloWhenItJoinsInTheMiddle) {
  SessionBench bench;
  bench.robot.state = wire::State::kRunning;
  bench.connect();
  EXPECT_EQ(bench.states, "listening hello parameters syncing ready");
  EXPECT_EQ(bench.robot.received.hello_requests.size(), 1u);
}

TEST(Session, GivesTheSameSamplesHoweverTheBytesAreSplit) {
  SessionBench whole;
  whole.connect();
  for (std::size_t split = 1; split <= wire::kMaxFrame; ++split) {
    SessionBench bench;
    bench.split = split;
    bench.connect();
    ASSERT_EQ(bench.samples.size(), whole.samples.size()) << split;
    ASSERT_EQ(bench.samples.back().device_us, whole.samples.back().device_us) << split;
    ASSERT_EQ(bench.states, whole.states) << split;
  }
}

TEST(Session, RefusesAnotherProtocolOrSchemaAndFallsSilent) {
  for (const bool older : {true, false}) {
    SessionBench bench;
    if (older) bench.robot.protocol = 7;
    if (!older) bench.robot.schema ^= 1;
    bench.connect();
    EXPECT_EQ(bench.session.state(), SessionState::kRefused);
    EXPECT_EQ(bench.count<VersionMismatch>(), 1);
    EXPECT_EQ(bench.session.hello().protocol, bench.robot.protocol);
    EXPECT_EQ(bench.session.counters().refused, 1u);
    EXPECT_TRUE(bench.robot.received.types.empty());
  }
}

TEST(Session, ABoardThatSpeaksAnotherProtocolAfterARestartIsRefusedToo) {
  SessionBench bench;
  bench.connect();
  ASSERT_EQ(bench.session.state(), SessionState::kReady);
  bench.robot.protocol = 7;
  bench.robot.reboot(bench.now);
  bench.run(400);
  EXPECT_EQ(bench.session.state(), SessionState::kRefused);
  EXPECT_EQ(bench.count<VersionMismatch>(), 1);
}

TEST(Session, UnpluggedInAnyMillisecondItConnectsAgainDisarmed) {
  for (int ms = 1; ms <= 400; ++ms) {
    SessionBench bench;
    bench.commands = true;
    bench.session.open(bench.now);
    bench.run(ms);
    bench.session.request(RobotRequest::kArm, bench.now);
    bench.run(2);
    bench.session.close(bench.now);
    EXPECT_TRUE(bench.session.output().empty()) << ms;
    EXPECT_FALSE(bench.session.request_pending()) << ms;
    bench.run(20);
    bench.robot.reboot(bench.now);
    bench.robot.received = {};
    bench.connect();
    ASSERT_EQ(bench.session.state(), SessionState::kReady) << ms;
    ASSERT_TRUE(bench.robot.received.arms.empty()) << ms;
  }
}

TEST(Session, LostAnswersToClockRequestsAreAskedForAgain) {
  SessionBench bench;
  bench.robot.answers_sync = false;
  bench.commands = true;
  bench.connect();
  EXPECT_EQ(bench.session.state(), SessionState::kSyncing);
  EXPECT_TRUE(bench.robot.received.commands.empty())
      << "a command needs an expiry, and that needs a clock";
  bench.robot.answers_sync = true;
  bench.run(1000);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
  // From here on, three of four exchanges are lost.
  for (int i = 0; i < 4000; ++i) {
    bench.robot.answers_sync = bench.robot.received.sync_requests % 4 == 0;
    bench.step();
  }
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
  EXPECT_TRUE(bench.session.clock().valid);
  EXPECT_LT(bench.session.clock().uncertainty_us, 1000.0);
}

TEST(Session, ClockRequestsAreSpreadOverAMillisecondOfTheWire) {
  SessionBench bench;
  bench.connect();
  bench.port_takes = false;
  std::set<std::size_t> spare;
  for (int ms = 0; ms < 20'000; ++ms) {
    bench.step();
    const auto out = bench.session.output();
    if (out.empty()) continue;
    spare.insert(static_cast<std::size_t>(
        std::find_if(out.begin(), out.end(), [](std::uint8_t byte) { return byte != 0; }) -
        out.begin()));
    bench.robot.hear(out, bench.now);
    bench.session.written(out.size());
  }
  EXPECT_GT(spare.size(), 20u);
  EXPECT_LT(*spare.rbegin(), 51u);
}

TEST(Session, ABoardThatIsNotKnownIsCountedAndToldAndMayDrive) {
  SessionBench bench;
  bench.robot.board = 77;
  bench.connect();
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
  EXPECT_GE(bench.session.counters().unknown_board, 1u);
  ASSERT_GE(bench.count<UnknownBoard>(), 1);
  const auto told = std::find_if(bench.events.begin(), bench.events.end(), [](const auto& event) {
    return as<UnknownBoard>(event) != nullptr;
  });
  EXPECT_EQ(std::get<UnknownBoard>(told->what).board, 77);
  SessionBench known;
  known.connect();
  EXPECT_EQ(known.session.counters().unknown_board, 0u);
}

TEST(Session, AHelloThatNoBoardOfOursSendsIsRefusedOnceAndNotSpokenTo) {
  for (const bool nonce : {true, false}) {
    SessionBench bench;
    bench.robot.boot_nonce = nonce ? 0 : 5;
    // The robot reports an unknown state and keeps sending hellos.
    bench.mangle = [&](std::vector<std::uint8_t>& bytes) {
      if (bytes.empty() || nonce) return;
      wire::Hello hello{wire::kProtocolVersion, {0, 1, 0}, wire::kSchemaHash, 2, 5, 0, 9, 0};
      bytes = frame_of(hello);
    };
    bench.session.open(bench.now);
    bench.run(1000);
    EXPECT_EQ(bench.session.state(), SessionState::kRefused);
    EXPECT_EQ(bench.count<BadHello>(), 1);
    EXPECT_EQ(bench.session.counters().refused, 1u);
    EXPECT_EQ(bench.session.counters().implausible, 0u);
    EXPECT_TRUE(bench.robot.received.types.empty());
    bench.mangle = {};
    bench.robot.reboot(bench.now);
    bench.run(500);
    EXPECT_EQ(bench.session.state(), SessionState::kReady);
  }
}

TEST(Session, ReadsTheVersionOfAHelloWithMoreFields) {
  SessionBench bench;
  bench.session.open(bench.now);
  std::vector<std::uint8_t> payload(30, 0x11);
  payload[0] = 9;
  payload[1] = 0;
  std::vector<std::uint8_t> frame(wire::kMaxFrame);
  frame.resize(wire::encode_frame(static_cast<std::uint8_t>(wire::Type::kHello), payload.data(),
                                  payload.size(), frame.data()));
  bench.session.receive(frame, bench.now);
  EXPECT_EQ(bench.session.state(), SessionState::kRefused);
  EXPECT_EQ(bench.session.hello().protocol, 9);
}

TEST(Session, ConnectsOnceTheRefusedBoardWasFlashed) {
  SessionBench bench;
  bench.robot.protocol = 7;
  bench.connect();
  bench.robot.protocol = wire::kProtocolVersion;
  bench.robot.reboot(bench.now);
  bench.run(500);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
  EXPECT_FALSE(bench.session.take_rebooted());
}

TEST(Session, NoticesARebootAndStartsAnew) {
  SessionBench bench;
  bench.connect();
  bench.robot.reboot(bench.now);
  bench.run(400);
  EXPECT_EQ(bench.count<Rebooted>(), 1);
  EXPECT_EQ(bench.session.counters().reboots, 1u);
  EXPECT_EQ(bench.session.counters().reconnects, 1u);
  EXPECT_TRUE(bench.session.take_rebooted());
  EXPECT_FALSE(bench.session.take_rebooted());
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
  EXPECT_EQ(bench.session.session_number(), 2u);
  EXPECT_EQ(bench.robot.received.parameters.back().boot_nonce, bench.robot.boot_nonce);
}

TEST(Session, ShakesHandsAgainWhenTheRobotLostTheHost) {
  SessionBench bench;
  bench.connect();
  bench.robot.state = wire::State::kHello;
  bench.run(500);
  EXPECT_EQ(bench.session.counters().reboots, 0u);
  EXPECT_FALSE(bench.session.take_rebooted());
  EXPECT_EQ(bench.session.session_number(), 2u);
  EXPECT_THAT(bench.states, ::testing::EndsWith("ready parameters syncing ready"));
}

TEST(Session, OtherParametersGoToTheSameBootInANewSession) {
  SessionBench bench;
  bench.connect();
  wire::Parameters other = SessionBench::settings().parameters;
  other.wheelbase_m = 0.77F;
  bench.session.use(other, bench.now);
  bench.run(500);
  EXPECT_EQ(bench.robot.received.parameters.back().wheelbase_m, 0.77F);
  EXPECT_EQ(bench.robot.received.parameters.back().boot_nonce, bench.robot.boot_nonce);
  EXPECT_EQ(bench.session.counters().reboots, 0u);
  EXPECT_EQ(bench.session.session_number(), 2u);
  EXPECT_THAT(bench.states, ::testing::EndsWith("ready hello parameters syncing ready"));
}

// Without commands the robot would latch a fault after 200 ms.
TEST(Session, ChangesInQuickSuccessionAreNotSlowedDown) {
  SessionBench bench;
  bench.connect();
  for (int i = 0; i < 5; ++i) {
    bench.session.use(SessionBench::settings().parameters, bench.now);
    bench.run(20);
    EXPECT_EQ(bench.session.state(), SessionState::kSyncing) << i;
  }
}

TEST(Session, ARobotThatRefusedItsParametersTakesOthers) {
  SessionBench bench;
  bench.robot.parameters_result = wire::Result::kOutOfRange;
  bench.connect();
  ASSERT_EQ(bench.session.state(), SessionState::kRefused);
  bench.robot.parameters_result = wire::Result::kAccepted;
  bench.session.use(SessionBench::settings().parameters, bench.now);
  bench.run(500);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
}

TEST(Session, OtherParametersWithoutARobotWaitForOne) {
  SessionBench bench;
  wire::Parameters other = SessionBench::settings().parameters;
  other.wheelbase_m = 0.77F;
  bench.session.use(other, bench.now);
  EXPECT_EQ(bench.session.state(), SessionState::kClosed);
  bench.connect();
  EXPECT_EQ(bench.robot.received.parameters.back().wheelbase_m, 0.77F);
}

TEST(Session, RepeatsParametersUntilTheyAreAcknowledged) {
  SessionBench bench;
  bench.robot.answers_parameters = false;
  bench.session.open(bench.now);
  bench.run(1000);
  EXPECT_EQ(bench.session.state(), SessionState::kParameters);
  const auto& sent = bench.robot.received.parameters;
  ASSERT_GE(sent.size(), 9u);
  ASSERT_LE(sent.size(), 11u);
  EXPECT_EQ(sent.front().token, sent.back().token);
  bench.robot.answers_parameters = true;
  bench.run(400);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
}

TEST(Session, StopsWithAnEventWhenParametersAreOutOfRange) {
  SessionBench bench;
  bench.robot.parameters_result = wire::Result::kOutOfRange;
  bench.connect();
  EXPECT_EQ(bench.session.state(), SessionState::kRefused);
  EXPECT_EQ(bench.robot.received.parameters.size(), 1u);
  EXPECT_EQ(bench.count<Acknowledged>(), 1);
}

TEST(Session, TimesOutWhenGoodFramesStopAndRecovers) {
  SessionBench bench;
  bench.connect();
  bench.robot.silent = true;
  bench.run(480);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
  bench.run(25);
  EXPECT_EQ(bench.count<Silence>(), 1);
  EXPECT_EQ(bench.session.state(), SessionState::kListening);
  EXPECT_FALSE(bench.session.clock().valid);
  bench.robot.silent = false;
  bench.run(600);
  EXPECT_EQ(bench.session.state(), SessionState::kReady) << bench.states;
  EXPECT_EQ(bench.session.session_number(), 2u);
}

TEST(Session, OnlySamplesKeepASessionAlive) {
  SessionBench bench;
  bench.connect();
  bench.robot.samples = false;
  bench.run(510);
  EXPECT_GT(bench.robot.received.sync_requests, 3);
  EXPECT_EQ(bench.count<Silence>(), 1) << "replies to clock requests do not count as samples";
  EXPECT_NE(bench.session.state(), SessionState::kReady);
  SessionBench chatter;
  chatter.connect();
  chatter.robot.samples = false;
  for (int i = 0; i < 510; ++i) {
    chatter.robot.say(wire::Log{});
    chatter.step();
  }
  EXPECT_EQ(chatter.count<Silence>(), 1);
}

TEST(Session, ARobotWithWhichNoSessionLastsIsAskedLaterAndLater) {
  SessionBench bench;
  // The samples' sequence number never changes: each session ends as soon as this is detected.
  bench.connect();
  int sessions = 0;
  for (int i = 0; i < 30000; ++i) {
    bench.robot.sequence = 7;
    const std::uint32_t before = bench.session.session_number();
    bench.step();
    sessions += static_cast<int>(bench.session.session_number() - before);
  }
  // The waits are 0.2, 0.4, 0.8, 1.6, 3.2, 5, 5 ... seconds, each followed by an attempt of 0.5 s.
  EXPECT_GE(sessions, 5);
  EXPECT_LE(sessions, 10);
  // A robot that works again is retried without a long wait, and after its next failure at once.
  bench.run(7000);
  ASSERT_EQ(bench.session.state(), SessionState::kReady);
  bench.robot.state = wire::State::kHello;
  bench.run(600);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
}

TEST(Session, APortThatGoesIsNoReasonToWait) {
  SessionBench bench;
  for (int i = 0; i < 10; ++i) {
    bench.robot.reboot(bench.now);
    bench.connect();
    ASSERT_EQ(bench.session.state(), SessionState::kReady) << i;
    bench.session.close(bench.now);
  }
}

TEST(Session, ADisarmUnderWayEndsWithItsSession) {
  SessionBench bench;
  bench.connect();
  bench.robot.answers_requests = false;
  bench.session.request(RobotRequest::kDisarm, bench.now);
  bench.run(20);
  ASSERT_TRUE(bench.session.request_pending());
  bench.robot.reboot(bench.now);
  bench.robot.received = {};
  bench.run(400);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
  EXPECT_FALSE(bench.session.request_pending());
  EXPECT_TRUE(bench.robot.received.disarms.empty()) << "its token belongs to another boot";
}

TEST(Session, CountsAndTimesOfAnEarlierBootAreForgotten) {
  SessionBench bench;
  // The robot has been up for more than half an hour, so its time is far from that of the next
  // boot.
  bench.robot.device_offset_us = 2'400'000'000U;
  bench.robot.metres_per_s = 0.1;
  bench.connect();
  const DeviceUs before_us = bench.samples.back().device_us;
  const std::int64_t before_counts = bench.samples.back().left_counts;
  bench.run(2000);
  EXPECT_GT(bench.samples.back().left_counts, before_counts);
  bench.robot.device_offset_us = 0;
  bench.robot.metres_per_s = 0.0;
  bench.robot.reboot(bench.now);
  bench.samples.clear();
  bench.run(500);
  ASSERT_EQ(bench.session.state(), SessionState::kReady);
  ASSERT_FALSE(bench.samples.empty());
  EXPECT_LT(bench.samples.back().device_us, 1'000'000);
  EXPECT_LT(bench.samples.back().device_us, before_us);
  EXPECT_EQ(bench.samples.back().left_counts, 0);
  EXPECT_EQ(bench.session.counters().implausible, 0u);
}

// The robot is as old after its next boot as it was before: only the nonce tells the new counts
// from a jump.
TEST(Session, CountsOfANewBootAreNoJumpOfTheOldOne) {
  SessionSettings settings = SessionBench::settings();
  settings.parameters.max_track_mps = 0.1f;
  settings.parameters.counts_per_metre = 11140.0f;
  SessionBench bench(settings);
  bench.robot.metres_per_s = 0.1;
  bench.connect();
  bench.run(10'000);
  const Sample before = bench.samples.back();
  EXPECT_GT(before.left_counts, 11'000);
  bench.session.close(bench.now);
  bench.robot.metres_per_s = 0.0;
  bench.robot.reboot(bench.now);
  bench.run(11'500);
  bench.connect();
  ASSERT_EQ(bench.session.state(), SessionState::kReady);
  const Sample& after = bench.samples.back();
  EXPECT_GT(after.device_us, before.device_us);
  EXPECT_LT(after.device_us, before.device_us + 1'000'000);
  EXPECT_EQ(after.left_counts, 0);
  EXPECT_EQ(after.right_counts, 0);
  EXPECT_EQ(bench.session.counters().implausible, 0u);
}

TEST(Session, CommandsGoOnWhereTheRobotIsInTheNextSession) {
  SessionBench bench;
  bench.commands = true;
  bench.connect();
  // Another host has controlled the robot in the meantime.
  bench.robot.state = wire::State::kHello;
  bench.robot.received.commands.push_back({});
  bench.robot.received.commands.back().sequence = 40000;
  bench.commands = false;
  bench.run(20);
  bench.commands = true;
  bench.run(400);
  ASSERT_EQ(bench.session.state(), SessionState::kReady);
  EXPECT_GT(bench.robot.received.commands.back().sequence, 40000);
}

TEST(Session, TellsWhatBecameOfArmAndDisarm) {
  SessionBench bench;
  bench.connect();
  bench.session.request(RobotRequest::kArm, bench.now);
  EXPECT_EQ(bench.session.take_answer(), RequestAnswer::kNone);
  bench.run(20);
  EXPECT_EQ(bench.session.take_answer(), RequestAnswer::kAcknowledged);
  EXPECT_EQ(bench.session.take_answer(), RequestAnswer::kNone);
  bench.session.request(RobotRequest::kDisarm, bench.now);
  bench.run(20);
  EXPECT_EQ(bench.session.take_answer(), RequestAnswer::kAcknowledged);
  bench.robot.answers_requests = false;
  bench.session.request(RobotRequest::kDisarm, bench.now);
  bench.run(210);
  EXPECT_EQ(bench.session.take_answer(), RequestAnswer::kFailed);
}

TEST(Session, ADisarmThatIsRefusedIsNotConfirmed) {
  SessionBench bench;
  bench.connect();
  bench.robot.answers_requests = false;
  bench.session.request(RobotRequest::kDisarm, bench.now);
  bench.run(20);
  bench.robot.say(wire::Acknowledge{static_cast<std::uint8_t>(wire::Type::kDisarm),
                                    bench.robot.received.disarms.back().token,
                                    static_cast<std::uint8_t>(wire::Result::kWrongState), 0});
  bench.run(5);
  EXPECT_EQ(bench.session.take_answer(), RequestAnswer::kFailed);
}

TEST(Session, AStopThatIsAskedForAgainIsTheSameOne) {
  SessionBench bench;
  bench.connect();
  bench.robot.answers_requests = false;
  for (int i = 0; i < 10; ++i) {
    bench.session.request(RobotRequest::kStop, bench.now);
    bench.run(100);
  }
  EXPECT_EQ(bench.count<NotAcknowledged>(), 1);
  EXPECT_EQ(bench.robot.received.stops.front().token, bench.robot.received.stops.back().token);
}

TEST(Session, GarbageAloneIsNoLife) {
  SessionBench bench;
  bench.connect();
  bench.robot.silent = true;
  for (int i = 0; i < 600; ++i) {
    const std::vector<std::uint8_t> noise{0x17, 0x99, 0x00, 0x55};
    bench.session.receive(noise, bench.now);
    bench.step();
  }
  EXPECT_EQ(bench.session.state(), SessionState::kListening);
  const LinkCounters& counters = bench.session.counters();
  EXPECT_GT(counters.crc_errors + counters.cobs_errors + counters.undersize, 400u);
}

TEST(Session, ArmIsAcknowledgedOnceWithAFreshToken) {
  SessionBench bench;
  bench.connect();
  bench.session.request(RobotRequest::kArm, bench.now);
  bench.run(50);
  bench.session.request(RobotRequest::kDisarm, bench.now);
  bench.run(50);
  bench.session.request(RobotRequest::kArm, bench.now);
  bench.run(50);
  ASSERT_EQ(bench.robot.received.arms.size(), 2u);
  ASSERT_EQ(bench.robot.received.disarms.size(), 1u);
  EXPECT_LT(bench.robot.received.arms[0].token, bench.robot.received.disarms[0].token);
  EXPECT_LT(bench.robot.received.disarms[0].token, bench.robot.received.arms[1].token);
  EXPECT_GT(bench.robot.received.arms[0].token, bench.robot.received.parameters[0].token);
  EXPECT_NE(bench.session.take_answer(), RequestAnswer::kFailed);
  EXPECT_EQ(bench.robot.state, wire::State::kArmed);
}

TEST(Session, TokensExceedThoseOfAnEarlierDaemon) {
  SessionBench first;
  first.connect();
  first.session.request(RobotRequest::kArm, first.now);
  first.run(50);
  SessionBench second;
  second.now = first.now;
  second.robot = first.robot;
  second.robot.received = {};
  second.connect();
  ASSERT_FALSE(second.robot.received.parameters.empty());
  EXPECT_GT(second.robot.received.parameters[0].token, first.robot.received.arms[0].token);
}

TEST(Session, AnUnacknowledgedArmIsRefusedAfter200MsAndALateAnswerDisarms) {
  SessionBench bench;
  bench.connect();
  bench.robot.answers_requests = false;
  bench.session.request(RobotRequest::kArm, bench.now);
  bench.run(190);
  EXPECT_NE(bench.session.take_answer(), RequestAnswer::kFailed);
  bench.run(20);
  EXPECT_EQ(bench.session.take_answer(), RequestAnswer::kFailed);
  EXPECT_EQ(bench.count<NotAcknowledged>(), 1);
  const auto& arms = bench.robot.received.arms;
  EXPECT_GE(arms.size(), 6u);
  EXPECT_LE(arms.size(), 8u);
  EXPECT_EQ(arms.front().token, arms.back().token);
  EXPECT_EQ(arms.front().expiry_us, arms.back().expiry_us);

  bench.robot.answers_requests = true;
  for (int again = 0; again < 2; ++again) {
    bench.robot.say(
        wire::Acknowledge{static_cast<std::uint8_t>(wire::Type::kArm), arms.back().token, 0, 0});
    bench.run(20);
    EXPECT_EQ(bench.robot.received.disarms.size(), 1u);
  }
}

TEST(Session, AnArmWithoutASessionIsRefusedAtOnce) {
  SessionBench bench;
  bench.session.request(RobotRequest::kArm, bench.now);
  EXPECT_EQ(bench.session.take_answer(), RequestAnswer::kFailed);
  bench.connect();
  EXPECT_TRUE(bench.robot.received.arms.empty());
}

TEST(Session, AnArmUnderWayEndsWithItsSession) {
  SessionBench bench;
  bench.connect();
  bench.robot.answers_requests = false;
  bench.session.request(RobotRequest::kArm, bench.now);
  bench.run(20);
  bench.robot.reboot(bench.now);
  const std::size_t before = bench.robot.received.arms.size();
  bench.run(400);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
  EXPECT_EQ(bench.robot.received.arms.size(), before);
  EXPECT_EQ(bench.session.take_answer(), RequestAnswer::kFailed);
}

TEST(Session, ARefusedArmIsReported) {
  SessionBench bench;
  bench.robot.arm_result = wire::Result::kFaultPersists;
  bench.connect();
  bench.session.request(RobotRequest::kArm, bench.now);
  bench.run(20);
  EXPECT_EQ(bench.session.take_answer(), RequestAnswer::kFailed);
  EXPECT_EQ(bench.robot.received.arms.size(), 1u);
}

TEST(Session, LearnsFromAStaleToken) {
  SessionBench bench;
  bench.robot.arm_result = wire::Result::kStaleToken;
  bench.connect();
  bench.session.request(RobotRequest::kArm, bench.now);
  bench.run(20);
  bench.session.request(RobotRequest::kArm, bench.now);
  bench.run(20);
  ASSERT_EQ(bench.robot.received.arms.size(), 2u);
  EXPECT_GT(bench.robot.received.arms[1].token, bench.robot.received.arms[0].token + 1000u);
}

TEST(Session, StopSupersedesArmAndIsRepeatedUntilAcknowledged) {
  SessionBench bench;
  bench.connect();
  bench.robot.answers_requests = false;
  bench.session.request(RobotRequest::kArm, bench.now);
  bench.session.request(RobotRequest::kStop, bench.now);
  bench.run(210);
  EXPECT_TRUE(bench.robot.received.arms.empty());
  EXPECT_EQ(bench.session.take_answer(), RequestAnswer::kFailed);
  EXPECT_GE(bench.robot.received.stops.size(), 6u);
  EXPECT_EQ(bench.count<NotAcknowledged>(), 2);
  bench.robot.answers_requests = true;
  bench.run(300);
  EXPECT_FALSE(bench.session.request_pending());
}

TEST(Session, StopIsTheFirstThingSentOnTheNextSession) {
  SessionBench bench;
  bench.connect();
  bench.session.close(bench.now);
  bench.session.request(RobotRequest::kStop, bench.now);
  bench.run(300);
  EXPECT_EQ(bench.count<NotAcknowledged>(), 1);
  bench.robot.received = {};
  bench.robot.state = wire::State::kHello;
  bench.connect();
  ASSERT_FALSE(bench.robot.received.types.empty());
  EXPECT_EQ(bench.robot.received.types[0], static_cast<std::uint8_t>(wire::Type::kStop));
  EXPECT_FALSE(bench.session.request_pending());
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
}

TEST(Session, CommandsCarryNonceAscendingSequenceAndExpiry) {
  SessionBench bench;
  bench.commands = true;
  bench.connect();
  bench.command.pose.yaw_rad = 0.25;
  bench.command.speed_mps = 0.1;
  bench.command.expiry_us = (DeviceUs{1} << 32U) + 77;
  bench.command.answers = 42;
  bench.run(3);
  const auto& commands = bench.robot.received.commands;
  ASSERT_GT(commands.size(), 10u);
  for (std::size_t i = 1; i < commands.size(); ++i) {
    ASSERT_EQ(commands[i].sequence, static_cast<std::uint16_t>(commands[i - 1].sequence + 1));
  }
  EXPECT_EQ(commands.back().boot_nonce, bench.robot.boot_nonce);
  EXPECT_FLOAT_EQ(commands.back().yaw_rad, 0.25F);
  EXPECT_FLOAT_EQ(commands.back().speed_mps, 0.1F);
  EXPECT_EQ(commands.back().expiry_us, 77u);
  EXPECT_EQ(commands.back().answers, 42);
}

TEST(Session, CommandSequenceContinuesAboveThatOfAnEarlierDaemon) {
  SessionBench first;
  first.commands = true;
  first.connect();
  SessionBench second;
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
  SessionBench bench;
  bench.commands = true;
  bench.connect();
  bench.port_takes = false;
  bench.run(100);
  const std::uint64_t overflow = bench.session.counters().unwritten;
  EXPECT_GT(overflow, 50u);
  bench.session.written(10);
  bench.session.drop_output();
  EXPECT_GT(bench.session.counters().unwritten, overflow);
  EXPECT_TRUE(bench.session.output().empty());
  bench.port_takes = true;
  const std::size_t before = bench.robot.received.commands.size();
  bench.run(5);
  EXPECT_EQ(bench.robot.received.commands.size(), before + 5);
}

TEST(Session, HalfOpenLinkIsNoticedByTheRobotsHello) {
  SessionBench bench;
  bench.connect();
  bench.loses_output = true;
  bench.run(300);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
  bench.robot.state = wire::State::kHello;
  bench.run(300);
  EXPECT_EQ(bench.session.state(), SessionState::kParameters);
}

TEST(Session, SaysThatARobotAnswersNothingAndGoesOnAsking) {
  const auto unanswered = [](SessionBench& bench) {
    std::vector<SessionState> states;
    for (const SessionEvent& event : bench.events)
      if (const Unanswered* silent = as<Unanswered>(event)) states.push_back(silent->state);
    EXPECT_EQ(bench.session.counters().unanswered, states.size());
    return states;
  };
  using testing::ElementsAre;
  SessionBench deaf;
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

  SessionBench timeless;
  timeless.robot.answers_sync = false;
  timeless.session.open(timeless.now);
  timeless.run(5200);
  EXPECT_THAT(unanswered(timeless), ElementsAre(SessionState::kSyncing));
}

TEST(Session, CountsWhatTheRobotSaysCameCorrupted) {
  SessionBench bench;
  bench.robot.corrupted = 65530;
  bench.connect();
  bench.run(1000);
  EXPECT_EQ(bench.session.counters().robot_corrupted, 0u);
  bench.robot.corrupted = 4;
  bench.run(1000);
  EXPECT_EQ(bench.session.counters().robot_corrupted, 10u);
  bench.robot.corrupted = 2;
  bench.run(1000);
  EXPECT_EQ(bench.session.counters().robot_corrupted, 10u) << "an old reply changed the counter";
}

TEST(Session, CountsTheEncoderEdgesThatTheRobotMissedInThisSession) {
  SessionBench bench;
  bench.robot.missed_edges = 65530;
  bench.connect();
  bench.run(1000);
  EXPECT_EQ(bench.session.counters().missed_edges, 0u);
  bench.robot.missed_edges = 4;
  bench.run(1000);
  EXPECT_EQ(bench.session.counters().missed_edges, 10u);
  bench.robot.reboot(bench.now);
  bench.robot.missed_edges = 0;
  bench.run(1000);
  bench.robot.missed_edges = 3;
  bench.run(1000);
  EXPECT_EQ(bench.session.counters().missed_edges, 13u);
}

TEST(Session, CountsForeignBytesBeforeTheFirstFrameOnly) {
  SessionBench bench;
  bench.session.open(bench.now);
  const std::string banner = "AT+GCAP\r\nboot v1\r\n";
  std::vector<std::uint8_t> bytes(banner.begin(), banner.end());
  bytes.push_back(0);
  bench.session.receive(bytes, bench.now);
  bench.run(400);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
  EXPECT_EQ(bench.session.counters().foreign_bytes, bytes.size());
  EXPECT_EQ(bench.session.counters().cobs_errors + bench.session.counters().crc_errors, 0u);
}

TEST(Session, PassesRobotFaultsAndCleansItsTexts) {
  SessionBench bench;
  bench.connect();
  wire::Log log{};
  log.device_us = 4711;
  log.text[0] = 'h';
  log.text[1] = 0x1B;
  log.text[2] = 'i';
  bench.robot.say(log);
  bench.robot.say(wire::FaultReport{1, static_cast<std::uint8_t>(Fault::battery_low), 0, 5900});
  bench.run(2);
  ASSERT_EQ(bench.count<RobotLog>(), 1);
  ASSERT_EQ(bench.count<RobotFault>(), 1);
  for (const SessionEvent& event : bench.events) {
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
  SessionBench bench;
  bench.connect();
  for (int i = 0; i < 200; ++i) bench.robot.say(wire::Log{});
  bench.robot.reboot(bench.now);
  bench.robot.say(wire::Log{});
  bench.events.clear();
  bench.run(300);
  EXPECT_EQ(bench.count<Rebooted>(), 1);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
}

}  // namespace
}  // namespace tp100::link
