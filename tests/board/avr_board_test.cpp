// The image that users flash, on an emulated Mega: its file, the same bytes for the same inputs, a
// program that hangs, and a bad I2C bus.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "board_rig.h"
#include "support/paths.h"
#include "support/refusal.h"

namespace tp100::sim {
namespace {

TEST(AvrBoot, TheHexFileIsTheSameProgram) {
  AvrRig elf, hex({.image = build_path("firmware/tp100.hex")});
  for (AvrRig* rig : {&elf, &hex}) {
    rig->boot();
    rig->run(300);
  }
  EXPECT_EQ(pairs(elf.bytes), pairs(hex.bytes));
}

TEST(AvrBoot, RefusesWhatIsNoImage) {
  for (const std::string& path : {source_path("none.elf"), source_path("README.md"),
                                  source_path("CMakeLists.txt"), source_path()})
    EXPECT_THAT(test::refusal([&] { AvrBoard({.image = path}, nullptr); }),
                ::testing::HasSubstr(path));
}

auto session(std::uint64_t seed) {
  AvrRig rig({.seed = seed, .clock_ppm = 123.0});
  rig.boot();
  rig.drive();
  rig.send_bytes({0x55, 0x13, 0x00, 0xFF});
  rig.run(50);
  rig.board.reset(PowerUp::kExternal, rig.now_ns);
  rig.run(20);
  return pairs(rig.bytes);
}

TEST(AvrDeterminism, TheSameInputsGiveTheSameBytes) {
  const auto bytes = session(7);
  EXPECT_GT(bytes.size(), 3000U);
  EXPECT_EQ(session(7), bytes);
  EXPECT_NE(session(8), bytes) << "another seed is another board";
}

// The timer that switches the motors off after 100 ms may hang, too.
TEST(AvrWatchdog, AHungProgramRestartsTheBoardAfterAQuarterOfASecond) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.drive();
  ASSERT_TRUE(rig.moves());
  std::uint8_t* const next = rig.board.core().flash() + rig.board.core().program_counter();
  const std::array<std::uint8_t, 2> before{next[0], next[1]};
  next[0] = 0xFF;  // a jump to itself
  next[1] = 0xCF;
  int ms = 0;
  for (; ms < 1000 && rig.board.counters().watchdog_resets == 0; ++ms) rig.run(1);
  EXPECT_NEAR(ms, 250, 25);
  EXPECT_FALSE(rig.moves());
  std::ranges::copy(before, next);
  rig.hellos.clear();
  rig.run(1500);
  ASSERT_FALSE(rig.hellos.empty());
  EXPECT_EQ(rig.hellos[0].reset_cause, static_cast<std::uint8_t>(wire::ResetCause::kWatchdog));
}

class AvrI2cFault : public ::testing::TestWithParam<I2cFault> {};

TEST_P(AvrI2cFault, ABadBusStopsNeitherEncodersNorFramesNorTheFailSafe) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.drive();
  ASSERT_TRUE(rig.moves());
  rig.board.set_i2c_fault(GetParam());
  rig.run(100);
  const std::size_t before = rig.samples.size();
  rig.forced_mps = 0.2;
  rig.run(1000);
  // A burst that times out delays its own sample, so a few samples are late and none is lost.
  EXPECT_GT(rig.samples.size() - before, 150U);
  for (std::size_t i = before; i < rig.samples.size(); ++i) {
    ASSERT_EQ(static_cast<std::uint16_t>(rig.samples[i - 1].sequence + 1), rig.samples[i].sequence);
  }
  EXPECT_EQ(rig.board.counters().rx_overruns, 0U);
  EXPECT_EQ(rig.board.counters().watchdog_resets, 0U);
  rig.forced_mps = 0.0;
  rig.streams = false;
  EXPECT_GE(rig.ms_until_off(205), 0);
  rig.run(120);
  EXPECT_EQ(rig.last().left_counts, rig.left.counts());
  EXPECT_EQ(rig.last().right_counts, rig.right.counts());
}

std::string fault_name(const ::testing::TestParamInfo<I2cFault>& test) {
  return test.param == I2cFault::kSilent ? "Silent"
         : test.param == I2cFault::kHeld ? "Held"
                                         : "Stuck";
}

INSTANTIATE_TEST_SUITE_P(Faults, AvrI2cFault,
                         ::testing::Values(I2cFault::kSilent, I2cFault::kHeld, I2cFault::kStuck),
                         fault_name);

TEST(AvrI2c, WhatTheSensorMeasuresReachesTheHostAlsoAfterItHeldTheBus) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.be_ready();
  for (const I2cFault fault : {I2cFault::kNone, I2cFault::kHeld}) {
    rig.board.set_i2c_fault(fault);
    rig.run(1000);
    EXPECT_NEAR(rig.last().accel[2] / wire::kAccelLsbPerG, 1.0, 0.05);
    EXPECT_NEAR(rig.last().accel[0] / wire::kAccelLsbPerG, 0.0, 0.05);
    EXPECT_EQ(rig.last().imu_age, 0);
    EXPECT_NEAR(rig.last().battery_mv, 8000, 20);
  }
}

}  // namespace
}  // namespace tp100::sim
