#include "sim/sensors/mpu6050.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tp100::sim {
namespace {

class Mpu6050Test : public testing::Test {
 protected:
  static void set(Mpu6050& imu, std::uint8_t reg, std::uint8_t value) {
    const std::array<std::uint8_t, 2> bytes = {reg, value};
    ASSERT_TRUE(imu.write(bytes));
  }
  static std::int16_t word(Mpu6050& imu, std::uint8_t reg) {
    const std::array<std::uint8_t, 1> pointer = {reg};
    std::array<std::uint8_t, 2> bytes{};
    EXPECT_TRUE(imu.write(pointer));
    EXPECT_TRUE(imu.read(bytes));
    return static_cast<std::int16_t>((bytes[0] << 8) | bytes[1]);
  }
  static void wake(Mpu6050& imu) {
    set(imu, 0x6B, 0x01);
    set(imu, 0x1A, 2);
    set(imu, 0x1B, 2 << 3);
    set(imu, 0x1C, 1 << 3);
  }
  static course::EmulatedImu perfect() {
    course::EmulatedImu values;
    values.gyro_noise_radps_rthz = values.gyro_bias_radps = values.gyro_bias_walk_radps_rts = 0;
    values.gyro_scale_error = values.gyro_bias_per_degc = 0;
    values.accel_noise_mps2_rthz = values.accel_bias_mps2 = 0;
    return values;
  }
};

TEST_F(Mpu6050Test, SleepsAfterPowerOnAndAnswersWhoItIs) {
  Mpu6050 imu(perfect(), 1);
  BodyState body;
  body.rate_radps = {1.0, 1.0, 1.0};
  imu.measure(body, 0);
  EXPECT_EQ(word(imu, 0x43), 0);
  EXPECT_EQ(word(imu, 0x75) >> 8, 0x68);
}

TEST_F(Mpu6050Test, ReportsInTheChosenFullScale) {
  Mpu6050 imu(perfect(), 1);
  wake(imu);
  BodyState body;
  body.rate_radps = {0.0, 0.0, 1.0};
  body.specific_force_mps2 = {0.0, 0.0, 9.80665};
  for (int i = 0; i < 200; ++i) imu.measure(body, i * 1'000'000LL);
  EXPECT_NEAR(word(imu, 0x47), 180.0 / M_PI * 32.768, 1.5);
  EXPECT_NEAR(word(imu, 0x3F), 8192, 1.5);
}

TEST_F(Mpu6050Test, SaturatesInsteadOfWrapping) {
  Mpu6050 imu(perfect(), 1);
  wake(imu);
  BodyState body;
  body.rate_radps = {0.0, 0.0, -40.0};
  for (int i = 0; i < 200; ++i) imu.measure(body, i * 1'000'000LL);
  EXPECT_EQ(word(imu, 0x47), -32768);
}

TEST_F(Mpu6050Test, NoiseHasTheDensityOfTheDataSheet) {
  course::EmulatedImu values = perfect();
  values.gyro_noise_radps_rthz = 8.7e-5;
  Mpu6050 imu(values, 5);
  wake(imu);
  double squares = 0.0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    imu.measure({}, i * 1'000'000LL);
    const double rate = word(imu, 0x47) / 32.768 * M_PI / 180.0;
    squares += rate * rate;
  }
  // A first-order low-pass at 98 Hz has a noise bandwidth of pi/2 times that; the tolerance
  // includes the quantisation.
  const double expected = 8.7e-5 * std::sqrt(98.0 * M_PI / 2.0);
  EXPECT_NEAR(std::sqrt(squares / n), expected, 0.25 * expected);
}

TEST_F(Mpu6050Test, BiasDiffersBetweenSeedsAndIsRepeatable) {
  course::EmulatedImu values = perfect();
  values.gyro_bias_radps = 0.05;
  const auto bias = [&](std::uint64_t seed) {
    Mpu6050 imu(values, seed);
    wake(imu);
    for (int i = 0; i < 100; ++i) imu.measure({}, i * 1'000'000LL);
    return word(imu, 0x47);
  };
  EXPECT_EQ(bias(1), bias(1));
  EXPECT_NE(bias(1), bias(2));
}

TEST_F(Mpu6050Test, OnlyTheZAxisHasAScaleError) {
  course::EmulatedImu values = perfect();
  values.gyro_scale_error = 0.02;
  Mpu6050 imu(values, 1);
  wake(imu);
  BodyState body;
  body.rate_radps = {2.0, 2.0, 2.0};
  for (int i = 0; i < 200; ++i) imu.measure(body, i * 1'000'000LL);
  const double nominal = 2.0 * 180.0 / M_PI * 32.768;
  EXPECT_NEAR(word(imu, 0x43), nominal, 1.0);
  EXPECT_NEAR(word(imu, 0x45), nominal, 1.0);
  EXPECT_NEAR(word(imu, 0x47), nominal * 1.02, 1.0);
}

TEST_F(Mpu6050Test, WarmingUpShowsAndMovesTheBias) {
  course::EmulatedImu values = perfect();
  values.gyro_bias_per_degc = 0.01;
  Mpu6050 imu(values, 1);
  wake(imu);
  const auto temperature = [&] { return word(imu, 0x41) / 340.0 + 36.53; };
  const auto rate = [&] { return word(imu, 0x47) / 32.768 * M_PI / 180.0; };
  for (int i = 0; i < 200; ++i) imu.measure({}, i * 1'000'000LL);
  EXPECT_NEAR(temperature(), 25.0, 0.05);
  EXPECT_NEAR(rate(), 0.0, 0.001);
  for (int i = 0; i < 200; ++i) imu.measure({}, 180'000'000'000LL + i * 1'000'000LL);
  const double rise = 6.0 * (1.0 - std::exp(-1.0));
  EXPECT_NEAR(temperature(), 25.0 + rise, 0.05);
  EXPECT_NEAR(rate(), 0.01 * rise, 0.001);
}

TEST_F(Mpu6050Test, ABurstReadsAllFourteenBytesInOrder) {
  Mpu6050 imu(perfect(), 1);
  wake(imu);
  BodyState body;
  body.rate_radps = {0.1, -0.2, 0.3};
  body.specific_force_mps2 = {1.0, -2.0, 9.81};
  for (int i = 0; i < 200; ++i) imu.measure(body, i * 1'000'000LL);
  const std::array<std::uint8_t, 1> pointer = {0x3B};
  std::array<std::uint8_t, 14> bytes{};
  ASSERT_TRUE(imu.write(pointer));
  ASSERT_TRUE(imu.read(bytes));
  for (std::uint8_t i = 0; i < 7; ++i) {
    const auto at = static_cast<std::size_t>(2 * i);
    EXPECT_EQ(static_cast<std::int16_t>((bytes[at] << 8) | bytes[at + 1]),
              word(imu, static_cast<std::uint8_t>(0x3B + 2 * i)));
  }
  EXPECT_LT(word(imu, 0x45), 0);
  EXPECT_LT(word(imu, 0x3D), 0);
}

TEST_F(Mpu6050Test, TheSampleRateDividerHoldsTheOutputs) {
  Mpu6050 imu(perfect(), 1);
  wake(imu);
  set(imu, 0x19, 4);
  int fresh = 0;
  for (int i = 0; i < 100; ++i) {
    imu.measure({}, i * 1'000'000LL);
    const std::array<std::uint8_t, 1> pointer = {0x3A};
    std::array<std::uint8_t, 1> status{};
    imu.write(pointer);
    imu.read(status);
    fresh += status[0] & 1;
  }
  EXPECT_EQ(fresh, 20);
}

}  // namespace
}  // namespace tp100::sim
