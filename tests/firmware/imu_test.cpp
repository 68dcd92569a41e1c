// Tests that a failure of the sensor does not affect anything else.

#include <gtest/gtest.h>

#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::Fault;
using wire::State;

TEST(Imu, IsConfigured) {
  Rig rig;
  EXPECT_EQ(rig.hal.reg(0x6B) & 0x40, 0) << "awake";
  EXPECT_EQ(rig.hal.reg(0x1B), 0x10) << "+-1000 deg/s";
  EXPECT_EQ(rig.hal.reg(0x1C), 0x08) << "+-4 g";
  EXPECT_EQ(rig.hal.reg(0x1A), 0x03) << "low pass 42 Hz";
  EXPECT_EQ(rig.hal.reg(0x19), 0x00) << "1 kHz";
}

TEST(Imu, DeadFromTheStartNeverStopsFramesOrTheFailSafe) {
  Rig rig(false);
  rig.hal.imu_answers = false;
  rig.hal.i2c_timeout_us = 4000;
  rig.boot();
  rig.connect();
  rig.streams = true;
  rig.samples.clear();
  rig.run(1000);
  EXPECT_TRUE(rig.has(Fault::imu_missing));
  EXPECT_FALSE(rig.has(Fault::imu_stale));
  ASSERT_FALSE(rig.reports.empty());
  EXPECT_EQ(rig.reports[0].fault, static_cast<std::uint8_t>(Fault::imu_missing));
  EXPECT_GT(rig.reports[0].detail, 0) << "the detail counts the missing answers";
  EXPECT_GT(rig.samples.size(), 180U);
  EXPECT_EQ(rig.samples.back().imu_age, 255);
  rig.streams = false;
  rig.run(900);
  EXPECT_TRUE(rig.has(Fault::command_timeout));
}

TEST(Imu, IsTriedAgainEvery105MsAndNotMoreOften) {
  Rig rig(false);
  rig.hal.imu_answers = false;
  rig.boot();
  const int calls = rig.hal.i2c_calls;
  rig.run(2110);
  EXPECT_NEAR(rig.hal.i2c_calls - calls, 21, 1);
  EXPECT_NEAR(rig.hal.recoveries, 21, 1);
}

TEST(Imu, IsMissingHoweverLongItDoesNotAnswer) {
  ScriptedHal hal;
  hal.imu_answers = false;
  Imu imu(hal);
  imu.start();
  for (int i = 0; i < 7000; ++i) {
    imu.update();
    ASSERT_TRUE(imu.missing()) << i;
  }
}

TEST(Imu, ThatDiesWhileDrivingStopsTheRobotWithinAnInstantIfTheGyroSteers) {
  Rig rig;
  rig.tracks_follow = true;
  rig.drive();
  rig.run(100);
  ASSERT_EQ(rig.program.faults(), 0);
  rig.hal.imu_answers = false;
  rig.run(100);
  EXPECT_TRUE(rig.has(Fault::imu_stale));
  EXPECT_FALSE(rig.has(Fault::imu_missing)) << "the IMU had answered before";
  EXPECT_FALSE(rig.motors_on());
}

TEST(Imu, ThatDiesOnAStandStopsNothing) {
  Rig rig;
  rig.tracks_follow = true;
  rig.parameters.flags = 0;
  rig.drive();
  rig.hal.imu_answers = false;
  rig.run(1000);
  EXPECT_EQ(rig.program.state(), State::kRunning);
  EXPECT_TRUE(rig.motors_on());
  EXPECT_GT(rig.samples.back().imu_age, 100);
}

TEST(Imu, AFewFailedReadsAreBridged) {
  Rig rig;
  rig.tracks_follow = true;
  rig.drive();
  for (int i = 0; i < 20; ++i) {
    rig.hal.imu_answers = false;
    rig.run(20);
    rig.hal.imu_answers = true;
    rig.run(80);
  }
  EXPECT_EQ(rig.program.state(), State::kRunning);
  EXPECT_EQ(rig.program.faults(), 0);
}

TEST(Imu, TheBusIsFreedAfterThreeFailedReadsInARowAndNotBefore) {
  Rig rig;
  rig.connect();
  rig.hal.imu_answers = false;
  rig.run(10);
  rig.hal.imu_answers = true;
  rig.run(5);
  rig.hal.imu_answers = false;
  rig.run(10);
  EXPECT_EQ(rig.hal.recoveries, 0);
  rig.run(5);
  EXPECT_EQ(rig.hal.recoveries, 1);
}

TEST(Imu, ValuesThatDoNotChangeAnyMoreAreStale) {
  Rig rig;
  rig.tracks_follow = true;
  rig.drive();
  rig.hal.imu_frozen = true;
  rig.run(100);
  EXPECT_TRUE(rig.has(Fault::imu_stale));
  EXPECT_FALSE(rig.motors_on());
}

TEST(Imu, ThatComesBackDelivers) {
  Rig rig;
  rig.tracks_follow = true;
  rig.drive();
  rig.hal.imu_answers = false;
  rig.run(1000);
  rig.hal.imu_answers = true;
  rig.run(150);
  EXPECT_EQ(rig.samples.back().imu_age, 0);
  rig.arm();
  EXPECT_EQ(rig.program.faults(), 0);
  rig.run(50);
  EXPECT_EQ(rig.program.state(), State::kRunning);
}

}  // namespace
}  // namespace tp100::firmware
