#include <gtest/gtest.h>

#include "avr_rig.h"
#include "wire/faults.h"

namespace tp100::sim {
namespace {

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

TEST(AvrI2c, ASensorThatHoldsTheBusIsClockedFree) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.connect();
  rig.streams = true;
  rig.run(100);
  ASSERT_EQ(rig.last().imu_age, 0);
  rig.board.set_i2c_fault(I2cFault::kHeld);
  rig.run(1000);
  EXPECT_EQ(rig.last().imu_age, 0);
}

TEST(AvrI2c, ASensorThatStaysSilentIsAFaultAndForbidsToArm) {
  AvrRig rig;
  rig.board.set_i2c_fault(I2cFault::kSilent);
  ASSERT_TRUE(rig.boot());
  rig.connect();
  rig.streams = true;
  rig.run(300);
  EXPECT_EQ(rig.last().imu_age, 255);
  EXPECT_EQ(rig.arm().result, static_cast<std::uint8_t>(wire::Result::kFaultPersists));
}

TEST(AvrI2c, AFrozenSensorStopsTheRobotAndIsNamed) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.drive();
  ASSERT_TRUE(rig.moves());
  rig.imu.freeze();
  EXPECT_GE(rig.ms_until_off(200), 0);
  rig.run(20);
  ASSERT_FALSE(rig.reports.empty());
  EXPECT_EQ(rig.reports.back().fault, static_cast<std::uint8_t>(wire::Fault::imu_stale));
}

TEST(AvrI2c, WhatTheSensorMeasuresReachesTheHost) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.connect();
  rig.streams = true;
  rig.run(200);
  EXPECT_NEAR(rig.last().accel[2] / wire::kAccelLsbPerG, 1.0, 0.05);
  EXPECT_NEAR(rig.last().accel[0] / wire::kAccelLsbPerG, 0.0, 0.05);
  EXPECT_EQ(rig.last().imu_age, 0);
  EXPECT_NEAR(rig.last().battery_mv, 8000, 20);
}

}  // namespace
}  // namespace tp100::sim
