// The robot that a bare Mega simulates.
#include "firmware/fake_robot.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "firmware/imu.h"

namespace tp100::firmware {
namespace {

constexpr double kCountsPerM = 11140.0;

class FakeRobotTest : public testing::Test {
 protected:
  void run(std::int16_t left, std::int16_t right, int ms) {
    for (int i = 0; i < ms; ++i) robot.step(left, right);
  }
  std::int16_t word(std::size_t index) {
    std::array<std::uint8_t, Imu::kMeasuredBytes> bytes{};
    EXPECT_TRUE(robot.imu_read(Imu::kAddress, Imu::kAccelXHigh, bytes.data(), Imu::kMeasuredBytes));
    return static_cast<std::int16_t>(bytes[2 * index] << 8 | bytes[2 * index + 1]);
  }
  double mean(std::size_t index) {
    double sum = 0.0;
    for (int i = 0; i < 200; ++i) sum += word(index);
    return sum / 200.0;
  }

  FakeRobot robot;
};

TEST_F(FakeRobotTest, ATrackRunsAsItsDutySaysAboveTheDeadBandAndBothWaysWithALag) {
  run(90, -90, 1000);
  EXPECT_EQ(robot.left_counts(), 0);
  EXPECT_EQ(robot.right_counts(), 0);
  const double counts_per_s = (0.43 - 0.09) / 3.4 * kCountsPerM;
  run(430, -430, 64);
  // After one time constant a first-order lag has covered 1/e of it.
  EXPECT_NEAR(robot.left_counts(), 0.064 * counts_per_s / std::exp(1.0), 8.0);
  run(430, -430, 1000);
  const std::int32_t left = robot.left_counts(), right = robot.right_counts();
  run(430, -430, 1000);
  EXPECT_NEAR(robot.left_counts() - left, counts_per_s, 10.0);
  EXPECT_NEAR(robot.right_counts() - right, -counts_per_s, 10.0);
  const std::int32_t last = robot.left_counts();
  run(0, 0, 1000);
  EXPECT_NEAR(robot.left_counts() - last, 0.064 * counts_per_s, 8.0) << "it runs out";
  const std::int32_t rest = robot.left_counts();
  run(0, 0, 10'000);
  EXPECT_EQ(robot.left_counts(), rest);
}

TEST_F(FakeRobotTest, TurnsByTheDifferenceOfItsTracks) {
  const double bias = mean(6);
  run(430, 770, 1000);
  // 0.1 m/s between the tracks, 16 % slip, over 0.2742 m.
  const double radps = 0.84 * 0.1 / 0.2742;
  EXPECT_NEAR(mean(6) - bias, radps * 57.29578 * 32.8, 5.0);
  // 0.15 m/s on average, less the slip, times the rate.
  EXPECT_NEAR(mean(1), 0.84 * 0.15 * radps * 8192.0 / 9.80665, 5.0);
  EXPECT_NEAR(mean(2), 8192.0, 5.0);
  EXPECT_NEAR(mean(3) / 340.0 + 36.53, 27.0, 0.1) << "degrees";
}

}  // namespace
}  // namespace tp100::firmware
