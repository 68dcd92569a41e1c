// What flows in a session: commands and clock requests to the robot, samples, counts and texts of
// it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "core/arithmetic.h"
#include "session_rig.h"
#include "support/sequence.h"

namespace tp100::link {
namespace {

TEST(SessionCommands, CarryWhatIsCommandedWithNonceAndAscendingSequence) {
  SessionRig rig;
  rig.commands = true;
  rig.connect();
  rig.command = {.answers = 42,
                 .pose = {.x_m = 1.5, .y_m = -2.25, .yaw_rad = 0.25},
                 .desired_yaw_rad = 0.5,
                 .yaw_rate_radps = -0.75,
                 .speed_mps = 0.125,
                 .gyro_bias_radps = 0.0625,
                 .expiry_us = (DeviceUs{1} << 32U) + 77};
  rig.run(3);
  const auto& commands = rig.robot.received.commands;
  ASSERT_GT(commands.size(), 10u);
  for (std::size_t i = 1; i < commands.size(); ++i)
    ASSERT_EQ(commands[i].sequence, static_cast<std::uint16_t>(commands[i - 1].sequence + 1));
  const wire::Command& sent = commands.back();
  EXPECT_EQ(sent.boot_nonce, rig.robot.boot_nonce);
  EXPECT_EQ(sent.answers, 42);
  EXPECT_EQ(sent.x_m, 1.5F);
  EXPECT_EQ(sent.y_m, -2.25F);
  EXPECT_EQ(sent.yaw_rad, 0.25F);
  EXPECT_EQ(sent.desired_yaw_rad, 0.5F);
  EXPECT_EQ(sent.yaw_rate_radps, -0.75F);
  EXPECT_EQ(sent.speed_mps, 0.125F);
  EXPECT_EQ(sent.gyro_bias_radps, 0.0625F);
  EXPECT_EQ(sent.expiry_us, 77u) << "device times wrap";
}

// An earlier daemon, or another host in the meantime, has sent some.
TEST(SessionCommands, GoOnWhereTheRobotIs) {
  SessionRig rig;
  rig.robot.received.commands.push_back({});
  for (const int last : {700, 40'000, 65'535}) {
    rig.robot.state = wire::State::kHello;
    rig.robot.received.commands.back().sequence = static_cast<std::uint16_t>(last);
    rig.commands = false;
    if (last == 700) rig.session.open(rig.now);
    rig.run(20);
    const std::size_t border = rig.robot.received.commands.size();
    rig.commands = true;
    rig.run(1200);
    ASSERT_EQ(rig.session.state(), SessionState::kReady);
    ASSERT_GT(rig.robot.received.commands.size(), border);
    EXPECT_EQ(rig.robot.received.commands[border].sequence, static_cast<std::uint16_t>(last + 1));
  }
}

// Commands that are refused or lost in one direction for minutes must not make those after them
// look old: the robot could not be armed for as long again.
TEST(SessionCommands, AreNewHoweverManyWereRefusedBefore) {
  SessionRig rig;
  rig.commands = true;  // each millisecond
  rig.connect();
  ASSERT_EQ(rig.session.state(), SessionState::kReady);
  for (const int refused : {1'000, 16'400, 33'000, 66'000, 140'000}) {
    auto& commands = rig.robot.received.commands;
    const std::uint16_t accepted = commands.back().sequence;
    std::uint16_t last = accepted;
    int begun_anew = 0;
    for (int ms = 0; ms < refused; ++ms) {
      rig.run(1);
      begun_anew += shared::wrapped_difference(commands.back().sequence, last) == 1 ? 0 : 1;
      last = commands.back().sequence;
      // The robot has accepted none of them.
      commands.back().sequence = accepted;
    }
    EXPECT_LE(begun_anew, refused / 16'384) << "those under way would look old";
    rig.run(20);
    EXPECT_GT(shared::wrapped_difference(commands.back().sequence, accepted), 0) << refused;
    for (std::size_t i = commands.size() - 10; i < commands.size(); ++i)
      EXPECT_EQ(shared::wrapped_difference(commands[i].sequence, commands[i - 1].sequence), 1)
          << refused;
  }
}

// A robot that has turned 159 times would refuse every command.
TEST(SessionCommands, YawsStayInTheRobotsRangeWithTheirDifference) {
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

// After 0.5 s of silence the robot considers the host lost.
TEST(SessionClock, IsAskedMoreOftenOnlyIfNothingElseIsSent) {
  SessionSettings settings = SessionRig::settings();
  settings.clock_answer_ns = 2 * kNsPerS;
  for (const bool commands : {true, false}) {
    SessionRig rig(settings);
    rig.commands = commands;
    rig.connect();
    rig.robot.answers_sync = false;
    rig.robot.received.sync_requests = 0;
    rig.run(8000);
    ASSERT_EQ(rig.session.state(), SessionState::kReady);
    EXPECT_NEAR(rig.robot.received.sync_requests, commands ? 4 : 20, 1);
    if (!commands) continue;
    rig.port_takes = false;
    rig.run(350);
    rig.commands = false;
    rig.session.drop_output();
    rig.port_takes = true;
    rig.robot.received.sync_requests = 0;
    rig.run(100);
    EXPECT_EQ(rig.robot.received.sync_requests, 1)
        << "a command that found no room is no sign of life";
  }
}

// Otherwise each reply would wait for the USB bus as long as the last one did.
TEST(SessionClock, RequestsAreSpreadOverAMillisecondOfTheWire) {
  SessionRig rig;
  rig.connect();
  rig.port_takes = false;
  std::set<std::size_t> spare;
  for (int ms = 0; ms < 20'000; ++ms) {
    rig.step();
    const auto out = rig.session.output();
    if (out.empty()) continue;
    const auto first = std::find_if(out.begin(), out.end(), [](auto byte) { return byte != 0; });
    spare.insert(static_cast<std::size_t>(first - out.begin()));
    rig.robot.receive(out, rig.now);
    rig.session.written(out.size());
  }
  EXPECT_GT(spare.size(), 20u);
  EXPECT_LT(*spare.begin(), 5u);
  EXPECT_GT(*spare.rbegin(), 45u);
  EXPECT_LT(*spare.rbegin(), 51u);
}

// Three times 0.2 m/s, at 10 000 counts a metre, are 30 counts in 5 ms; an interrupt may move 4
// more.
TEST(Session, CountsBeyondWhatTheTracksCanDoAreAJump) {
  for (const bool changed : {false, true}) {
    for (const int counts : {34, 35}) {
      SessionSettings settings = SessionRig::settings();
      settings.parameters.counts_per_metre = 10'000.0F;
      settings.parameters.max_track_mps = changed ? 5.0F : 0.2F;
      SessionRig rig(settings);
      rig.connect();
      if (changed) {
        settings.parameters.max_track_mps = 0.2F;
        rig.session.use(settings.parameters, rig.now);
        rig.run(1000);
      }
      rig.run_to_sample();
      rig.now += 5 * kNsPerMs;
      wire::Sample sample = rig.robot.sample(rig.now);
      sample.left_counts += counts;
      rig.session.receive(frame_of(sample), rig.now);
      EXPECT_EQ(rig.session.counters().implausible, counts > 34 ? 1U : 0U) << changed;
    }
  }
}

// Bits are flipped, then any bytes come between those of the robot.
TEST(Session, HandsOnOrCountsEachSampleWhateverTheLineDoes) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    SessionRig rig;
    rig.connect();
    rig.run(1000);
    test::Sequence random(seed);
    const std::size_t before = rig.samples.size();
    const std::uint16_t first = rig.robot.sequence;
    rig.mangle = [&](std::vector<std::uint8_t>& bytes) {
      if (bytes.empty() || !random.chance(0.1)) return;
      bytes[static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())))] ^=
          static_cast<std::uint8_t>(1U << random.below(8));
    };
    rig.run(5000);
    rig.mangle = nullptr;
    rig.run(50);
    const LinkCounters& counters = rig.session.counters();
    const std::uint64_t sent = static_cast<std::uint16_t>(rig.robot.sequence - first);
    ASSERT_EQ(rig.samples.size() - before + counters.lost, sent);
    ASSERT_GT(counters.corrupted(), 0u);
    ASSERT_EQ(rig.session.session_number(), 1u);
    rig.mangle = [&](std::vector<std::uint8_t>& bytes) {
      for (int i = 0; i < 200; ++i)
        bytes.push_back(static_cast<std::uint8_t>(random.chance(0.75) ? random.below(256) : 0));
    };
    rig.run(200);
    rig.mangle = nullptr;
    rig.run(1500);
    ASSERT_EQ(rig.session.state(), SessionState::kReady);
  }
}

TEST(SessionCounts, WhatTheRobotSaysItLostIsThatOfThisSession) {
  SessionRig rig;
  rig.robot.corrupted = rig.robot.missed_edges = 65530;
  rig.connect();
  const auto counted = [&](std::uint16_t corrupted, std::uint16_t missed_edges) {
    rig.robot.corrupted = corrupted;
    rig.robot.missed_edges = missed_edges;
    rig.run(1000);
    const LinkCounters& counters = rig.session.counters();
    return std::pair{counters.robot_corrupted, counters.missed_edges};
  };
  using Counts = std::pair<std::uint64_t, std::uint64_t>;
  EXPECT_EQ(counted(65530, 65530), Counts(0, 0)) << "these were lost before";
  EXPECT_EQ(counted(4, 14), Counts(10, 20));
  EXPECT_EQ(counted(2, 15), Counts(10, 20)) << "an old reply";
  EXPECT_EQ(counted(6, 13), Counts(10, 20)) << "an old reply";
  rig.robot.reboot(rig.now);
  EXPECT_EQ(counted(0, 0), Counts(10, 20));
  EXPECT_EQ(counted(1, 3), Counts(11, 23));
}

TEST(SessionCounts, FramesThatNoRobotSendsAndThoseOfAnotherSize) {
  SessionRig rig;
  rig.connect();
  const LinkCounters before = rig.session.counters();
  const auto receive = [&](int type, std::size_t size) {
    const std::vector<std::uint8_t> payload(size, 1);
    rig.session.receive(frame_of(static_cast<std::uint8_t>(type), payload), rig.now);
  };
  for (const int type : {0, 7, 0x40, 0x41, 0x47, 0xFF}) receive(type, 3);
  for (int type = 1; type <= 6; ++type) receive(type, 3);
  for (const int type : {2, 3, 4, 5, 6}) receive(type, 80);
  const LinkCounters counted = rig.session.counters() - before;
  EXPECT_EQ(counted.frames_in, 17U);
  EXPECT_EQ(counted.unknown_type, 6U);
  EXPECT_EQ(counted.wrong_size, 11U);
  EXPECT_EQ(counted.bytes_in, 12 * 3 + 5 * 80 + 17 * 5U) << "with type, checksum and framing";
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

TEST(SessionReports, FaultsAndTextsArePassedOnInPrintableCharacters) {
  SessionRig rig;
  rig.connect();
  const std::string words = "h\x1bi ~\x7f\x80 " + std::string(60, 'x');
  wire::Log log{};
  log.device_us = 4711;
  std::copy_n(words.begin(), std::min(words.size(), wire::Log::kTextSize), log.text);
  rig.robot.send(log);
  rig.robot.send(wire::FaultReport{1, static_cast<std::uint8_t>(Fault::battery_low), 0, -5900});
  rig.run(2);
  ASSERT_EQ(rig.count<RobotLog>(), 1);
  ASSERT_EQ(rig.count<RobotFault>(), 1);
  EXPECT_EQ(rig.session.counters().robot_faults, 1U);
  const std::string clean = ("h?i ~?? " + std::string(60, 'x')).substr(0, wire::Log::kTextSize);
  EXPECT_EQ(rig.of<RobotLog>()[0].text.data(), clean) << "a text that fills its frame is whole";
  EXPECT_EQ(rig.of<RobotLog>()[0].device_us, 4711U);
  EXPECT_EQ(rig.of<RobotFault>()[0].fault, static_cast<std::uint8_t>(Fault::battery_low));
  EXPECT_EQ(rig.of<RobotFault>()[0].value, -5900);
}

TEST(SessionReports, AFloodOfTextsDisplacesNoOtherEvent) {
  SessionRig rig;
  rig.connect();
  for (int i = 0; i < 200; ++i) rig.robot.send(wire::Log{});
  rig.robot.reboot(rig.now);
  for (int i = 0; i < 200; ++i) rig.robot.send(wire::Log{});
  rig.events.clear();
  rig.run(300);
  EXPECT_EQ(rig.count<Rebooted>(), 1);
  EXPECT_EQ(rig.count<RobotLog>(), static_cast<int>(SessionEvents::kCapacity / 2));
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

}  // namespace
}  // namespace tp100::link
