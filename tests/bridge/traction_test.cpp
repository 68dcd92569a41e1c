// Whether the robot moves as its tracks say: the judgement of speeds, and of camera and slope.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bridge/traction_estimator.h"
#include "core/arithmetic.h"

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

// Below a fifth of its tracks' speed a robot is immobilised after 0.3 s; with a slip above 0.4 it
// slips after 0.1 s, whether the tracks run ahead or behind.
TEST(TractionMonitor, JudgesTheShareOfTheTracksSpeedInBothDirections) {
  for (const double mps : {0.1, -0.1}) {
    for (const double share : {0.19, 0.0, -0.1, -2.0}) {
      TractionMonitor traction;
      EXPECT_NEAR(seconds_until(traction, Traction::kImmobilised, mps, share * mps, 1.0), 0.3, 1e-9)
          << share;
    }
    for (const double slip : {0.41, 0.6, 0.79, -0.5}) {
      TractionMonitor traction;
      EXPECT_NEAR(seconds_until(traction, Traction::kSlipping, mps, mps * (1 - slip), 2.0), 0.1,
                  1e-9)
          << slip;
      EXPECT_LT(seconds_until(traction, Traction::kImmobilised, mps, mps * (1 - slip), 2.0), 0.0);
    }
    for (const double slip : {0.0, 0.1, 0.26, 0.39, -0.2}) {
      TractionMonitor traction;
      for (int i = 0; i < 1000; ++i)
        ASSERT_EQ(traction.update(mps, mps * (1 - slip), kDt), Traction::kHolding);
      EXPECT_NEAR(traction.slip(), slip, 1e-12);
    }
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

TEST(TractionMonitor, AGoodMeasurementOrStandingTracksStartTheTimeAgain) {
  TractionMonitor traction;
  EXPECT_LT(seconds_until(traction, Traction::kImmobilised, 0.01, 0.0, 5.0), 0.0);
  for (int i = 0; i < 20; ++i) {
    EXPECT_LT(seconds_until(traction, Traction::kImmobilised, 0.1, 0.0, 0.29), 0.0);
    traction.update(0.1, 0.05, kDt);
  }
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

TEST(TractionMonitor, IgnoresValuesThatAreNone) {
  TractionMonitor traction;
  ASSERT_GT(seconds_until(traction, Traction::kSlipping, 0.1, 0.05, 1.0), 0.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const double wrong[][3] = {{nan, 0.0, kDt}, {0.1, nan, kDt}, {0.1, -inf, kDt},
                             {0.1, 0.0, nan}, {0.1, 0.0, inf}, {0.1, 0.0, -1.0}};
  for (const auto& [track_mps, ground_mps, dt_s] : wrong)
    for (int i = 0; i < 1000; ++i)
      EXPECT_EQ(traction.update(track_mps, ground_mps, dt_s), Traction::kSlipping);
  EXPECT_NEAR(traction.slip(), 0.5, 1e-12);
}

constexpr double kTracksMps = 0.1;

/// Drives for `time_s` with tracks at 0.1 m/s while the camera sees the robot move at `ground_mps`.
Traction drive(TractionEstimator& traction_estimator, double ground_mps, double time_s,
               TractionInput in = {.camera = true}) {
  Traction state = Traction::kHolding;
  for (double t = 0; t < time_s; t += kDt) {
    in.dt_s = kDt;
    in.distance_m = kTracksMps * kDt;
    in.fused.x_m += ground_mps * kDt;
    state = traction_estimator.update(in);
  }
  return state;
}

TEST(TractionEstimator, ComparesTheTracksWithWhatTheCameraSeesWhereThatIsInProportion) {
  struct Case {
    double ground_mps;
    TractionInput in;
    Traction wanted;
  };
  const Case cases[] = {
      {0.1, {.camera = true}, Traction::kHolding},
      {0.045, {.camera = true}, Traction::kSlipping},
      {0.0, {.camera = true}, Traction::kImmobilised},
      {0.0, {}, Traction::kHolding},
      {0.0, {.camera = true, .climbing = true}, Traction::kHolding},
  };
  for (const Case& each : cases) {
    TractionEstimator traction_estimator;
    EXPECT_EQ(drive(traction_estimator, each.ground_mps, 2.0, each.in), each.wanted)
        << each.ground_mps;
  }
}

TEST(TractionEstimator, OneDisturbanceAgainstItsWayIsNoStandstill) {
  for (int i = 0; i < 20; ++i) {
    TractionEstimator traction_estimator;
    TractionInput in{.dt_s = kDt, .distance_m = kTracksMps * kDt, .camera = true};
    for (double t = 0.0; t < 4.0; t += kDt) {
      const double since = t - 1.0 - 0.04 * i;
      const bool disturbed = since >= 0.0 && since < 0.3;
      in.fused.x_m += (disturbed ? -0.2 : kTracksMps) * kDt;
      EXPECT_NE(traction_estimator.update(in), Traction::kImmobilised) << i << " at " << t;
    }
  }
}

TEST(TractionEstimator, WhoShouldBeOnARampAndIsLevelForLongDoesNotGetAhead) {
  const TractionInput wrong{.mapped_pitch_rad = -28 * kRadPerDeg, .measured_pitch_rad = 0.0};
  const TractionInput right{.mapped_pitch_rad = -28 * kRadPerDeg,
                            .measured_pitch_rad = -27 * kRadPerDeg};
  TractionEstimator traction_estimator;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(drive(traction_estimator, 0.1, 0.8, wrong), Traction::kHolding);
    EXPECT_EQ(drive(traction_estimator, 0.1, 0.1, right), Traction::kHolding);
  }
  EXPECT_EQ(drive(traction_estimator, 0.1, 1.0, wrong), Traction::kHolding);
  EXPECT_EQ(drive(traction_estimator, 0.1, 0.5, wrong), Traction::kImmobilised);
}

}  // namespace
}  // namespace tp100::bridge
