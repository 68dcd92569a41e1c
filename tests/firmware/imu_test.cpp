// Tests that a failure of the sensor does not affect anything else.

#include <gtest/gtest.h>

#include "bench.h"

namespace tp100::firmware {
namespace {

using wire::Fault;
using wire::State;

TEST(Imu, IsConfigured) {
  Bench bench;
  EXPECT_EQ(bench.hal.reg(0x6B) & 0x40, 0) << "awake";
  EXPECT_EQ(bench.hal.reg(0x1B), 0x10) << "+-1000 deg/s";
  EXPECT_EQ(bench.hal.reg(0x1C), 0x08) << "+-4 g";
  EXPECT_EQ(bench.hal.reg(0x1A), 0x03) << "low pass 42 Hz";
  EXPECT_EQ(bench.hal.reg(0x19), 0x00) << "1 kHz";
}

TEST(Imu, DeadFromTheStartNeverStopsFramesOrTheFailSafe) {
  Bench bench(false);
  bench.hal.imu_answers = false;
  bench.hal.i2c_timeout_us = 4000;
  bench.boot();
  bench.connect();
  bench.streams = true;
  bench.samples.clear();
  bench.run(1000);
  EXPECT_TRUE(bench.has(Fault::imu_missing));
  EXPECT_FALSE(bench.has(Fault::imu_stale));
  ASSERT_FALSE(bench.reports.empty());
  EXPECT_EQ(bench.reports[0].fault, static_cast<std::uint8_t>(Fault::imu_missing));
  EXPECT_GT(bench.reports[0].detail, 0) << "the detail counts the missing answers";
  EXPECT_GT(bench.samples.size(), 180U);
  EXPECT_EQ(bench.samples.back().imu_age, 255);
  bench.streams = false;
  bench.run(900);
  EXPECT_TRUE(bench.has(Fault::command_timeout));
}

TEST(Imu, IsTriedAgainEvery100MsAndNotMoreOften) {
  Bench bench(false);
  bench.hal.imu_answers = false;
  bench.boot();
  const int calls = bench.hal.i2c_calls;
  bench.run(2000);
  EXPECT_NEAR(bench.hal.i2c_calls - calls, 20, 2);
  EXPECT_NEAR(bench.hal.recoveries, 20, 2);
}

TEST(Imu, ThatDiesWhileDrivingStopsTheRobotWithinAnInstantIfTheGyroSteers) {
  Bench bench;
  bench.tracks_follow = true;
  bench.drive();
  bench.run(100);
  ASSERT_EQ(bench.program.faults(), 0);
  bench.hal.imu_answers = false;
  bench.run(100);
  EXPECT_TRUE(bench.has(Fault::imu_stale));
  EXPECT_FALSE(bench.has(Fault::imu_missing)) << "the IMU had answered before";
  EXPECT_FALSE(bench.motors_on());
}

TEST(Imu, ThatDiesOnABenchStopsNothing) {
  Bench bench;
  bench.tracks_follow = true;
  bench.parameters.flags = 0;
  bench.drive();
  bench.hal.imu_answers = false;
  bench.run(1000);
  EXPECT_EQ(bench.program.state(), State::kRunning);
  EXPECT_TRUE(bench.motors_on());
  EXPECT_GT(bench.samples.back().imu_age, 100);
}

TEST(Imu, AFewFailedReadsAreBridged) {
  Bench bench;
  bench.tracks_follow = true;
  bench.drive();
  for (int i = 0; i < 20; ++i) {
    bench.hal.imu_answers = false;
    bench.run(20);
    bench.hal.imu_answers = true;
    bench.run(80);
  }
  EXPECT_EQ(bench.program.state(), State::kRunning);
  EXPECT_EQ(bench.program.faults(), 0);
}

TEST(Imu, ValuesThatDoNotChangeAnyMoreAreStale) {
  Bench bench;
  bench.tracks_follow = true;
  bench.drive();
  bench.hal.imu_frozen = true;
  bench.run(100);
  EXPECT_TRUE(bench.has(Fault::imu_stale));
  EXPECT_FALSE(bench.motors_on());
}

TEST(Imu, ThatComesBackDelivers) {
  Bench bench;
  bench.tracks_follow = true;
  bench.drive();
  bench.hal.imu_answers = false;
  bench.run(1000);
  bench.hal.imu_answers = true;
  bench.run(150);
  EXPECT_EQ(bench.samples.back().imu_age, 0);
  bench.arm();
  EXPECT_EQ(bench.program.faults(), 0);
  bench.run(50);
  EXPECT_EQ(bench.program.state(), State::kRunning);
}

}  // namespace
}  // namespace tp100::firmware
