#include "sim/sensors/mpu6050.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/time.h"

namespace tp100::sim {
namespace {

class Mpu6050Test : public testing::Test {
 protected:
  void set(std::uint8_t reg, std::uint8_t value) {
    const std::array<std::uint8_t, 2> bytes = {reg, value};
    ASSERT_TRUE(imu_->write(bytes));
  }
  /// `count` registers from `reg` on.
  std::vector<std::uint8_t> read(std::uint8_t reg, std::size_t count) {
    const std::array<std::uint8_t, 1> pointer = {reg};
    std::vector<std::uint8_t> bytes(count);
    EXPECT_TRUE(imu_->write(pointer));
    EXPECT_TRUE(imu_->read(bytes));
    return bytes;
  }
  std::int16_t word(std::uint8_t reg) {
    const std::vector<std::uint8_t> bytes = read(reg, 2);
    return static_cast<std::int16_t>((bytes[0] << 8) | bytes[1]);
  }
  double yaw_rate_radps() { return word(0x47) / 32.768 * M_PI / 180.0; }
  /// A new sensor with these errors, in the full scales of the firmware: 1000 deg/s and 4 g.
  void wake(std::uint64_t seed = 1) {
    imu_.emplace(errors_, seed);
    set(0x6B, 0x01);
    set(0x1A, 2);
    set(0x1B, 2 << 3);
    set(0x1C, 1 << 3);
  }
  /// A measurement a millisecond from `begin_s` on.
  void measure(const BodyState& body, double begin_s = 0.0) {
    for (int i = 0; i < 200; ++i) imu_->measure(body, from_s(begin_s) + i * kNsPerMs);
  }

  course::EmulatedImu errors_ = [] {
    course::EmulatedImu none;
    none.gyro_noise_radps_rthz = none.gyro_bias_radps = none.gyro_bias_walk_radps_rts = 0;
    none.gyro_scale_error = none.gyro_bias_per_degc = 0;
    none.accel_noise_mps2_rthz = none.accel_bias_mps2 = 0;
    return none;
  }();
  std::optional<Mpu6050> imu_;
};

TEST_F(Mpu6050Test, SleepsAfterPowerOnAndAnswersWhoItIs) {
  imu_.emplace(errors_, 1);
  measure({.rate_radps = {1.0, 1.0, 1.0}});
  EXPECT_EQ(word(0x43), 0);
  EXPECT_EQ(read(0x75, 1)[0], 0x68);
}

// Only the z axis of the gyro has a scale error.
TEST_F(Mpu6050Test, ABurstHasAllAxesInTheChosenFullScaleAndSaturates) {
  errors_.gyro_scale_error = 0.02;
  wake();
  measure({.rate_radps = {0.1, -0.2, 0.3}, .specific_force_mps2 = {1.0, -2.0, 9.80665}});
  const std::vector<std::uint8_t> bytes = read(0x3B, 14);
  const double per_mps2 = 8192 / 9.80665, per_radps = 180.0 / M_PI * 32.768;
  const double expected[] = {1.0 * per_mps2,         -2.0 * per_mps2, 8192.0,
                             (25.0 - 36.53) * 340.0, 0.1 * per_radps, -0.2 * per_radps,
                             0.3 * 1.02 * per_radps};
  for (std::size_t i = 0; i < 7; ++i)
    EXPECT_NEAR(static_cast<std::int16_t>((bytes[2 * i] << 8) | bytes[2 * i + 1]), expected[i], 3.0)
        << i;
  measure({.rate_radps = {0.0, 0.0, -40.0}}, 1.0);
  EXPECT_EQ(word(0x47), -32768) << "it does not wrap";
}

TEST_F(Mpu6050Test, NoiseHasTheDensityOfTheDataSheet) {
  errors_.gyro_noise_radps_rthz = 8.7e-5;
  wake(5);
  double squares = 0.0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    imu_->measure({}, i * kNsPerMs);
    squares += yaw_rate_radps() * yaw_rate_radps();
  }
  // A first-order low-pass at 98 Hz has a noise bandwidth of pi/2 times that; the tolerance
  // includes the quantisation.
  const double expected = 8.7e-5 * std::sqrt(98.0 * M_PI / 2.0);
  EXPECT_NEAR(std::sqrt(squares / n), expected, 0.25 * expected);
}

TEST_F(Mpu6050Test, BiasDiffersBetweenSeedsAndIsRepeatable) {
  errors_.gyro_bias_radps = 0.05;
  const auto bias = [&](std::uint64_t seed) {
    wake(seed);
    measure({});
    return word(0x47);
  };
  EXPECT_EQ(bias(1), bias(1));
  EXPECT_NE(bias(1), bias(2));
}

TEST_F(Mpu6050Test, WarmingUpShowsAndMovesTheBias) {
  errors_.gyro_bias_per_degc = 0.01;
  wake();
  for (const double after_s : {0.0, 180.0}) {
    measure({}, after_s);
    const double rise = 6.0 * (1.0 - std::exp(-after_s / 180.0));
    EXPECT_NEAR(word(0x41) / 340.0 + 36.53, 25.0 + rise, 0.05);
    EXPECT_NEAR(yaw_rate_radps(), 0.01 * rise, 0.001);
  }
}

TEST_F(Mpu6050Test, TheSampleRateDividerHoldsTheOutputs) {
  wake();
  set(0x19, 4);
  int fresh = 0;
  for (int i = 0; i < 100; ++i) {
    imu_->measure({}, i * kNsPerMs);
    fresh += read(0x3A, 1)[0] & 1;
  }
  EXPECT_EQ(fresh, 20);
}

}  // namespace
}  // namespace tp100::sim
