// The handshake: how a session begins with a robot, and with which robots it does not.
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

TEST(Session, CountsForeignBytesBeforeTheFirstFrameOnly) {
  SessionRig rig;
  rig.session.open(rig.now);
  const std::string banner = std::string("AT+GCAP\r\nboot v1\r\n") + '\0';
  rig.session.receive(std::vector<std::uint8_t>(banner.begin(), banner.end()), rig.now);
  rig.run(400);
  rig.session.receive(std::vector<std::uint8_t>{9, 'x', 0}, rig.now);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  EXPECT_EQ(rig.session.counters().foreign_bytes, banner.size());
  EXPECT_EQ(rig.session.counters().corrupted(), 1u);
}

TEST(Session, AsksForAHelloWhenItJoinsInTheMiddle) {
  SessionRig rig;
  rig.robot.state = wire::State::kRunning;
  rig.connect();
  EXPECT_EQ(rig.states, "listening hello parameters syncing ready");
  ASSERT_EQ(rig.robot.received.hello_requests.size(), 1u);
  EXPECT_EQ(rig.robot.received.hello_requests[0].protocol, wire::kProtocolVersion);
  EXPECT_EQ(rig.robot.received.hello_requests[0].schema, wire::kSchemaHash);
}

TEST(Session, AHelloThatIsNotAnsweredIsAskedForFiveTimesASecond) {
  SessionRig rig;
  rig.robot.state = wire::State::kRunning;
  rig.session.open(rig.now);
  rig.loses_output = true;
  int requests = 0;
  for (int ms = 0; ms < 1000; ++ms) {
    const std::uint64_t before = rig.session.counters().frames_out;
    rig.step();
    requests += static_cast<int>(rig.session.counters().frames_out - before);
  }
  EXPECT_EQ(requests, 5);
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
    std::vector<std::uint8_t> frame(wire::kMaxFrame);
    frame.resize(wire::encode_frame(static_cast<std::uint8_t>(wire::Type::kHello), payload.data(),
                                    payload.size(), frame.data()));
    rig.session.receive(frame, rig.now);
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
    EXPECT_EQ(rig.count<BadHello>(), 1);
    for (const SessionEvent& event : rig.events) {
      const BadHello* bad = as<BadHello>(event);
      EXPECT_TRUE(bad == nullptr ||
                  (bad->boot_nonce == (nonce ? 0U : 5U) && bad->state == (nonce ? 0 : 6)));
    }
    EXPECT_EQ(rig.session.counters().refused, 1u);
    EXPECT_EQ(rig.session.counters().implausible, 0u);
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
    for (const SessionEvent& event : rig.events)
      if (const auto* unknown = as<UnknownBoard>(event)) {
        EXPECT_EQ(unknown->board, 77);
      }
  }
}

wire::Parameters other_parameters() {
  wire::Parameters other = SessionRig::settings().parameters;
  other.wheelbase_m = 0.77F;
  return other;
}

TEST(Session, OtherParametersGoToTheSameBootInANewSession) {
  SessionRig rig;
  rig.connect();
  const std::uint32_t token = rig.robot.received.parameters.back().token;
  rig.session.use(other_parameters(), rig.now);
  rig.run(500);
  const wire::Parameters& sent = rig.robot.received.parameters.back();
  EXPECT_EQ(sent.wheelbase_m, 0.77F);
  EXPECT_EQ(sent.boot_nonce, rig.robot.boot_nonce);
  EXPECT_GT(sent.token, token);
  EXPECT_EQ(rig.session.counters().reboots, 0u);
  EXPECT_EQ(rig.session.session_number(), 2u);
  EXPECT_THAT(rig.states, EndsWith("ready hello parameters syncing ready"));
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
  // Nor by the wait after a session that did not last.
  rig.robot.state = wire::State::kHello;
  rig.run(5);
  EXPECT_EQ(rig.session.state(), SessionState::kParameters);
  rig.session.use(SessionRig::settings().parameters, rig.now);
  rig.run(20);
  EXPECT_EQ(rig.session.state(), SessionState::kSyncing);
}

TEST(Session, OtherParametersWithoutARobotWaitForOne) {
  for (const SessionState before :
       {SessionState::kClosed, SessionState::kListening, SessionState::kRefused}) {
    SessionRig rig;
    rig.robot.protocol = before == SessionState::kRefused ? 7 : wire::kProtocolVersion;
    if (before == SessionState::kListening) rig.session.open(rig.now);
    if (before == SessionState::kRefused) rig.connect();
    rig.session.use(other_parameters(), rig.now);
    EXPECT_EQ(rig.session.state(), before);
    rig.robot.protocol = wire::kProtocolVersion;
    rig.robot.reboot(rig.now);
    rig.connect();
    EXPECT_EQ(rig.session.state(), SessionState::kReady);
    EXPECT_EQ(rig.robot.received.parameters.back().wheelbase_m, 0.77F);
  }
}

TEST(Session, RepeatsParametersUntilTheyAreAcknowledged) {
  SessionRig rig;
  rig.robot.answers_parameters = false;
  rig.session.open(rig.now);
  rig.run(1000);
  EXPECT_EQ(rig.session.state(), SessionState::kParameters);
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
    rig.robot.answers_parameters = lack != Lack::kParameters;
    rig.robot.answers_sync = lack != Lack::kClock;
    const SessionState waits =
        lack == Lack::kParameters ? SessionState::kParameters : SessionState::kSyncing;
    rig.session.open(rig.now);
    rig.run(10'600);
    EXPECT_EQ(rig.session.state(), waits);
    EXPECT_EQ(rig.count<Unanswered>(), 2) << "each 5 s";
    EXPECT_EQ(rig.session.counters().unanswered, 2U);
    for (const SessionEvent& event : rig.events) {
      const Unanswered* unanswered = as<Unanswered>(event);
      if (unanswered == nullptr) continue;
      EXPECT_EQ(unanswered->state, waits);
      EXPECT_EQ(unanswered->too_late_ns, lack == Lack::kLateClock ? ClockSync::kAnswerNs : 0);
    }
    rig.mangle = {};
    rig.robot.answers_parameters = rig.robot.answers_sync = true;
    rig.run(1000);
    EXPECT_EQ(rig.session.state(), SessionState::kReady);
    rig.run(6000);
    EXPECT_EQ(rig.count<Unanswered>(), 2);
  }
}

}  // namespace
}  // namespace tp100::link
