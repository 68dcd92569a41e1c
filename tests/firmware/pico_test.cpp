#include <gtest/gtest.h>

#include "pico/scaling.h"

namespace tp100::firmware::pico {
namespace {

TEST(Pico, TheClocksAreWithinWhatThePllsMayDoAndTheBaudRateIsExact) {
  for (const std::uint32_t feedback : {kSysFeedback, kAdcFeedback}) {
    EXPECT_GE(feedback * (kCrystalHz / 1'000'000), 750U);
    EXPECT_LE(feedback * (kCrystalHz / 1'000'000), 1600U);
  }
  EXPECT_EQ(kSysHz, 125'000'000U);
  EXPECT_LE(kSysHz, 133'000'000U);
  EXPECT_EQ(kCrystalHz * kAdcFeedback / (kAdcDivider1 * kAdcDivider2), 48'000'000U);
  EXPECT_DOUBLE_EQ(kSysHz / (16.0 * kUartDivider64 / 64.0), wire::kBaud);
}

TEST(Pico, ADutyIsALevelAndFullDutyIsNeverLow) {
  EXPECT_EQ(pwm_level(0), 0);
  EXPECT_EQ(pwm_level(1), 1);
  EXPECT_EQ(pwm_level(-250), 250);
  // The output is low from the level on: a level above the counter's top never comes.
  EXPECT_GT(pwm_level(wire::kFullDuty), kPwmTop);
  EXPECT_GT(pwm_level(-wire::kFullDuty), kPwmTop);
  EXPECT_EQ(pwm_level(INT16_MIN), wire::kFullDuty);
  EXPECT_NEAR(kSysHz / (kPwmDivider * (kPwmTop + 1.0)), 490.0, 1.0);
}

TEST(Pico, AFullBatteryIsWithinTheScaleOfTheConverter) {
  EXPECT_EQ(battery_mv(0), 0);
  // 8.4 V behind the divider are 2.8 V at the pin.
  EXPECT_NEAR(battery_mv(static_cast<std::uint16_t>(2.8 / 3.3 * 4096)), 8400, 3);
  EXPECT_NEAR(battery_mv(4095), 9900, 5);
}

}  // namespace
}  // namespace tp100::firmware::pico
