// What a session counts, and what it passes on from the robot.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "session_rig.h"

namespace tp100::link {
namespace {

TEST(Session, ABoardThatIsNotKnownIsCountedAndToldAndMayDrive) {
  SessionRig rig;
  rig.robot.board = 77;
  rig.connect();
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
  EXPECT_GE(rig.session.counters().unknown_board, 1u);
  ASSERT_GE(rig.count<UnknownBoard>(), 1);
  const auto reported = std::find_if(rig.events.begin(), rig.events.end(), [](const auto& event) {
    return as<UnknownBoard>(event) != nullptr;
  });
  EXPECT_EQ(std::get<UnknownBoard>(reported->what).board, 77);
  SessionRig known;
  known.connect();
  EXPECT_EQ(known.session.counters().unknown_board, 0u);
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
  EXPECT_EQ(rig.session.counters().bytes_in, bytes.size());
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
  rig.robot.send(log);
  rig.robot.send(wire::FaultReport{1, static_cast<std::uint8_t>(Fault::battery_low), 0, 5900});
  rig.run(2);
  ASSERT_EQ(rig.count<RobotLog>(), 1);
  ASSERT_EQ(rig.count<RobotFault>(), 1);
  for (const SessionEvent& event : rig.events) {
    if (const RobotLog* robot_log = as<RobotLog>(event)) {
      EXPECT_STREQ(robot_log->text.data(), "h?i");
      EXPECT_EQ(robot_log->device_us, 4711);
    }
    if (const RobotFault* fault = as<RobotFault>(event)) {
      EXPECT_EQ(fault->value, 5900);
    }
  }
}

TEST(Session, ATextThatFillsItsFrameArrivesWhole) {
  SessionRig rig;
  rig.connect();
  wire::Log log{};
  std::fill_n(log.text, wire::Log::kTextSize - 1, 'x');
  log.text[wire::Log::kTextSize - 1] = '!';
  rig.robot.send(log);
  rig.run(2);
  ASSERT_EQ(rig.count<RobotLog>(), 1);
  for (const SessionEvent& event : rig.events) {
    if (const RobotLog* robot_log = as<RobotLog>(event)) {
      EXPECT_EQ(robot_log->text.data(), std::string(wire::Log::kTextSize - 1, 'x') + "!");
    }
  }
}

TEST(Session, AFloodOfLogsDisplacesNoStateChange) {
  SessionRig rig;
  rig.connect();
  for (int i = 0; i < 200; ++i) rig.robot.send(wire::Log{});
  rig.robot.reboot(rig.now);
  rig.robot.send(wire::Log{});
  rig.events.clear();
  rig.run(300);
  EXPECT_EQ(rig.count<Rebooted>(), 1);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

}  // namespace
}  // namespace tp100::link
