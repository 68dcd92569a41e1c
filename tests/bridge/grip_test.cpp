#include "bridge/grip.h"

#include <gtest/gtest.h>

#include "core/angle.h"

namespace tp100::bridge {
namespace {

constexpr double kStepS = 5e-3, kBeltsMps = 0.1;

/// Drives for `time_s` with belts at 0.1 m/s while the camera sees the robot move at `ground_mps`.
Traction drive(Grip& grip, double ground_mps, double time_s, GripInput in = {.camera = true}) {
  Traction state = Traction::kGripping;
  for (double t = 0; t < time_s; t += kStepS) {
    in.dt_s = kStepS;
    in.way_m = kBeltsMps * kStepS;
    in.fused.x_m += ground_mps * kStepS;
    state = grip.update(in);
  }
  return state;
}

TEST(Grip, ARobotThatMovesAsItsBeltsSayGrips) {
  Grip grip;
  EXPECT_EQ(drive(grip, 0.1, 5.0), Traction::kGripping);
}

TEST(Grip, BeltsThatRunUnderAStandingRobotAreFoundWithinTwoSeconds) {
  Grip grip;
  EXPECT_EQ(drive(grip, 0.0, 2.0), Traction::kImmobilised);
}

TEST(Grip, OneShoveAgainstItsWayIsNoStandstill) {
  for (int i = 0; i < 20; ++i) {
    Grip grip;
    GripInput in{.dt_s = kStepS, .way_m = kBeltsMps * kStepS, .camera = true};
    for (double t = 0.0; t < 4.0; t += kStepS) {
      const double since = t - 1.0 - 0.04 * i;
      const bool shoved = since >= 0.0 && since < 0.3;
      in.fused.x_m += (shoved ? -0.2 : kBeltsMps) * kStepS;
      EXPECT_NE(grip.update(in), Traction::kImmobilised) << i << " at " << t;
    }
  }
}

TEST(Grip, HalfTheWayIsSlipping) {
  Grip grip;
  EXPECT_EQ(drive(grip, 0.045, 2.0), Traction::kSlipping);
}

TEST(Grip, WithoutACameraNothingIsJudged) {
  Grip grip;
  EXPECT_EQ(drive(grip, 0.0, 5.0, {}), Traction::kGripping);
}

TEST(Grip, WhileClimbingNothingIsInProportion) {
  Grip grip;
  EXPECT_EQ(drive(grip, 0.0, 5.0, {.camera = true, .climbing = true}), Traction::kGripping);
}

TEST(Grip, WhoShouldBeOnARampAndIsLevelDoesNotGetAhead) {
  Grip grip;
  const GripInput in{.mapped_pitch_rad = -28 * kRadPerDeg, .measured_pitch_rad = 0.0};
  EXPECT_EQ(drive(grip, 0.1, 1.0, in), Traction::kGripping);
  EXPECT_EQ(drive(grip, 0.1, 0.5, in), Traction::kImmobilised);
}

TEST(Grip, ASmallErrorOfTheMapIsForgiven) {
  Grip grip;
  const GripInput wrong{.mapped_pitch_rad = -28 * kRadPerDeg, .measured_pitch_rad = 0.0};
  const GripInput right{.mapped_pitch_rad = -28 * kRadPerDeg,
                        .measured_pitch_rad = -27 * kRadPerDeg};
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(drive(grip, 0.1, 0.8, wrong), Traction::kGripping);
    EXPECT_EQ(drive(grip, 0.1, 0.1, right), Traction::kGripping);
  }
}

}  // namespace
}  // namespace tp100::bridge
