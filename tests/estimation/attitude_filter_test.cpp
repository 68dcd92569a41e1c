#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/arithmetic.h"
#include "estimation/attitude.h"
#include "interval.h"

namespace tp100::estimation {
namespace {

constexpr double kG = 9.80665;

/// Gravity of a body with this roll and pitch (nose-up negative), derived by hand.
AttitudeFilter::Vector gravity(double roll_rad, double pitch_rad) {
  return {-kG * std::sin(pitch_rad), kG * std::cos(pitch_rad) * std::sin(roll_rad),
          kG * std::cos(pitch_rad) * std::cos(roll_rad)};
}

/// Sensors with the MPU6050's offsets and noise.
class Imu {
 public:
  AttitudeFilter::Vector gyro(double wx, double wy, double wz) {
    return {wx + 0.02 + 0.003 * normal_(random_), wy - 0.03 + 0.003 * normal_(random_), wz};
  }
  AttitudeFilter::Vector accel(double roll_rad, double pitch_rad) {
    AttitudeFilter::Vector a = gravity(roll_rad, pitch_rad);
    a[0] += 0.35 + 0.05 * normal_(random_);
    a[1] += -0.2 + 0.05 * normal_(random_);
    return a;
  }
  AttitudeFilter levelled() {
    AttitudeFilter filter{{}};
    for (int i = 0; i < 200; ++i) filter.level(gyro(0, 0, 0), accel(0, 0), kDt);
    return filter;
  }

 private:
  std::mt19937_64 random_{1};
  std::normal_distribution<double> normal_{0.0, 1.0};
};

TEST(AttitudeFilter, StaysLevelThereWhereItWasLevelled) {
  Imu imu;
  AttitudeFilter filter = imu.levelled();
  double worst = 0.0;
  for (int i = 0; i < 4000; ++i) {
    filter.update(imu.gyro(0, 0, 0), imu.accel(0, 0), kDt);
    worst = std::max({worst, std::abs(filter.pitch_rad()), std::abs(filter.roll_rad())});
  }
  EXPECT_LT(worst, 0.5 * kRadPerDeg);
}

TEST(AttitudeFilter, FollowsARampWithin1AndAHalfDegrees) {
  Imu imu;
  AttitudeFilter filter = imu.levelled();
  double pitch = 0.0, worst = 0.0;
  for (int i = 0; i < 1600; ++i) {
    const double rate = i >= 200 && i < 480 ? -20.0 * kRadPerDeg : 0.0;
    pitch += rate * kDt;
    filter.update(imu.gyro(0, rate, 0), imu.accel(0, pitch), kDt);
    worst = std::max(worst, std::abs(filter.pitch_rad() - pitch));
  }
  EXPECT_NEAR(pitch, -28.0 * kRadPerDeg, 1e-6);
  EXPECT_LT(worst, 1.5 * kRadPerDeg);
}

// An angle that is correct only on level ground is wrong by a degree on a ramp.
TEST(AttitudeFilter, OffsetsOfEveryAxisAreGoneOnASlopeToo) {
  const auto off = [](AttitudeFilter::Vector a) {
    return AttitudeFilter::Vector{a[0] + 0.4, a[1] - 0.3, a[2] + 0.6};
  };
  for (const double pitch : {-28.0 * kRadPerDeg, 28.0 * kRadPerDeg}) {
    AttitudeFilter filter{{}};
    for (int i = 0; i < 200; ++i) filter.level({0, 0, 0}, off(gravity(0, 0)), kDt);
    for (int i = 0; i < 2000; ++i) filter.update({0, 0, 0}, off(gravity(0, pitch)), kDt);
    EXPECT_NEAR(filter.pitch_rad(), pitch, 0.05 * kRadPerDeg);
  }
}

// A sensor that is mounted askew is off by less than half a degree.
TEST(AttitudeFilter, ASensorThatIsMountedAskewIsNearlyRightOnASlope) {
  constexpr double kAskew = 3.0 * kRadPerDeg;
  AttitudeFilter filter{{}};
  for (int i = 0; i < 200; ++i) filter.level({0, 0, 0}, gravity(0, kAskew), kDt);
  const double pitch = -28.0 * kRadPerDeg;
  for (int i = 0; i < 2000; ++i) filter.update({0, 0, 0}, gravity(0, kAskew + pitch), kDt);
  EXPECT_NEAR(filter.pitch_rad(), pitch, 0.5 * kRadPerDeg);
}

TEST(AttitudeFilter, ASlopeIsNotTakenForALevel) {
  AttitudeFilter filter{{}};
  for (int i = 0; i < 2000; ++i) {
    filter.level({0, 0, 0}, gravity(0.0, -8.0 * kRadPerDeg), kDt);
    filter.update({0, 0, 0}, gravity(0.0, -8.0 * kRadPerDeg), kDt);
  }
  EXPECT_NEAR(filter.pitch_rad(), -8.0 * kRadPerDeg, 1e-3);
}

TEST(AttitudeFilter, ABlowIsNotTakenForGravity) {
  AttitudeFilter filter{{}};
  for (int i = 0; i < 40; ++i) filter.update({0, 0, 0}, {8.0, 0.0, kG}, kDt);
  EXPECT_EQ(filter.pitch_rad(), 0.0);
}

TEST(AttitudeFilter, TurningOnASlopeTurnsPitchIntoRoll) {
  AttitudeFilter filter{{.gravity_s = 1e9}};
  filter.update({0, -0.3 / kDt, 0}, {}, kDt);
  ASSERT_NEAR(filter.pitch_rad(), -0.3, 1e-9);
  // After a quarter turn left about the slope's normal, what was ahead is now to the right.
  for (int i = 0; i < 1000; ++i) filter.update({0, 0, kPi / 2 / 1000 / kDt}, {}, kDt);
  EXPECT_NEAR(filter.pitch_rad(), 0.0, 2e-3);
  EXPECT_NEAR(filter.roll_rad(), -0.3, 2e-3);
}

}  // namespace
}  // namespace tp100::estimation
