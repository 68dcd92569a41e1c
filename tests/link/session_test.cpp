#include "link/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

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
    rig.robot.receive(out, rig.now);
    rig.session.written(out.size());
  }
  EXPECT_GT(spare.size(), 20u);
  EXPECT_LT(*spare.rbegin(), 51u);
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

}  // namespace
}  // namespace tp100::link
