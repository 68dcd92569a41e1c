// Tests the daemon's side of the link against the firmware itself.

#include "link/session.h"

#include <gtest/gtest.h>

#include <deque>

#include "../support/wire_host.h"
#include "sim/board/native_board.h"
#include "still_imu.h"

namespace tp100::sim {
namespace {

constexpr std::int64_t kByteNs = 20'000;

link::SessionSettings settings() {
  link::SessionSettings result;
  result.parameters = test::good_parameters();
  return result;
}

// A session and a board on one wire with real byte times; a step is 1 ms.
class Pair {
 public:
  explicit Pair(const NativeBoardSettings& board_settings)
      : board(board_settings, &imu), session(settings()) {
    board.set_battery(7.9);
    session.open(0);
    board.reset(PowerUp::kExternal, 0);
  }
  void run(int ms) {
    for (int i = 0; i < ms; ++i) {
      const std::int64_t until_ns = now_ns + kNsPerMs;
      std::vector<TimedByte> arriving;
      while (!wire.empty() && wire.front().at_ns <= until_ns) {
        arriving.push_back(wire.front());
        wire.pop_front();
      }
      board.advance(until_ns, {}, arriving);
      now_ns = until_ns;
      std::vector<std::uint8_t> bytes;
      for (const TimedByte& byte : board.take_sent()) bytes.push_back(byte.value);
      session.receive(bytes, now_ns);
      session.poll(now_ns);
      for (const Sample& sample : session.take_samples()) last = sample;
      if (streams && i % 5 == 0 && session.state() == SessionState::kReady) send();
      for (const std::uint8_t value : session.output()) {
        line_free_ns = std::max(line_free_ns, now_ns) + kByteNs;
        wire.push_back({line_free_ns, value});
      }
      session.written(session.output().size());
      session.take_events();
    }
  }
  void send() {
    Command command{};
    command.answers = last.sequence;
    command.speed_mps = speed_mps;
    command.expiry_us = session.clock().to_device(now_ns + 100 * kNsPerMs);
    session.send(command, now_ns);
  }

  StillImu imu;
  NativeBoard board;
  link::Session session;
  std::int64_t now_ns = 0;
  std::int64_t line_free_ns = 0;
  std::deque<TimedByte> wire;
  Sample last{};
  bool streams = true;
  double speed_mps = 0.0;
};

TEST(SessionWithFirmware, ConnectsArmsDrivesAndStops) {
  NativeBoardSettings board;
  board.clock_ppm = 300.0;
  board.start_us = 0xFFFFFFFFU - 1'500'000U;
  Pair pair(board);
  pair.run(1000);
  ASSERT_EQ(pair.session.state(), SessionState::kReady);
  EXPECT_EQ(pair.last.state, RobotState::kDisarmed);
  EXPECT_EQ(pair.last.faults, 0U);

  pair.session.request(RobotRequest::kArm, pair.now_ns);
  pair.run(50);
  EXPECT_EQ(pair.last.state, RobotState::kArmed);
  pair.speed_mps = 0.1;
  pair.run(700);
  EXPECT_EQ(pair.last.state, RobotState::kRunning);
  EXPECT_GT(pair.board.motor_duty().left, 0.0);

  pair.session.request(RobotRequest::kStop, pair.now_ns);
  pair.run(5);
  EXPECT_EQ(pair.board.motor_duty().left, 0.0);
  pair.run(50);
  EXPECT_EQ(pair.last.state, RobotState::kFaulted);
  EXPECT_FALSE(pair.session.request_pending());
  EXPECT_EQ(pair.session.counters().crc_errors, 0U);
}

TEST(SessionWithFirmware, ConnectsAgainAfterABrownOutAndStandsStill) {
  Pair pair({});
  pair.run(500);
  pair.session.request(RobotRequest::kArm, pair.now_ns);
  pair.speed_mps = 0.1;
  pair.run(300);
  ASSERT_GT(pair.board.motor_duty().left, 0.0);
  pair.board.reset(PowerUp::kBrownOut, pair.now_ns);
  EXPECT_EQ(pair.board.motor_duty().left, 0.0);
  for (int i = 0; i < 1000; ++i) {
    pair.run(1);
    ASSERT_EQ(pair.board.motor_duty().left, 0.0);
  }
  EXPECT_EQ(pair.session.state(), SessionState::kReady);
  EXPECT_EQ(pair.last.state, RobotState::kFaulted);
  EXPECT_EQ(pair.last.faults, wire::fault_bit(wire::Fault::brown_out));
}

}  // namespace
}  // namespace tp100::sim
