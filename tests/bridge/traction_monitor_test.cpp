#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "bridge/traction_estimator.h"

namespace tp100::bridge {
namespace {

constexpr double kDt = 0.005;

// Runs for `seconds`. Returns the time until `wanted` was reached, or a negative value.
double seconds_until(TractionMonitor& traction, Traction wanted, double track,
                     std::optional<double> ground, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / kDt));
  for (int i = 1; i <= steps; ++i) {
    if (traction.update(track, ground, kDt) == wanted) return i * kDt;
  }
  return -1.0;
}

class BothDirections : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Driving, BothDirections, testing::Values(1.0, -1.0));

TEST_P(BothDirections, ARobotBelowAFifthOfItsTrackSpeedIsImmobilisedAfterThreeTenths) {
  const double direction = GetParam();
  for (const double share : {0.19, 0.0, -0.1, -2.0}) {
    TractionMonitor traction;
    EXPECT_NEAR(seconds_until(traction, Traction::kImmobilised, direction * 0.1,
                              direction * share * 0.1, 1.0),
                0.3, 1e-9)
        << share;
  }
  TractionMonitor traction;
  EXPECT_LT(
      seconds_until(traction, Traction::kImmobilised, direction * 0.1, direction * 0.021, 2.0),
      0.0);
}

TEST_P(BothDirections, OrdinarySlipIsNoEvent) {
  const double direction = GetParam();
  for (const double slip : {0.0, 0.1, 0.26, 0.39, -0.2}) {
    TractionMonitor traction;
    for (int i = 0; i < 1000; ++i) {
      ASSERT_EQ(traction.update(direction * 0.1, direction * 0.1 * (1 - slip), kDt),
                Traction::kHolding);
    }
    EXPECT_NEAR(traction.slip(), slip, 1e-12);
  }
}

TEST_P(BothDirections, SlipBeyondItsBoundIsSlippingWhetherTheTracksRunAheadOrBehind) {
  const double direction = GetParam();
  for (const double slip : {0.41, 0.6, 0.79, -0.5}) {
    TractionMonitor traction;
    EXPECT_NEAR(seconds_until(traction, Traction::kSlipping, direction * 0.1,
                              direction * 0.1 * (1 - slip), 2.0),
                0.1, 1e-9)
        << slip;
    EXPECT_EQ(traction.state(), Traction::kSlipping);
  }
}

TEST(TractionMonitor, OneGoodMeasurementStartsTheTimeAgain) {
  TractionMonitor traction;
  for (int i = 0; i < 20; ++i) {
    EXPECT_LT(seconds_until(traction, Traction::kImmobilised, 0.1, 0.0, 0.29), 0.0);
    traction.update(0.1, 0.05, kDt);
  }
}

TEST(TractionMonitor, WithoutAnIndependentSpeedNothingChanges) {
  TractionMonitor traction;
  EXPECT_LT(seconds_until(traction, Traction::kImmobilised, 0.1, 0.0, 0.2), 0.0);
  const Traction before = traction.state();
  EXPECT_LT(seconds_until(traction, Traction::kImmobilised, 0.1, std::nullopt, 5.0), 0.0);
  EXPECT_EQ(traction.state(), before);
  EXPECT_NEAR(seconds_until(traction, Traction::kImmobilised, 0.1, 0.0, 1.0), 0.1, 1e-9);
}

TEST(TractionMonitor, StandingTracksShowNothingAndEndWhatWas) {
  TractionMonitor traction;
  EXPECT_LT(seconds_until(traction, Traction::kImmobilised, 0.01, 0.0, 5.0), 0.0);
  ASSERT_GT(seconds_until(traction, Traction::kImmobilised, 0.1, 0.0, 1.0), 0.0);
  EXPECT_EQ(traction.update(0.0, 0.0, kDt), Traction::kHolding);
  EXPECT_NEAR(seconds_until(traction, Traction::kImmobilised, 0.1, 0.0, 1.0), 0.3, 1e-9);
}

TEST(TractionMonitor, LeavesAStateOnlyOnceItHasGoodTractionAgain) {
  TractionMonitor traction;
  ASSERT_GT(seconds_until(traction, Traction::kImmobilised, 0.1, 0.0, 1.0), 0.0);
  EXPECT_LT(seconds_until(traction, Traction::kHolding, 0.1, 0.065, 2.0), 0.0);
  EXPECT_EQ(traction.state(), Traction::kImmobilised);
  EXPECT_NEAR(seconds_until(traction, Traction::kHolding, 0.1, 0.08, 1.0), 0.1, 1e-9);
}

TEST(TractionMonitor, DoesNotFlickerOnANoisySpeedAtItsBound) {
  TractionMonitor traction;
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.01);
  int changes = 0;
  Traction last = traction.state();
  for (int i = 0; i < 4000; ++i) {
    const Traction now = traction.update(0.1, 0.06 + noise(random), kDt);
    changes += now != last ? 1 : 0;
    last = now;
  }
  EXPECT_LE(changes, 2);
}

TEST(TractionMonitor, IgnoresValuesThatAreNone) {
  TractionMonitor traction;
  ASSERT_GT(seconds_until(traction, Traction::kSlipping, 0.1, 0.05, 1.0), 0.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(traction.update(nan, 0.0, kDt), Traction::kSlipping);
    EXPECT_EQ(traction.update(0.1, nan, kDt), Traction::kSlipping);
    EXPECT_EQ(traction.update(0.1, -inf, kDt), Traction::kSlipping);
    EXPECT_EQ(traction.update(0.1, 0.0, nan), Traction::kSlipping);
    EXPECT_EQ(traction.update(0.1, 0.0, inf), Traction::kSlipping);
    EXPECT_EQ(traction.update(0.1, 0.0, -1.0), Traction::kSlipping);
  }
  EXPECT_NEAR(traction.slip(), 0.5, 1e-12);
}

}  // namespace
}  // namespace tp100::bridge
