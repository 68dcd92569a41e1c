#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/arithmetic.h"
#include "estimation/attitude.h"
#include "interval.h"
#include "support/sequence.h"

namespace tp100::estimation {
namespace {

constexpr double kG = 9.80665;

/// Gravity of a body with this roll and pitch (nose-up negative), derived by hand.
AttitudeFilter::Vector gravity(double roll_rad, double pitch_rad) {
  return {-kG * std::sin(pitch_rad), kG * std::cos(pitch_rad) * std::sin(roll_rad),
          kG * std::cos(pitch_rad) * std::cos(roll_rad)};
}

TEST(AttitudeFilter, AnythingButGravityIsNotTakenForIt) {
  const auto after = [](double share_of_gravity) {
    AttitudeFilter filter{{}};
    const double size = share_of_gravity * kG;
    for (int i = 0; i < 40; ++i) filter.update({0, 0, 0}, {-0.6 * size, 0.0, 0.8 * size}, kDt);
    return filter.pitch_rad();
  };
  for (const double share : {0.89, 1.11, 2.0}) EXPECT_EQ(after(share), 0.0) << share;
  for (const double share : {0.91, 1.0, 1.09}) EXPECT_GT(after(share), 0.1) << share;
}

// Both angles go to those of gravity like a low-pass of 0.7 s.
TEST(AttitudeFilter, GravityCountsOverSevenTenthsOfASecond) {
  AttitudeFilter filter{{}};
  const double kept = 0.7 / (0.7 + kDt);
  for (int i = 1; i <= 300; ++i) {
    filter.update({0, 0, 0}, gravity(-0.2, 0.3), kDt);
    ASSERT_NEAR(filter.pitch_rad(), 0.3 * (1.0 - std::pow(kept, i)), 1e-9);
    ASSERT_NEAR(filter.roll_rad(), -0.2 * (1.0 - std::pow(kept, i)), 1e-9);
  }
}

// Without gravity the angles are those of the rotation that the gyro measures; the heading turns
// with them.
TEST(AttitudeFilter, FollowsAnyRotationByTheGyroAlone) {
  test::Sequence any(3);
  for (int round = 0; round < 20; ++round) {
    AttitudeFilter filter{{.gravity_s = 1e12}};
    const double step_s = 1e-4;
    double yaw = 0.0;
    std::array<std::array<double, 3>, 3> body{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // its axes
    for (int i = 0; i < 4000; ++i) {
      const double t = step_s * i;
      const AttitudeFilter::Vector w{std::cos(3.0 * t + round), 1.5 * std::sin(2.0 * t + round),
                                     0.8 * std::cos(5.0 * t)};
      filter.update(w, {}, step_s);
      yaw += filter.yaw_rate_radps(w[2]) * step_s;
      // Each axis moves with the rotation vector, which is w in body axes.
      const auto before = body;
      for (std::size_t n = 0; n < 3; ++n) {
        body[0][n] += step_s * (w[2] * before[1][n] - w[1] * before[2][n]);
        body[1][n] += step_s * (w[0] * before[2][n] - w[2] * before[0][n]);
        body[2][n] += step_s * (w[1] * before[0][n] - w[0] * before[1][n]);
      }
    }
    EXPECT_NEAR(filter.pitch_rad(), std::asin(-body[0][2]), 1e-3);
    EXPECT_NEAR(filter.roll_rad(), std::atan2(body[1][2], body[2][2]), 1e-3);
    EXPECT_NEAR(yaw, std::atan2(body[0][1], body[0][0]), 1e-3);
  }
  AttitudeFilter filter{{}};
  filter.update({0, 1.4 / kDt, 0}, {}, kDt);
  EXPECT_NEAR(filter.yaw_rate_radps(1.0), 5.0, 1e-9) << "bounded near the vertical";
  EXPECT_NEAR(filter.pitch_rate_radps(), 1.4 / kDt, 1e-9);
}

// At first the mean of all, then one over 5 s.
TEST(AttitudeFilter, TheLevelIsTheMeanOfTheStandstillsLastSeconds) {
  AttitudeFilter filter{{}};
  double gyro = 0.0, accel = 0.0;
  for (int i = 1; i <= 2000; ++i) {
    const double x = 0.01 * std::sin(0.01 * i);
    filter.level({x, -x, 2 * x}, {x, 0.02 + x, kG - 3 * x}, kDt);
    filter.level({9, 9, 9}, {0, 0, kG}, 0.0);
    const double share = kDt / std::min(i * kDt, 5.0);
    gyro += (x - gyro) * share;
    accel += (x - accel) * share;
    const CarriedAttitude carried = filter.carried();
    ASSERT_NEAR(carried.levelled_s, std::min(i * kDt, 5.0), 1e-9);
    ASSERT_NEAR(carried.gyro_offset_radps[0], gyro, 1e-12);
    ASSERT_NEAR(carried.gyro_offset_radps[1], -gyro, 1e-12);
    ASSERT_NEAR(carried.gyro_offset_radps[2], 2 * gyro, 1e-12);
    ASSERT_NEAR(carried.accel_offset_mps2[0], accel, 1e-12);
    ASSERT_NEAR(carried.accel_offset_mps2[1], 0.02 + accel, 1e-12);
    ASSERT_NEAR(carried.accel_offset_mps2[2], -3 * accel, 1e-12);
  }
}

TEST(AttitudeFilter, ARobotThatIsTiltedOrBeingTiltedTeachesNoLevel) {
  const auto learned = [](const AttitudeFilter::Vector& gyro, double roll, double pitch,
                          double levelled_s) {
    AttitudeFilter filter{{}};
    for (int i = 0; i < std::lround(levelled_s / kDt); ++i)
      filter.level({0, 0, 0}, gravity(0, 0), kDt);
    filter.level(gyro, gravity(roll, pitch), kDt);
    return filter.carried().levelled_s > (levelled_s + 0.5 * kDt);
  };
  constexpr double kWithin = 4.59 * kRadPerDeg, kBeyond = 4.61 * kRadPerDeg;
  for (const double side : {1.0, -1.0}) {
    for (const double before_s : {0.0, 0.3}) {
      EXPECT_TRUE(learned({0, 0, 0}, side * kWithin, 0, before_s));
      EXPECT_TRUE(learned({0, 0, 0}, 0, side * kWithin, before_s));
      EXPECT_FALSE(learned({0, 0, 0}, side * kBeyond, 0, before_s));
      EXPECT_FALSE(learned({0, 0, 0}, 0, side * kBeyond, before_s));
      EXPECT_TRUE(learned({0, 0, 9}, 0, 0, before_s)) << "it may turn";
      // Only after 0.2 s the gyro's offset is known well enough.
      EXPECT_EQ(learned({side * 0.051, 0, 0}, 0, 0, before_s), before_s == 0.0);
      EXPECT_EQ(learned({0, side * 0.051, 0}, 0, 0, before_s), before_s == 0.0);
      EXPECT_TRUE(learned({side * 0.049, -side * 0.049, 0}, 0, 0, before_s));
    }
  }
  EXPECT_TRUE(learned({1, 0, 0}, 0, 0, 0.19));
  EXPECT_FALSE(learned({1, 0, 0}, 0, 0, 0.21));
}

TEST(AttitudeFilter, GoesOnFromWhatWasCarried) {
  AttitudeFilter filter{{}};
  for (int i = 0; i < 50; ++i) {
    filter.level({0.02, -0.03, 0.01}, {0.3, -0.2, kG}, kDt);
    filter.update({0.2, -0.3, 0.4}, gravity(0.1, -0.1), kDt);
  }
  AttitudeFilter again{{}};
  again.resume(filter.carried());
  for (AttitudeFilter* each : {&filter, &again}) {
    each->update({0.3, 0.1, 0.2}, {1, 1, 9}, kDt);
    each->level({0.02, -0.03, 0}, gravity(0, 0), kDt);
  }
  EXPECT_EQ(again.roll_rad(), filter.roll_rad());
  EXPECT_EQ(again.pitch_rad(), filter.pitch_rad());
  EXPECT_EQ(again.carried().levelled_s, filter.carried().levelled_s);
  EXPECT_EQ(again.carried().gyro_offset_radps, filter.carried().gyro_offset_radps);
  EXPECT_EQ(again.carried().accel_offset_mps2, filter.carried().accel_offset_mps2);
  filter.resume(again.carried());
  EXPECT_EQ(filter.pitch_rate_radps(), 0.0);
}

}  // namespace
}  // namespace tp100::estimation
