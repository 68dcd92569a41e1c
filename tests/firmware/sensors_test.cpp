// Tests what the board measures: encoder edges, battery and IMU.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "firmware/battery.h"
#include "firmware/quadrature.h"
#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::Fault;
using wire::State;

constexpr std::array<std::uint8_t, 4> kForward = {0, 1, 3, 2};  // A leads B

TEST(Quadrature, EveryForwardEdgeCountsUpAndEveryBackwardEdgeDown) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint8_t now = kForward[i];
    const std::uint8_t next = kForward[(i + 1) % 4];
    EXPECT_EQ(quadrature_step(now, next), 1);
    EXPECT_EQ(quadrature_step(next, now), -1);
    EXPECT_EQ(quadrature_step(now, now), 0);
    EXPECT_EQ(quadrature_step(now, static_cast<std::uint8_t>(now ^ 3U)), kIllegalStep);
  }
}

template <std::int8_t kSign>
std::int32_t counts_after(int forward, int backward) {
  Quadrature encoder{};
  std::size_t at = 0;
  for (int i = 0; i < forward + backward; ++i) {
    at = i < forward ? at + 1 : at - 1;
    take_edge<kSign>(encoder, kForward[at % 4]);
    if (i % 30'000 == 0) extended_counts(encoder);
  }
  EXPECT_EQ(encoder.missed, 0);
  return extended_counts(encoder);
}

TEST(Quadrature, CountsFarBothWays) {
  EXPECT_EQ(counts_after<1>(200'000, 0), 200'000);
  EXPECT_EQ(counts_after<1>(200'000, 300'000), -100'000);
  EXPECT_EQ(counts_after<-1>(200'000, 300'000), 100'000);
}

TEST(Quadrature, WhatChangesBothPhasesIsAMissedEdgeAndNotCounted) {
  Quadrature encoder{};
  take_edge<1>(encoder, 3);
  take_edge<1>(encoder, 0);
  EXPECT_EQ(encoder.missed, 2);
  EXPECT_EQ(extended_counts(encoder), 0);
}

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

TEST(Battery, FollowsItsReadingsInATimeConstantOf80Ms) {
  Battery battery;
  battery.update(8000, 6000);
  EXPECT_NEAR(battery.millivolts(), 8000, 1) << "at once at first";
  for (int ms = 0; ms < 80; ms += 5) battery.update(7000, 6000);
  EXPECT_NEAR(battery.millivolts(), 7000.0 + 1000.0 * std::exp(-1.0), 15.0);
}

TEST(Battery, IsLowAfterASecondBelowTheCutOff) {
  Battery battery;
  battery.update(6000, 6000);
  EXPECT_FALSE(battery.below()) << "the cut-off itself is enough";
  for (int sample = 1; sample <= 200; ++sample) {
    EXPECT_FALSE(battery.low()) << sample;
    battery.update(5900, 6000);
    EXPECT_TRUE(battery.below());
  }
  EXPECT_TRUE(battery.low());
  battery.update(5900, 0);
  EXPECT_FALSE(battery.below() || battery.low()) << "without a cut-off it is never low";
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
