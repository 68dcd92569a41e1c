#include "bridge/traction_estimator.h"

#include <gtest/gtest.h>

#include "core/arithmetic.h"

namespace tp100::bridge {
namespace {

constexpr double kStepS = 5e-3, kTracksMps = 0.1;

/// Drives for `time_s` with tracks at 0.1 m/s while the camera sees the robot move at `ground_mps`.
Traction drive(TractionEstimator& traction_estimator, double ground_mps, double time_s,
               TractionInput in = {.camera = true}) {
  Traction state = Traction::kHolding;
  for (double t = 0; t < time_s; t += kStepS) {
    in.dt_s = kStepS;
    in.distance_m = kTracksMps * kStepS;
    in.fused.x_m += ground_mps * kStepS;
    state = traction_estimator.update(in);
  }
  return state;
}

TEST(TractionEstimator, ARobotThatMovesAsItsTracksSayHasTraction) {
  TractionEstimator traction_estimator;
  EXPECT_EQ(drive(traction_estimator, 0.1, 5.0), Traction::kHolding);
}

TEST(TractionEstimator, TracksThatRunUnderAStandingRobotAreFoundWithinTwoSeconds) {
  TractionEstimator traction_estimator;
  EXPECT_EQ(drive(traction_estimator, 0.0, 2.0), Traction::kImmobilised);
}

TEST(TractionEstimator, OneDisturbanceAgainstItsWayIsNoStandstill) {
  for (int i = 0; i < 20; ++i) {
    TractionEstimator traction_estimator;
    TractionInput in{.dt_s = kStepS, .distance_m = kTracksMps * kStepS, .camera = true};
    for (double t = 0.0; t < 4.0; t += kStepS) {
      const double since = t - 1.0 - 0.04 * i;
      const bool disturbed = since >= 0.0 && since < 0.3;
      in.fused.x_m += (disturbed ? -0.2 : kTracksMps) * kStepS;
      EXPECT_NE(traction_estimator.update(in), Traction::kImmobilised) << i << " at " << t;
    }
  }
}

TEST(TractionEstimator, HalfTheWayIsSlipping) {
  TractionEstimator traction_estimator;
  EXPECT_EQ(drive(traction_estimator, 0.045, 2.0), Traction::kSlipping);
}

TEST(TractionEstimator, WithoutACameraNothingIsJudged) {
  TractionEstimator traction_estimator;
  EXPECT_EQ(drive(traction_estimator, 0.0, 5.0, {}), Traction::kHolding);
}

TEST(TractionEstimator, WhileClimbingNothingIsInProportion) {
  TractionEstimator traction_estimator;
  EXPECT_EQ(drive(traction_estimator, 0.0, 5.0, {.camera = true, .climbing = true}),
            Traction::kHolding);
}

TEST(TractionEstimator, WhoShouldBeOnARampAndIsLevelDoesNotGetAhead) {
  TractionEstimator traction_estimator;
  const TractionInput in{.mapped_pitch_rad = -28 * kRadPerDeg, .measured_pitch_rad = 0.0};
  EXPECT_EQ(drive(traction_estimator, 0.1, 1.0, in), Traction::kHolding);
  EXPECT_EQ(drive(traction_estimator, 0.1, 0.5, in), Traction::kImmobilised);
}

TEST(TractionEstimator, ASmallErrorOfTheMapIsForgiven) {
  TractionEstimator traction_estimator;
  const TractionInput wrong{.mapped_pitch_rad = -28 * kRadPerDeg, .measured_pitch_rad = 0.0};
  const TractionInput right{.mapped_pitch_rad = -28 * kRadPerDeg,
                            .measured_pitch_rad = -27 * kRadPerDeg};
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(drive(traction_estimator, 0.1, 0.8, wrong), Traction::kHolding);
    EXPECT_EQ(drive(traction_estimator, 0.1, 0.1, right), Traction::kHolding);
  }
}

}  // namespace
}  // namespace tp100::bridge
