// Tests what the board measures: battery and IMU. Encoder edges: tests/board.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "firmware/battery.h"
#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::Fault;
using wire::State;

// The converter's reading of a voltage on a board with this supply.
std::uint16_t steps_of(double volts, double supply_v) {
  return static_cast<std::uint16_t>(std::clamp(volts / supply_v * 1024.0, 0.0, 1023.0));
}
double battery_read_v(double battery_v, double supply_v, double bandgap_v) {
  Supply supply;
  for (int i = 0; i < 20; ++i) supply.update(steps_of(bandgap_v, supply_v));
  return supply.battery_mv(steps_of(battery_v / 3.0, supply_v)) * 1e-3;
}

TEST(Supply, IsFiveVoltsUntilTheBandgapWasMeasured) {
  Supply supply;
  supply.update(0);
  EXPECT_EQ(supply.millivolts(), 5000);
  EXPECT_EQ(supply.battery_mv(1023), 14985);
  supply.update(256);  // the bandgap of 1.1 V is a quarter of the scale
  EXPECT_EQ(supply.millivolts(), 4400);
  supply.update(275);
  EXPECT_NEAR(supply.millivolts(), 4324, 10) << "an odd reading moves it by a quarter";
}

TEST(Supply, NoChipReadsTheBatteryHigherThanIfFiveVoltsWereAssumedNorTenPercentTooHigh) {
  for (double supply_v = 4.4; supply_v <= 5.25; supply_v += 0.05) {
    for (double bandgap_v = 1.0; bandgap_v <= 1.2; bandgap_v += 0.02) {
      const double read = battery_read_v(6.0, supply_v, bandgap_v);
      EXPECT_LE(read, 6.0 * 5.0 / supply_v + 1e-9) << supply_v << " " << bandgap_v;
      EXPECT_LE(read, 6.0 * 1.11) << supply_v << " " << bandgap_v;
      EXPECT_GE(read, 6.0 * 0.90) << supply_v << " " << bandgap_v;
    }
    for (const double battery_v : {5.4, 7.4, 8.4}) {
      if (supply_v > 5.0) continue;
      EXPECT_NEAR(battery_read_v(battery_v, supply_v, 1.1), battery_v, 0.01 * battery_v);
    }
  }
}

TEST(Imu, IsConfiguredAlsoAfterItFellAsleep) {
  Rig rig;
  rig.connect();
  // A sensor that lost its supply for a moment sleeps, and repeats its values.
  rig.hal.imu_frozen = true;
  rig.hal.i2c_write(0x68, 0x6B, 0x40);
  rig.run(110);
  EXPECT_EQ(rig.hal.reg(0x6B) & 0x40, 0) << "awake";
  EXPECT_EQ(rig.hal.reg(0x1B), 0x10) << "+-1000 deg/s";
  EXPECT_EQ(rig.hal.reg(0x1C), 0x08) << "+-4 g";
  EXPECT_EQ(rig.hal.reg(0x1A), 0x03) << "low pass 42 Hz";
  EXPECT_EQ(rig.hal.reg(0x19), 0x00) << "1 kHz";
}

TEST(Imu, EveryAxisReachesTheHost) {
  Rig rig;
  rig.hal.gyro_x = 1111;
  rig.hal.gyro_y = -2222;
  rig.hal.gyro_z = 3333;
  rig.hal.accel_x = -4444;  // up to 6 more by noise
  rig.hal.accel_y = 555;
  rig.hal.temperature = -6666;
  rig.connect();
  const wire::Sample& sample = rig.samples.back();
  EXPECT_EQ(std::to_array(sample.gyro), (std::array<std::int16_t, 3>{1111, -2222, 3333}));
  EXPECT_NEAR(sample.accel[0], -4441, 3);
  EXPECT_EQ(sample.accel[1], 555);
  EXPECT_EQ(sample.accel[2], 8192);
  EXPECT_EQ(sample.temperature, -6666);
}

TEST(Imu, DeadFromTheStartNeverStopsFramesOrTheFailSafe) {
  Rig rig(false);
  rig.hal.imu_answers = false;
  rig.hal.i2c_timeout_us = 4000;
  rig.boot();
  rig.be_ready();
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

// Whether its last values are too old or never change any more: a gyro that steers must live.
TEST(Imu, ThatDiesOrFreezesWhileDrivingStopsTheRobotAndDeliversAgain) {
  for (const bool freezes : {false, true}) {
    SCOPED_TRACE(freezes);
    Rig rig;
    bool& changed = freezes ? rig.hal.imu_frozen : rig.hal.imu_answers;
    rig.tracks_follow = true;
    rig.drive();
    rig.run(100);
    ASSERT_EQ(rig.program.faults(), 0);
    changed = !changed;
    rig.run(100);
    EXPECT_TRUE(rig.has(Fault::imu_stale));
    EXPECT_FALSE(rig.has(Fault::imu_missing)) << "the IMU had answered before";
    EXPECT_FALSE(rig.motors_on());
    rig.run(900);
    changed = !changed;
    rig.run(150);
    EXPECT_EQ(rig.samples.back().imu_age, 0);
    rig.arm();
    EXPECT_EQ(rig.program.faults(), 0);
    rig.run(50);
    EXPECT_EQ(rig.program.state(), State::kRunning);
  }
}

TEST(Imu, AFewFailedReadsAreBridgedAndTheBusIsFreedAfterThreeInARow) {
  Rig rig;
  rig.tracks_follow = true;
  rig.drive();
  for (const int failed : {2, 2, 2, 3}) {
    EXPECT_EQ(rig.hal.recoveries, 0);
    rig.hal.imu_answers = false;
    rig.run(5 * failed);
    rig.hal.imu_answers = true;
    rig.run(50);
  }
  EXPECT_EQ(rig.hal.recoveries, 1);
  EXPECT_EQ(rig.program.state(), State::kRunning);
  EXPECT_EQ(rig.program.faults(), 0);
}

}  // namespace
}  // namespace tp100::firmware
