// Whether the robot moves as its tracks say, by camera and slope.
#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "bridge/traction_estimator.h"
#include "core/arithmetic.h"

namespace tp100::bridge {
namespace {

constexpr double kDt = 0.005;

constexpr double kTracksMps = 0.1;

/// Drives for `time_s` with tracks at this speed while the camera sees the robot move at
/// `ground_mps`.
Traction drive(TractionEstimator& traction_estimator, double ground_mps, double time_s,
               const TractionInput& seen = {.camera = true}, double tracks_mps = kTracksMps) {
  // The pose goes on from where the last drive ended.
  static double x_m = 0.0;
  Traction state = Traction::kHolding;
  for (double t = 0; t < time_s; t += kDt) {
    TractionInput in = seen;
    in.dt_s = kDt;
    in.distance_m = tracks_mps * kDt;
    in.fused.x_m = x_m += ground_mps * kDt;
    state = traction_estimator.update(in);
  }
  return state;
}

// Below a fifth of its tracks' speed a robot is immobilised after three windows of 0.4 s; with a
// slip above 0.4 it slips, whether the tracks run ahead or behind.
TEST(TractionEstimator, JudgesTheShareOfTheTracksSpeedInBothDirections) {
  for (const double mps : {0.1, -0.1}) {
    const auto after = [mps](double time_s, double share) {
      TractionEstimator traction_estimator;
      return drive(traction_estimator, share * mps, time_s, {.camera = true}, mps);
    };
    for (const double share : {0.19, 0.0, -0.1, -2.0}) {
      EXPECT_NE(after(1.2, share), Traction::kImmobilised) << share;
      EXPECT_EQ(after(1.4, share), Traction::kImmobilised) << share;
    }
    for (const double slip : {0.41, 0.6, 0.79, -0.5}) {
      EXPECT_EQ(after(0.45, 1.0 - slip), Traction::kHolding) << slip;
      EXPECT_EQ(after(0.55, 1.0 - slip), Traction::kSlipping) << slip;
      EXPECT_EQ(after(5.0, 1.0 - slip), Traction::kSlipping) << slip;
    }
    for (const double slip : {0.0, 0.1, 0.26, 0.39, -0.2})
      EXPECT_EQ(after(5.0, 1.0 - slip), Traction::kHolding) << slip;
  }
}

TEST(TractionEstimator, LeavesAStateOnlyOnceItHasGoodTractionAgainOrItsTracksStand) {
  TractionEstimator traction_estimator;
  for (const bool stands : {false, true}) {
    ASSERT_EQ(drive(traction_estimator, 0.0, 3.0), Traction::kImmobilised);
    EXPECT_EQ(drive(traction_estimator, 0.0, 3.0, {}), Traction::kImmobilised) << "unseen";
    EXPECT_EQ(drive(traction_estimator, 0.065, 3.0), Traction::kImmobilised);
    EXPECT_EQ(stands ? drive(traction_estimator, 0.0, 0.9, {.camera = true}, 0.01)
                     : drive(traction_estimator, 0.08, 1.0),
              Traction::kHolding);
  }
}

TEST(TractionEstimator, JudgesNothingThatNoCameraSeesInProportion) {
  for (const TractionInput& seen : {TractionInput{}, {.camera = true, .climbing = true}}) {
    TractionEstimator traction_estimator;
    EXPECT_EQ(drive(traction_estimator, 0.0, 3.0, seen), Traction::kHolding);
  }
}

TEST(TractionEstimator, IgnoresValuesThatAreNone) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  TractionEstimator traction_estimator;
  ASSERT_EQ(drive(traction_estimator, 0.045, 2.0), Traction::kSlipping);
  for (const auto& [distance_m, dt_s] : {std::pair{kNan, kDt}, {5e-4, kNan}, {5e-4, -1.0}})
    EXPECT_EQ(traction_estimator.update({.dt_s = dt_s, .distance_m = distance_m, .camera = true}),
              Traction::kSlipping);
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
