// Tests which commands move a robot.

#include <gtest/gtest.h>

#include <limits>

#include "bench.h"

namespace tp100::firmware {
namespace {

using wire::State;

// The robot is armed and at standstill; the next command decides whether it moves.
class Commands : public testing::Test {
 protected:
  Commands() {
    bench.connect();
    bench.streams = true;
    bench.run(50);
    bench.arm();
    bench.run(20);
    bench.streams = false;
    bench.speed_mps = 0.1f;
  }

  // True if `command` alone moves the robot within 30 ms.
  bool moves(const wire::Command& command) {
    EXPECT_EQ(bench.program.state(), State::kArmed);
    bench.send(command);
    bench.run(30);
    return bench.motors_on() || bench.program.state() == State::kRunning;
  }
  bool corrupted_moves(const std::function<void(wire::Command&)>& corrupt) {
    wire::Command command = bench.command();
    corrupt(command);
    return moves(command);
  }

  Bench bench;
};

TEST_F(Commands, AGoodOneMoves) {
  EXPECT_TRUE(moves(bench.command()));
  EXPECT_EQ(bench.program.last_verdict(), Verdict::kAccepted);
}

TEST_F(Commands, OneOfAnotherBootDoesNot) {
  EXPECT_FALSE(corrupted_moves([](auto& c) { c.boot_nonce ^= 0x100U; }));
  EXPECT_EQ(bench.program.last_verdict(), Verdict::kWrongBoot);
}

TEST_F(Commands, ARepeatedOneDoesNot) {
  EXPECT_FALSE(
      corrupted_moves([](auto& c) { c.sequence = static_cast<std::uint16_t>(c.sequence - 1); }));
  EXPECT_EQ(bench.program.last_verdict(), Verdict::kRepeated);
}

TEST_F(Commands, AnOlderOneDoesNot) {
  EXPECT_FALSE(corrupted_moves(
      [](auto& c) { c.sequence = static_cast<std::uint16_t>(c.sequence - 30000); }));
  EXPECT_EQ(bench.program.last_verdict(), Verdict::kRepeated);
}

TEST_F(Commands, AnExpiredOneDoesNot) {
  EXPECT_FALSE(corrupted_moves([this](auto& c) { c.expiry_us = bench.hal.now_us - 1; }));
  EXPECT_EQ(bench.program.last_verdict(), Verdict::kExpired);
}

TEST_F(Commands, OneThatExpiresTooFarAheadDoesNot) {
  EXPECT_FALSE(corrupted_moves([this](auto& c) { c.expiry_us = bench.hal.now_us + 202'000; }));
  EXPECT_EQ(bench.program.last_verdict(), Verdict::kTooFarAhead);
}

TEST_F(Commands, OneThatAnswersAnUnknownSampleDoesNot) {
  EXPECT_FALSE(
      corrupted_moves([](auto& c) { c.answers = static_cast<std::uint16_t>(c.answers + 5); }));
  EXPECT_EQ(bench.program.last_verdict(), Verdict::kUnknownSample);
}

TEST_F(Commands, OneThatAnswersAnOldSampleDoesNot) {
  bench.speed_mps = 0.0f;
  bench.streams = true;
  bench.run(400);
  bench.streams = false;
  bench.speed_mps = 0.1f;
  // 42 samples back is 210 ms, which is outside yaw_window_ms but still in the history.
  EXPECT_FALSE(
      corrupted_moves([](auto& c) { c.answers = static_cast<std::uint16_t>(c.answers - 42); }));
  EXPECT_EQ(bench.program.last_verdict(), Verdict::kUnknownSample);
  EXPECT_TRUE(
      corrupted_moves([](auto& c) { c.answers = static_cast<std::uint16_t>(c.answers - 30); }));
}

TEST_F(Commands, NothingThatIsNotFiniteOrOutOfRangeMoves) {
  float wire::Command::*const fields[] = {&wire::Command::x_m,
                                          &wire::Command::y_m,
                                          &wire::Command::yaw_rad,
                                          &wire::Command::desired_yaw_rad,
                                          &wire::Command::yaw_rate_radps,
                                          &wire::Command::speed_mps,
                                          &wire::Command::gyro_bias_radps};
  const float limits[] = {1e4f, 1e4f, 1e3f, 1e3f, 10.0f, 2.0f, 1.0f};
  for (std::size_t i = 0; i < std::size(fields); ++i) {
    for (const float value : {kNan, kInf, -kInf, limits[i] * 1.01f, -limits[i] * 1.01f}) {
      EXPECT_FALSE(corrupted_moves([&](auto& c) { c.*fields[i] = value; })) << i << " " << value;
      EXPECT_EQ(bench.program.last_verdict(), Verdict::kOutOfRange) << i << " " << value;
      // The robot must stay armed for the next command.
      const float speed = bench.speed_mps;
      bench.speed_mps = 0.0f;
      bench.send(bench.command());
      bench.speed_mps = speed;
      bench.run(5);
    }
  }
}

TEST_F(Commands, ARefusedOneDoesNotUseUpItsSequence) {
  wire::Command command = bench.command();
  command.speed_mps = kNan;
  ASSERT_FALSE(moves(command));
  command.speed_mps = 0.1f;
  command.expiry_us = bench.hal.now_us + 150'000;
  EXPECT_TRUE(moves(command));
}

TEST_F(Commands, StandingStillKeepsTheRobotArmedButNotRunning) {
  bench.speed_mps = 0.0f;
  bench.streams = true;
  bench.run(300);
  EXPECT_EQ(bench.program.state(), State::kArmed);
  EXPECT_EQ(bench.hal.nonzero_writes, 0);
}

TEST_F(Commands, TheSequenceWraps) {
  bench.streams = true;
  bench.sequence = 32000;  // within half a range of the last one
  bench.run(20);
  bench.sequence = 64000;
  bench.run(20);
  bench.sequence = 65530;
  bench.run(200);
  EXPECT_LT(bench.sequence, 100);
  EXPECT_EQ(bench.program.state(), State::kRunning);
  EXPECT_TRUE(bench.motors_on());
}

TEST(CommandsWithoutArm, MoveNothing) {
  Bench bench;
  bench.connect();
  bench.streams = true;
  bench.speed_mps = 0.15f;
  bench.run(2000);
  EXPECT_EQ(bench.program.state(), State::kDisarmed);
  EXPECT_EQ(bench.hal.nonzero_writes, 0);
  EXPECT_EQ(bench.program.faults(), 0);
}

TEST(CommandsWithoutParameters, MoveNothing) {
  Bench bench;
  bench.streams = true;
  bench.speed_mps = 0.15f;
  bench.run(500);
  bench.arm();
  bench.run(500);
  EXPECT_EQ(bench.program.state(), State::kHello);
  EXPECT_EQ(bench.hal.nonzero_writes, 0);
}

TEST(CommandsAfterParameters, TheFirstIsNewWhateverItsSequence) {
  Bench bench;
  bench.drive();
  bench.send(wire::Disarm{5});
  bench.run(2);
  bench.streams = false;
  bench.sequence = static_cast<std::uint16_t>(bench.sequence - 500);
  bench.connect();
  bench.send(bench.command());
  bench.run(2);
  EXPECT_EQ(bench.program.last_verdict(), Verdict::kAccepted);
}

TEST(CommandsOfAnEarlierBoot, AreIgnored) {
  Bench old;
  old.drive();
  const wire::Command late = old.command();
  Bench bench(false);
  bench.hal.nonce = 0xB008;
  bench.hal.now_us = old.hal.now_us - 100'000;
  bench.boot();
  bench.connect();
  bench.streams = true;
  bench.run(20);
  bench.arm();
  bench.streams = false;
  for (int i = 0; i < 10; ++i) {
    bench.send(late);
    bench.run(5);
  }
  EXPECT_EQ(bench.hal.nonzero_writes, 0);
  EXPECT_EQ(bench.program.last_verdict(), Verdict::kWrongBoot);
}

}  // namespace
}  // namespace tp100::firmware
