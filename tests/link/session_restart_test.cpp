// How sessions end and begin anew: restarts of the robot, silence, half-open links.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "session_rig.h"

namespace tp100::link {
namespace {

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
    EXPECT_THAT(rig.states, ::testing::EndsWith("ready parameters syncing ready"));
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
    for (const std::size_t before = rig.samples.size(); rig.samples.size() == before;) rig.step();
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
  rig.run(10);
  EXPECT_NE(rig.session.state(), SessionState::kReady);
  rig.run(1000);
  EXPECT_EQ(rig.session.session_number(), 2U);
}

TEST(Session, APortThatIsOpenedAgainDoesNotContinueAFrame) {
  SessionRig rig;
  rig.session.open(rig.now);
  const std::vector<std::uint8_t> half{0x05, 'x', 'y'};
  rig.session.receive(half, rig.now);
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

}  // namespace
}  // namespace tp100::link
