#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"
#include "estimation/attitude.h"
#include "interval.h"
#include "model/step_climb.h"

namespace tp100::estimation {
namespace {

constexpr double kSpeedMps = 0.1;
constexpr double kSpacingM = 0.133;

/// Feeds a pitch to both states, as the step does.
class TerrainFollower {
 public:
  void lean(double nose_up_rad) {
    const Slope slope = slope_.update(-nose_up_rad, kDt);
    obstacle_.update(-nose_up_rad, slope, kSpeedMps * kDt);
    if (obstacle_.state() != ObstacleClass::kNone) seen = obstacle_.state();
  }
  void level(double duration_s) {
    for (double t = 0.0; t < duration_s; t += kDt) lean(0.0);
  }
  /// Drives onto and up a ramp: the front axle first, then the whole body; without the descent.
  void ramp(double slope_rad, double length_m) {
    for (double s = 0.0; s < length_m; s += kSpeedMps * kDt) lean(ramp_lean(slope_rad, s));
  }
  static double ramp_lean(double slope_rad, double distance_m) {
    return std::min(slope_rad,
                    std::asin(std::min(1.0, distance_m * std::sin(slope_rad) / kSpacingM)));
  }
  ObstacleClass state() const { return obstacle_.state(); }
  Slope slope() const { return slope_.state(); }

  ObstacleClass seen = ObstacleClass::kNone;

 private:
  SlopeState slope_{AttitudeParameters{}};
  ObstacleState obstacle_{kSpacingM};
};

TEST(ObstacleState, RampsOfEverySlopeAreRamps) {
  for (double deg = 6.0; deg <= 33.0; deg += 2.0) {
    TerrainFollower terrain_follower;
    terrain_follower.level(0.5);
    terrain_follower.ramp(deg * kRadPerDeg, 0.4);
    EXPECT_EQ(terrain_follower.state(), ObstacleClass::kRamp) << deg;
  }
}

TEST(ObstacleState, StepsOfEveryHeightAreSteps) {
  for (const double height_m : {0.020, 0.025, 0.030, 0.037}) {
    model::StepClimb climb({}, {.height_m = height_m, .depth_m = 0.1});
    climb.reset(0.05);
    TerrainFollower terrain_follower;
    for (int i = 0; i < 1600; ++i) {
      terrain_follower.lean(-climb.advance(kSpeedMps * kDt, kDt).pitch_rad);
      if (terrain_follower.state() != ObstacleClass::kNone) {
        ASSERT_EQ(terrain_follower.state(), ObstacleClass::kBlock)
            << height_m << " after " << i * kDt << " s";
      }
    }
    EXPECT_EQ(terrain_follower.seen, ObstacleClass::kBlock) << height_m;
    EXPECT_EQ(terrain_follower.state(), ObstacleClass::kNone)
        << "the floor behind the step is flat";
  }
}

/// The nose rises by the share `before` of the distance driven up to `change_m`, then by `after`.
ObstacleClass after_climb(double before, double change_m, double after, double end_m) {
  TerrainFollower terrain_follower;
  terrain_follower.level(0.5);
  double sine = 0.0;
  for (double s = 0.0; s < end_m; s += kSpeedMps * kDt) {
    sine += (s < change_m ? before : after) * kSpeedMps * kDt / kSpacingM;
    terrain_follower.lean(std::asin(sine));
  }
  return terrain_follower.state();
}

TEST(ObstacleState, AStepWhoseRiserMakesTracksSlipIsOneAfterAll) {
  EXPECT_EQ(after_climb(0.42, 0.03, 0.75, 0.06), ObstacleClass::kBlock);
}

TEST(ObstacleState, AStepWhoseEdgeMakesTracksSlipIsToldByItsRiser) {
  EXPECT_EQ(after_climb(0.7, 0.01, 0.25, 0.04), ObstacleClass::kBlock);
}

TEST(ObstacleState, TheOtherSideBelongsToTheSameObstacle) {
  TerrainFollower terrain_follower;
  terrain_follower.ramp(20.0 * kRadPerDeg, 0.3);
  terrain_follower.level(2.0);
  EXPECT_EQ(terrain_follower.state(), ObstacleClass::kNone);
  for (int i = 0; i < 200; ++i) terrain_follower.lean(-20.0 * kRadPerDeg);
  EXPECT_EQ(terrain_follower.slope(), Slope::kDown);
  EXPECT_EQ(terrain_follower.state(), ObstacleClass::kRamp);
}

TEST(ObstacleState, NoiseOfTheLevelIsNothing) {
  TerrainFollower terrain_follower;
  for (int i = 0; i < 4000; ++i) terrain_follower.lean(2.5 * kRadPerDeg * std::sin(i * 0.3));
  EXPECT_EQ(terrain_follower.seen, ObstacleClass::kNone);
}

}  // namespace
}  // namespace tp100::estimation
