// How sessions end and begin anew: restarts of the robot, silence, half-open links.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "session_rig.h"

namespace tp100::link {
namespace {

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
    chatter.robot.send(wire::Log{});
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

TEST(Session, APortThatIsOpenedAgainDoesNotContinueAFrame) {
  SessionRig rig;
  rig.session.open(rig.now);
  const std::vector<std::uint8_t> half{0x05, 'x', 'y'};
  rig.session.receive(half, rig.now);
  rig.session.open(rig.now);
  rig.step();
  EXPECT_EQ(rig.session.state(), SessionState::kParameters) << "the first hello must be read";
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
