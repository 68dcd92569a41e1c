// How a session begins with a robot, with which robots it does not, and how it ends and begins
// anew: restarts of the robot, silence, other parameters.
#include "link/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "session_rig.h"

namespace tp100::link {
namespace {

using testing::ElementsAre;
using testing::EndsWith;

// Another device may be there, which bytes would disturb.
TEST(Session, StaysSilentUntilTheRobotSpeaksAndWarnsThatNothingIsHeard) {
  SessionRig rig;
  rig.robot.silent = true;
  rig.session.open(rig.now);
  rig.session.receive(std::vector<std::uint8_t>(100, 'U'), rig.now);
  rig.run(4999);
  EXPECT_EQ(rig.count<Silence>(), 0);
  rig.run(200);
  EXPECT_EQ(rig.count<Silence>(), 1);
  EXPECT_EQ(rig.session.counters().silences, 1U);
  EXPECT_TRUE(rig.robot.received.types.empty());
  EXPECT_EQ(rig.states, "listening");
  rig.robot.silent = false;
  rig.run(400);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

TEST(Session, WhenItJoinsInTheMiddleItAsksForAHelloFiveTimesASecond) {
  SessionRig rig;
  rig.robot.state = wire::State::kRunning;
  rig.session.open(rig.now);
  rig.loses_output = true;
  rig.run(1000);
  EXPECT_EQ(rig.session.counters().frames_out, 5U);
  rig.loses_output = false;
  rig.run(500);
  EXPECT_EQ(rig.states, "listening hello parameters syncing ready");
  ASSERT_EQ(rig.robot.received.hello_requests.size(), 1u);
  EXPECT_EQ(rig.robot.received.hello_requests[0].protocol, wire::kProtocolVersion);
  EXPECT_EQ(rig.robot.received.hello_requests[0].schema, wire::kSchemaHash);
}

TEST(Session, AnotherProtocolOrSchemaIsRefusedUntilTheBoardIsFlashed) {
  for (const bool protocol : {true, false}) {
    for (const bool after_a_session : {true, false}) {
      SessionRig rig;
      if (after_a_session) rig.connect();
      if (protocol) rig.robot.protocol = 7;
      if (!protocol) rig.robot.schema ^= 1;
      rig.robot.reboot(rig.now);
      rig.robot.received = {};
      after_a_session ? rig.run(400) : rig.connect();
      EXPECT_EQ(rig.session.state(), SessionState::kRefused);
      EXPECT_EQ(rig.count<VersionMismatch>(), 1);
      EXPECT_EQ(rig.session.counters().refused, 1u);
      EXPECT_EQ(rig.session.hello().protocol, rig.robot.protocol);
      EXPECT_EQ(rig.session.hello().schema, rig.robot.schema);
      EXPECT_TRUE(rig.robot.received.types.empty()) << "it must not understand anything";
      rig.robot.protocol = wire::kProtocolVersion;
      rig.robot.schema = wire::kSchemaHash;
      rig.robot.reboot(rig.now);
      rig.run(500);
      EXPECT_EQ(rig.session.state(), SessionState::kReady);
      EXPECT_FALSE(rig.session.take_rebooted()) << "no boot of this version was known";
    }
  }
}

// Protocol, firmware version and schema open every hello, whatever its version.
TEST(Session, ReadsTheVersionOfAHelloOfAnotherSize) {
  for (const std::size_t size : {8U, 9U, 18U, 30U}) {
    SCOPED_TRACE(size);
    SessionRig rig;
    rig.session.open(rig.now);
    std::vector<std::uint8_t> payload(size, 0x11);
    payload[0] = 9;
    payload[1] = 0;
    rig.session.receive(frame_of(static_cast<std::uint8_t>(wire::Type::kHello), payload), rig.now);
    EXPECT_EQ(rig.session.state(), size < 9 ? SessionState::kListening : SessionState::kRefused);
    EXPECT_EQ(rig.session.counters().wrong_size, size < 9 ? 1U : 0U);
    EXPECT_EQ(rig.session.hello().protocol, size < 9 ? 0 : 9);
  }
}

TEST(Session, AHelloThatNoBoardOfOursSendsIsRefusedOnceAndNotSpokenTo) {
  for (const bool nonce : {true, false}) {
    SessionRig rig;
    rig.robot.boot_nonce = nonce ? 0 : 5;
    // The robot reports an unknown state and keeps sending hellos.
    rig.mangle = [&](std::vector<std::uint8_t>& bytes) {
      if (bytes.empty() || nonce) return;
      wire::Hello hello{wire::kProtocolVersion, {0, 1, 0}, wire::kSchemaHash, 2, 5, 0, 6, 0};
      bytes = frame_of(hello);
    };
    rig.session.open(rig.now);
    rig.run(1000);
    EXPECT_EQ(rig.session.state(), SessionState::kRefused);
    ASSERT_EQ(rig.count<BadHello>(), 1);
    EXPECT_EQ(rig.of<BadHello>()[0].boot_nonce, nonce ? 0U : 5U);
    EXPECT_EQ(rig.of<BadHello>()[0].state, nonce ? 0 : 6);
    EXPECT_EQ(rig.session.counters().refused, 1u);
    EXPECT_TRUE(rig.robot.received.types.empty());
    rig.mangle = {};
    rig.robot.reboot(rig.now);
    rig.run(500);
    EXPECT_EQ(rig.session.state(), SessionState::kReady);
  }
}

TEST(Session, ABoardThatIsNotKnownIsCountedAndToldAndMayDrive) {
  for (const std::uint8_t board : {std::uint8_t{2}, std::uint8_t{77}}) {
    SessionRig rig;
    rig.robot.board = board;
    rig.connect();
    EXPECT_EQ(rig.session.state(), SessionState::kReady);
    EXPECT_EQ(rig.session.counters().unknown_board, board == 77 ? 1U : 0U);
    EXPECT_EQ(rig.count<UnknownBoard>(), board == 77 ? 1 : 0);
    for (const UnknownBoard& unknown : rig.of<UnknownBoard>()) EXPECT_EQ(unknown.board, 77);
  }
}

wire::Parameters other_parameters() {
  wire::Parameters other = SessionRig::settings().parameters;
  other.wheelbase_m = 0.77F;
  return other;
}

TEST(Session, OtherParametersGoToTheSameBootInANewSessionOrWaitForARobot) {
  for (const SessionState before : {SessionState::kClosed, SessionState::kListening,
                                    SessionState::kRefused, SessionState::kReady}) {
    SessionRig rig;
    const bool ready = before == SessionState::kReady;
    rig.robot.protocol = before == SessionState::kRefused ? 7 : wire::kProtocolVersion;
    if (before == SessionState::kListening) rig.session.open(rig.now);
    if (before >= SessionState::kRefused || ready) rig.connect();
    rig.session.use(other_parameters(), rig.now);
    EXPECT_EQ(rig.session.state(), ready ? SessionState::kHello : before);
    rig.robot.protocol = wire::kProtocolVersion;
    if (!ready) rig.robot.reboot(rig.now);
    ready ? rig.run(500) : rig.connect();
    EXPECT_EQ(rig.session.state(), SessionState::kReady);
    const wire::Parameters& sent = rig.robot.received.parameters.back();
    EXPECT_EQ(sent.wheelbase_m, 0.77F);
    EXPECT_EQ(sent.boot_nonce, rig.robot.boot_nonce);
    if (!ready) continue;
    EXPECT_GT(sent.token, rig.robot.received.parameters.front().token);
    EXPECT_EQ(rig.session.counters().reboots, 0u);
    EXPECT_THAT(rig.states, EndsWith("ready hello parameters syncing ready"));
  }
}

// Without commands the robot would latch a fault after 200 ms.
TEST(Session, ChangesInQuickSuccessionAreNotSlowedDown) {
  SessionRig rig;
  rig.connect();
  for (int i = 0; i < 5; ++i) {
    // Nor by the wait after a session that did not last.
    if (i == 4) rig.robot.state = wire::State::kHello;
    rig.run(5);
    rig.session.use(SessionRig::settings().parameters, rig.now);
    rig.run(20);
    EXPECT_EQ(rig.session.state(), SessionState::kSyncing) << i;
  }
}

TEST(Session, RepeatsParametersUntilTheyAreAcknowledged) {
  SessionRig rig;
  rig.robot.answers_parameters = false;
  rig.session.open(rig.now);
  rig.run(1000);
  const auto& sent = rig.robot.received.parameters;
  EXPECT_EQ(sent.size(), 10u);
  EXPECT_EQ(sent.front().token, sent.back().token);
  // An answer to others is none.
  rig.robot.send(wire::Acknowledge{static_cast<std::uint8_t>(wire::Type::kParameters),
                                   sent.back().token - 1, 0, 0});
  rig.run(1);
  EXPECT_EQ(rig.session.state(), SessionState::kParameters);
  rig.robot.answers_parameters = true;
  rig.run(400);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

TEST(Session, ARobotThatRefusesItsParametersIsAskedAgainAsItsReasonAllows) {
  using wire::Result;
  for (const Result result : {Result::kOutOfRange, Result::kStaleToken, Result::kWrongBoot}) {
    SCOPED_TRACE(static_cast<int>(result));
    SessionRig rig;
    rig.robot.parameters_result = result;
    rig.connect();
    const auto& sent = rig.robot.received.parameters;
    EXPECT_GE(rig.count<Acknowledged>(), 1);
    if (result == Result::kOutOfRange) {
      EXPECT_EQ(rig.session.state(), SessionState::kRefused);
      EXPECT_EQ(rig.session.counters().refused, 1U);
      EXPECT_EQ(sent.size(), 1u) << "they would be refused again";
      rig.robot.parameters_result = Result::kAccepted;
      rig.robot.state = wire::State::kHello;
      rig.run(300);
      EXPECT_EQ(rig.session.state(), SessionState::kRefused) << "it is the same boot";
      rig.session.use(other_parameters(), rig.now);
    } else if (result == Result::kStaleToken) {
      ASSERT_GE(sent.size(), 2U);
      EXPECT_GT(sent[1].token, sent[0].token + 1000U) << "the robot knows a higher one";
    } else {
      EXPECT_FALSE(rig.robot.received.hello_requests.empty()) << "it may have booted";
    }
    rig.robot.parameters_result = Result::kAccepted;
    rig.run(500);
    EXPECT_EQ(rig.session.state(), SessionState::kReady);
  }
}

TEST(Session, SaysThatARobotAnswersNothingAndGoesOnAsking) {
  enum class Lack { kParameters, kClock, kLateClock };
  for (const Lack lack : {Lack::kParameters, Lack::kClock, Lack::kLateClock}) {
    SCOPED_TRACE(static_cast<int>(lack));
    SessionRig rig;
    std::vector<std::pair<HostNs, std::vector<std::uint8_t>>> under_way;
    if (lack == Lack::kLateClock) {
      rig.mangle = [&](std::vector<std::uint8_t>& bytes) {
        under_way.emplace_back(rig.now + 250 * kNsPerMs, std::exchange(bytes, {}));
        if (under_way.front().first > rig.now) return;
        bytes = under_way.front().second;
        under_way.erase(under_way.begin());
      };
    }
    rig.commands = true;
    rig.robot.answers_parameters = lack != Lack::kParameters;
    rig.robot.answers_sync = lack != Lack::kClock;
    const SessionState waits =
        lack == Lack::kParameters ? SessionState::kParameters : SessionState::kSyncing;
    rig.session.open(rig.now);
    rig.run(10'600);
    EXPECT_EQ(rig.session.state(), waits);
    EXPECT_TRUE(rig.robot.received.commands.empty()) << "they need a clock for their expiry";
    EXPECT_EQ(rig.count<Unanswered>(), 2) << "each 5 s";
    EXPECT_EQ(rig.session.counters().unanswered, 2U);
    for (const Unanswered& unanswered : rig.of<Unanswered>()) {
      EXPECT_EQ(unanswered.state, waits);
      EXPECT_EQ(unanswered.too_late_ns, lack == Lack::kLateClock ? ClockSync::kAnswerNs : 0);
    }
    rig.mangle = {};
    rig.robot.answers_parameters = rig.robot.answers_sync = true;
    rig.run(1000);
    EXPECT_EQ(rig.session.state(), SessionState::kReady);
    rig.run(6000);
    EXPECT_EQ(rig.count<Unanswered>(), 2);
  }
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

TEST(Session, ANewBootAndALostHostBeginANewSession) {
  for (const bool boot : {true, false}) {
    SessionRig rig;
    rig.connect();
    if (boot) rig.robot.reboot(rig.now);
    rig.robot.state = wire::State::kHello;
    rig.run(500);
    EXPECT_EQ(rig.session.state(), SessionState::kReady);
    EXPECT_THAT(rig.states, testing::EndsWith("ready parameters syncing ready"));
    EXPECT_EQ(rig.session.session_number(), 2u);
    EXPECT_EQ(rig.robot.received.parameters.back().boot_nonce, rig.robot.boot_nonce);
    EXPECT_EQ(rig.session.counters().reconnects, 1u);
    EXPECT_EQ(rig.count<Rebooted>(), boot ? 1 : 0);
    EXPECT_EQ(rig.session.counters().reboots, boot ? 1U : 0U);
    EXPECT_EQ(rig.session.take_rebooted(), boot);
    EXPECT_FALSE(rig.session.take_rebooted());
  }
}

// What else a robot or a bad line sends tells nothing of the robot's state.
TEST(Session, OnlySamplesKeepASessionAlive) {
  enum class Sends { kNothing, kClockReplies, kTexts, kNoise };
  for (const Sends sends : {Sends::kNothing, Sends::kClockReplies, Sends::kTexts, Sends::kNoise}) {
    SCOPED_TRACE(static_cast<int>(sends));
    SessionRig rig;
    rig.connect();
    rig.run_to_sample();
    rig.robot.samples = false;
    rig.robot.silent = sends == Sends::kNothing || sends == Sends::kNoise;
    for (int ms = 1; ms <= 500; ++ms) {
      ASSERT_EQ(rig.session.state(), SessionState::kReady) << ms;
      if (sends == Sends::kTexts) rig.robot.send(wire::Log{});
      const std::vector<std::uint8_t> noise{0x17, 0x99, 0x00, 0x55};
      if (sends == Sends::kNoise) rig.session.receive(noise, rig.now);
      rig.step();
    }
    EXPECT_EQ(rig.count<Silence>(), 1);
    EXPECT_NE(rig.session.state(), SessionState::kReady);
    EXPECT_FALSE(rig.session.clock().valid);
    rig.robot.samples = true;
    rig.robot.silent = false;
    rig.run(800);
    EXPECT_EQ(rig.session.state(), SessionState::kReady) << rig.states;
    EXPECT_EQ(rig.session.session_number(), 2u);
  }
}

TEST(Session, ARobotWithWhichNoSessionLastsIsAskedLaterAndLater) {
  SessionRig rig;
  rig.session.open(rig.now);
  // The robot loses its host after so many samples of the session; then the handshake waits.
  const auto wait_after = [&](int samples) {
    while (rig.session.state() != SessionState::kSyncing) rig.step();
    const std::uint16_t begin = rig.robot.sequence;
    while (rig.robot.sequence - begin < samples) rig.step();
    rig.robot.state = wire::State::kHello;
    const std::size_t sent = rig.robot.received.parameters.size();
    const HostNs from = rig.now + kNsPerMs;
    while (rig.robot.received.parameters.size() == sent) rig.step();
    return (rig.now - from) / kNsPerMs;
  };
  EXPECT_EQ(wait_after(200), 0) << "a session of a second lasted";
  for (const int wait_ms : {200, 400, 800, 1600, 3200, 5000, 5000})
    EXPECT_EQ(wait_after(198), wait_ms);
  EXPECT_EQ(wait_after(200), 0);
  EXPECT_EQ(wait_after(50), 200) << "it begins anew";
  // A port that goes is no reason to wait.
  for (int i = 0; i < 10; ++i) {
    rig.session.close(rig.now);
    rig.robot.reboot(rig.now);
    rig.connect();
    ASSERT_EQ(rig.session.state(), SessionState::kReady) << i;
  }
}

TEST(Session, AStreamThatMakesNoSenseLeadsToANewSession) {
  SessionRig rig;
  rig.connect();
  rig.robot.device_offset_us -= 400'000U;  // its clock went back
  rig.run(5 * (SampleIntake::kNonsense - 1));
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  rig.run(1000);
  EXPECT_EQ(rig.session.session_number(), 2U);
}

TEST(Session, APortThatIsOpenedAgainDoesNotContinueAFrame) {
  SessionRig rig;
  rig.session.open(rig.now);
  rig.session.receive(std::vector<std::uint8_t>{0x05, 'x', 'y'}, rig.now);
  rig.session.open(rig.now);
  rig.step();
  EXPECT_EQ(rig.session.state(), SessionState::kParameters) << "the first hello must be read";
}

// After its next boot the robot's clock is the same as before: only the nonce distinguishes the new
// counts from a jump.
TEST(Session, CountsOfANewBootAreNoJumpOfTheOldOne) {
  SessionSettings settings = SessionRig::settings();
  settings.parameters.max_track_mps = 0.1f;
  settings.parameters.counts_per_metre = 11140.0f;
  SessionRig rig(settings);
  rig.robot.metres_per_s = 0.1;
  rig.connect();
  rig.run(10'000);
  EXPECT_GT(rig.samples.back().left_counts, 11'000);
  rig.robot.metres_per_s = 0.0;
  rig.robot.reboot(rig.now);
  rig.session.close(rig.now);
  rig.run(11'500);
  rig.connect();
  EXPECT_EQ(rig.samples.back().left_counts, 0);
  EXPECT_EQ(rig.samples.back().right_counts, 0);
  EXPECT_EQ(rig.session.counters().implausible, 0u);
}

}  // namespace
}  // namespace tp100::link
