// The image that users flash, on an emulated Mega: boots, the same bytes for the same inputs, full
// load, and a bad I2C bus.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "board_rig.h"
#include "support/paths.h"
#include "support/refusal.h"

namespace tp100::sim {
namespace {

TEST(AvrBoot, SaysHelloAsAMegaWithTheCauseOfTheReset) {
  AvrRig rig;
  const std::pair<PowerUp, wire::ResetCause> causes[] = {
      {PowerUp::kPowerOn, wire::ResetCause::kPowerOn},
      {PowerUp::kExternal, wire::ResetCause::kExternal},
      {PowerUp::kBrownOut, wire::ResetCause::kBrownOut},
      {PowerUp::kWatchdog, wire::ResetCause::kWatchdog}};
  for (const auto& [cause, reported] : causes) {
    ASSERT_TRUE(rig.boot(cause));
    const wire::Hello& hello = rig.hellos.back();
    EXPECT_EQ(hello.board, static_cast<std::uint8_t>(wire::BoardType::kMega2560));
    EXPECT_EQ(hello.schema, wire::kSchemaHash);
    EXPECT_EQ(hello.reset_cause, static_cast<std::uint8_t>(reported));
  }
  EXPECT_EQ(rig.bad_frames, 0);
}

TEST(AvrBoot, EachBootHasANonceOfItsOwn) {
  std::set<std::uint32_t> nonces;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    AvrRig rig({.seed = seed});
    for (int i = 0; i < 4; ++i) {
      ASSERT_TRUE(rig.boot(i % 2 == 0 ? PowerUp::kPowerOn : PowerUp::kExternal));
      nonces.insert(rig.nonce);
    }
  }
  EXPECT_EQ(nonces.size(), 12U);
  EXPECT_FALSE(nonces.contains(0));
}

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

auto session(std::uint32_t run_cycle_limit, std::uint64_t seed = 7) {
  AvrRig rig({.seed = seed, .clock_ppm = 123.0, .run_cycle_limit = run_cycle_limit});
  rig.boot();
  rig.drive();
  rig.send_bytes({0x55, 0x13, 0x00, 0xFF});
  rig.run(50);
  rig.board.reset(PowerUp::kExternal, rig.now_ns);
  rig.run(20);
  return pairs(rig.bytes);
}

TEST(AvrDeterminism, TheSameInputsGiveTheSameBytesHoweverOftenTheEmulatorLooksAtItsTimers) {
  const auto bytes = session(16000);
  EXPECT_GT(bytes.size(), 3000U);
  for (const std::uint32_t run_cycle_limit : {16000U, 50U, 1U})
    EXPECT_EQ(session(run_cycle_limit), bytes) << run_cycle_limit;
  EXPECT_NE(session(16000, 8), bytes) << "another seed is another board";
}

TEST(AvrDeterminism, AClockThatIsOffStretchesDeviceTime) {
  AvrRig rig({.clock_ppm = 500.0});
  rig.boot();
  rig.be_ready();
  rig.run(900);
  const double device_us = rig.samples.back().device_us - rig.samples.front().device_us;
  const double true_us = static_cast<double>(rig.sample_ns.back() - rig.sample_ns.front()) * 1e-3;
  EXPECT_NEAR((device_us / true_us - 1.0) * 1e6, 500.0, 100.0);
}

TEST(AvrLoad, NoEdgeIsLostAtTenKilohertzOnAllFourChannelsWithFullTraffic) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.be_ready();
  for (const double direction : {1.0, -1.0}) {
    rig.forced_mps = direction * 20'000.0 / 11'140.0;
    rig.run(500);
  }
  rig.forced_mps = 0.0;
  rig.run(30);
  ASSERT_GT(rig.samples.size(), 200U);
  EXPECT_EQ(rig.last().left_counts, rig.left.counts());
  EXPECT_EQ(rig.last().right_counts, rig.right.counts());
  EXPECT_EQ(rig.board.counters().rx_overruns, 0U);
  EXPECT_EQ(rig.bad_frames, 0);
}

TEST(AvrLoad, NoByteIsLostAtLineRate) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.be_ready();
  rig.forced_mps = 0.2;
  const std::size_t before = rig.sync_replies.size();
  std::uint16_t asked = 0;
  for (int ms = 0; ms < 500; ++ms) {
    // Each request has seven bytes; with the commands this is close to the 50 bytes that fit into a
    // millisecond.
    for (int i = 0; i < 6; ++i) rig.send(wire::SyncRequest{asked++});
    rig.run(1);
  }
  rig.run(50);
  EXPECT_EQ(rig.board.counters().rx_overruns, 0U);
  EXPECT_EQ(rig.bad_frames, 0);
  ASSERT_GT(rig.sync_replies.size(), before);
}

TEST(AvrLoad, TheReceiverHoldsThreeBytesAndLosesTheRest) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.run(10);
  const std::int64_t at_ns = rig.now_ns + 500'000;
  const std::vector<TimedByte> at_once(10, {at_ns, 0x55});
  rig.board.advance(rig.now_ns + AvrRig::kStepNs, {}, at_once);
  EXPECT_EQ(rig.board.counters().rx_overruns, 7U);
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
