// Tests which commands move a robot.

#include <gtest/gtest.h>

#include <limits>

#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::State;

// The robot is armed and at standstill; the next command decides whether it moves.
class Commands : public testing::Test {
 protected:
  Commands() {
    rig.connect();
    rig.streams = true;
    rig.run(50);
    rig.arm();
    rig.run(20);
    rig.streams = false;
    rig.speed_mps = 0.1f;
  }

  // True if `command` alone moves the robot within 30 ms.
  bool moves(const wire::Command& command) {
    EXPECT_EQ(rig.program.state(), State::kArmed);
    rig.send(command);
    rig.run(30);
    return rig.motors_on() || rig.program.state() == State::kRunning;
  }
  bool corrupted_moves(const std::function<void(wire::Command&)>& corrupt) {
    wire::Command command = rig.command();
    corrupt(command);
    return moves(command);
  }

  Rig rig;
};

TEST_F(Commands, AGoodOneMoves) {
  EXPECT_TRUE(moves(rig.command()));
  EXPECT_EQ(rig.program.last_verdict(), Verdict::kAccepted);
}

TEST_F(Commands, OneOfAnotherBootDoesNot) {
  EXPECT_FALSE(corrupted_moves([](auto& c) { c.boot_nonce ^= 0x100U; }));
  EXPECT_EQ(rig.program.last_verdict(), Verdict::kWrongBoot);
}

TEST_F(Commands, ARepeatedOneDoesNot) {
  EXPECT_FALSE(
      corrupted_moves([](auto& c) { c.sequence = static_cast<std::uint16_t>(c.sequence - 1); }));
  EXPECT_EQ(rig.program.last_verdict(), Verdict::kRepeated);
}

TEST_F(Commands, AnOlderOneDoesNot) {
  EXPECT_FALSE(corrupted_moves(
      [](auto& c) { c.sequence = static_cast<std::uint16_t>(c.sequence - 30000); }));
  EXPECT_EQ(rig.program.last_verdict(), Verdict::kRepeated);
}

TEST_F(Commands, AnExpiredOneDoesNot) {
  EXPECT_FALSE(corrupted_moves([this](auto& c) { c.expiry_us = rig.hal.now_us - 1; }));
  EXPECT_EQ(rig.program.last_verdict(), Verdict::kExpired);
}

TEST_F(Commands, OneThatExpiresTooFarAheadDoesNot) {
  EXPECT_FALSE(corrupted_moves([this](auto& c) { c.expiry_us = rig.hal.now_us + 202'000; }));
  EXPECT_EQ(rig.program.last_verdict(), Verdict::kTooFarAhead);
}

TEST_F(Commands, OneThatAnswersAnUnknownSampleDoesNot) {
  EXPECT_FALSE(
      corrupted_moves([](auto& c) { c.answers = static_cast<std::uint16_t>(c.answers + 5); }));
  EXPECT_EQ(rig.program.last_verdict(), Verdict::kUnknownSample);
}

TEST_F(Commands, OneThatAnswersAnOldSampleDoesNot) {
  rig.speed_mps = 0.0f;
  rig.streams = true;
  rig.run(400);
  rig.streams = false;
  rig.speed_mps = 0.1f;
  // 42 samples back is 210 ms, which is outside yaw_window_ms but still in the history.
  EXPECT_FALSE(
      corrupted_moves([](auto& c) { c.answers = static_cast<std::uint16_t>(c.answers - 42); }));
  EXPECT_EQ(rig.program.last_verdict(), Verdict::kUnknownSample);
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
      EXPECT_EQ(rig.program.last_verdict(), Verdict::kOutOfRange) << i << " " << value;
      // The robot must stay armed for the next command.
      const float speed = rig.speed_mps;
      rig.speed_mps = 0.0f;
      rig.send(rig.command());
      rig.speed_mps = speed;
      rig.run(5);
    }
  }
}

TEST_F(Commands, ARefusedOneDoesNotUseUpItsSequence) {
  wire::Command command = rig.command();
  command.speed_mps = kNan;
  ASSERT_FALSE(moves(command));
  command.speed_mps = 0.1f;
  command.expiry_us = rig.hal.now_us + 150'000;
  EXPECT_TRUE(moves(command));
}

TEST_F(Commands, StandingStillKeepsTheRobotArmedButNotRunning) {
  rig.speed_mps = 0.0f;
  rig.streams = true;
  rig.run(300);
  EXPECT_EQ(rig.program.state(), State::kArmed);
  EXPECT_EQ(rig.hal.nonzero_writes, 0);
}

TEST_F(Commands, TheSequenceWraps) {
  rig.streams = true;
  rig.sequence = 32000;  // within half a range of the last one
  rig.run(20);
  rig.sequence = 64000;
  rig.run(20);
  rig.sequence = 65530;
  rig.run(200);
  EXPECT_LT(rig.sequence, 100);
  EXPECT_EQ(rig.program.state(), State::kRunning);
  EXPECT_TRUE(rig.motors_on());
}

TEST(CommandsWithoutArm, MoveNothing) {
  Rig rig;
  rig.connect();
  rig.streams = true;
  rig.speed_mps = 0.15f;
  rig.run(2000);
  EXPECT_EQ(rig.program.state(), State::kDisarmed);
  EXPECT_EQ(rig.hal.nonzero_writes, 0);
  EXPECT_EQ(rig.program.faults(), 0);
}

TEST(CommandsWithoutParameters, MoveNothing) {
  Rig rig;
  rig.streams = true;
  rig.speed_mps = 0.15f;
  rig.run(500);
  rig.arm();
  rig.run(500);
  EXPECT_EQ(rig.program.state(), State::kHello);
  EXPECT_EQ(rig.hal.nonzero_writes, 0);
}

TEST(CommandsAfterParameters, TheFirstIsNewWhateverItsSequence) {
  Rig rig;
  rig.drive();
  rig.send(wire::Disarm{5});
  rig.run(2);
  rig.streams = false;
  rig.sequence = static_cast<std::uint16_t>(rig.sequence - 500);
  rig.connect();
  rig.send(rig.command());
  rig.run(2);
  EXPECT_EQ(rig.program.last_verdict(), Verdict::kAccepted);
}

TEST(CommandsOfAnEarlierBoot, AreIgnored) {
  Rig old;
  old.drive();
  const wire::Command late = old.command();
  Rig rig(false);
  rig.hal.nonce = 0xB008;
  rig.hal.now_us = old.hal.now_us - 100'000;
  rig.boot();
  rig.connect();
  rig.streams = true;
  rig.run(20);
  rig.arm();
  rig.streams = false;
  for (int i = 0; i < 10; ++i) {
    rig.send(late);
    rig.run(5);
  }
  EXPECT_EQ(rig.hal.nonzero_writes, 0);
  EXPECT_EQ(rig.program.last_verdict(), Verdict::kWrongBoot);
}

}  // namespace
}  // namespace tp100::firmware
