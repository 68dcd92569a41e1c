// What the pitch alone shows: slope, and the class of the obstacle.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/arithmetic.h"
#include "estimation/attitude.h"
#include "interval.h"
#include "model/step_climb.h"

namespace tp100::estimation {
namespace {

constexpr double kDeg = kRadPerDeg;

Slope after(SlopeState& state, double pitch_deg, double duration_s) {
  for (int i = 0; i < std::lround(duration_s / kDt); ++i) state.update(pitch_deg * kDeg, kDt);
  return state.state();
}

TEST(SlopeState, BeginsAboveFourDegreesAndEndsBelowTwoAndAHalfOnceThatLasts) {
  for (const double side : {1.0, -1.0}) {
    const Slope slope = side < 0.0 ? Slope::kUp : Slope::kDown;
    SlopeState state{{}};
    EXPECT_EQ(after(state, side * 3.99, 2.0), Slope::kFlat);
    EXPECT_EQ(after(state, side * 4.01, 0.115), Slope::kFlat);
    EXPECT_EQ(after(state, side * 3.99, 0.005), Slope::kFlat) << "the time begins anew";
    EXPECT_EQ(after(state, side * 4.01, 0.115), Slope::kFlat);
    EXPECT_EQ(after(state, side * 4.01, 0.01), slope);
    EXPECT_EQ(after(state, side * 2.51, 2.0), slope);
    EXPECT_EQ(after(state, side * 2.49, 0.115), slope);
    EXPECT_EQ(after(state, side * 2.49, 0.01), Slope::kFlat);
    EXPECT_EQ(after(state, side * 20.0, 0.2), slope);
    EXPECT_EQ(after(state, side * -3.0, 0.2), Slope::kFlat) << "not steep to the other side";
    EXPECT_EQ(after(state, side * 20.0, 0.2), slope);
    EXPECT_EQ(after(state, side * -20.0, 0.115), slope);
    EXPECT_NE(after(state, side * -20.0, 0.01), slope) << "from climbing to descending at once";
    EXPECT_NE(state.state(), Slope::kFlat);
  }
}

TEST(SlopeState, NoiseAndABumpChangeNothing) {
  SlopeState state{{}};
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 1.5 * kDeg);
  for (int i = 0; i < 20000; ++i) {
    const double bump = i % 400 < 20 ? 8 * kDeg : 0.0;
    ASSERT_EQ(state.update(bump + noise(random), kDt), Slope::kFlat);
  }
}

constexpr double kSpeedMps = 0.1;
constexpr double kSpacingM = 0.133;

/// Feeds a pitch to both states, as the step does.
class Follower {
 public:
  explicit Follower(double speed_mps = kSpeedMps) : speed_mps_(speed_mps) {}

  void lean(double nose_up_rad) {
    const Slope slope = slope_.update(-nose_up_rad, kDt);
    obstacle_.update(-nose_up_rad, slope, speed_mps_ * kDt);
    if (obstacle_.state() != ObstacleClass::kNone) seen = obstacle_.state();
  }
  void level(double distance_m) {
    for (double s = 0.0; s < distance_m; s += kSpeedMps * kDt) lean(0.0);
  }
  /// The nose rises by the share `before` of the distance driven up to `change_m`, then by `after`.
  void climb(double before, double change_m, double after, double end_m) {
    double sine = 0.0;
    for (double s = 0.0; s < end_m; s += kSpeedMps * kDt) {
      sine += (s < change_m ? before : after) * kSpeedMps * kDt / kSpacingM;
      lean(std::asin(sine));
    }
  }
  /// Onto and up a ramp, the front axle first, then the whole body.
  void ramp(double slope_rad) { climb(std::sin(slope_rad), kSpacingM, 0.0, 0.3); }
  void restart() {
    obstacle_.restart();
    slope_ = SlopeState{AttitudeParameters{}};
  }
  ObstacleClass state() const { return obstacle_.state(); }

  ObstacleClass seen = ObstacleClass::kNone;

 private:
  double speed_mps_;
  SlopeState slope_{AttitudeParameters{}};
  ObstacleState obstacle_{kSpacingM};
};

TEST(ObstacleState, RampsOfEverySlopeAreRampsForwardAndBackward) {
  for (const double speed : {kSpeedMps, -kSpeedMps}) {
    Follower follower(speed);
    for (double deg = 6.0; deg <= 34.0; deg += 2.0) {
      follower.level(0.05);
      follower.ramp(deg * kDeg);
      EXPECT_EQ(follower.state(), ObstacleClass::kRamp) << deg;
      follower.level(0.05);
      EXPECT_EQ(follower.state(), ObstacleClass::kNone) << deg;
    }
  }
}

TEST(ObstacleState, StepsOfEveryHeightAreSteps) {
  for (const double height_m : {0.020, 0.025, 0.030, 0.037}) {
    model::StepClimb climb({}, {.height_m = height_m, .depth_m = 0.1});
    climb.reset(0.05);
    Follower follower;
    for (int i = 0; i < 1600; ++i) {
      follower.lean(-climb.advance(kSpeedMps * kDt, kDt).pitch_rad);
      if (follower.state() != ObstacleClass::kNone) {
        ASSERT_EQ(follower.state(), ObstacleClass::kBlock)
            << height_m << " after " << i * kDt << " s";
      }
    }
    EXPECT_EQ(follower.seen, ObstacleClass::kBlock) << height_m;
    EXPECT_EQ(follower.state(), ObstacleClass::kNone) << "the floor behind the step is flat";
  }
}

// A line of 34 deg is a ramp's, over a centimetre; slipping tracks hide a riser at first. Only the
// first four centimetres uphill are judged.
TEST(ObstacleState, AStepIsToldByTheSteepestCentimetreOfItsFirstFour) {
  const auto climbed = [](double before, double change_m, double after, double end_m) {
    Follower forward(kSpeedMps), backward(-kSpeedMps);
    for (Follower* each : {&forward, &backward}) {
      each->level(0.05);
      each->climb(before, change_m, after, end_m);
    }
    EXPECT_EQ(forward.state(), backward.state());
    return forward.state();
  };
  EXPECT_EQ(climbed(0.55, 1.0, 0.0, 0.06), ObstacleClass::kRamp);
  EXPECT_EQ(climbed(0.57, 1.0, 0.0, 0.06), ObstacleClass::kBlock);
  EXPECT_EQ(climbed(0.42, 0.03, 0.75, 0.06), ObstacleClass::kBlock) << "the riser slips";
  EXPECT_EQ(climbed(0.7, 0.011, 0.25, 0.06), ObstacleClass::kBlock) << "the edge slips";
  EXPECT_EQ(climbed(0.7, 0.003, 0.4, 0.06), ObstacleClass::kRamp) << "shorter than a centimetre";
  // The slope state becomes up some 4 cm after the nose began to rise.
  EXPECT_EQ(climbed(0.42, 0.055, 0.75, 0.075), ObstacleClass::kBlock);
  EXPECT_EQ(climbed(0.42, 0.085, 0.75, 0.12), ObstacleClass::kRamp) << "a ramp is certain";
}

TEST(ObstacleState, TheOtherSideBelongsToTheSameObstacleIfItIsNear) {
  for (const bool step : {false, true}) {
    for (const double top_m : {0.2, 0.55, 0.65}) {
      Follower follower;
      step ? follower.climb(0.7, 1.0, 0.0, 0.06) : follower.ramp(20.0 * kDeg);
      follower.level(top_m);
      EXPECT_EQ(follower.state(), ObstacleClass::kNone);
      for (int i = 0; i < 40; ++i) follower.lean(-20.0 * kDeg);
      EXPECT_EQ(follower.state(),
                step && top_m < 0.6 ? ObstacleClass::kBlock : ObstacleClass::kRamp)
          << top_m;
    }
  }
  Follower follower;
  follower.climb(0.7, 1.0, 0.0, 0.06);
  follower.restart();
  for (int i = 0; i < 40; ++i) follower.lean(-20.0 * kDeg);
  EXPECT_EQ(follower.state(), ObstacleClass::kRamp) << "nothing was climbed";
}

TEST(ObstacleState, NoiseOfTheLevelIsNothing) {
  Follower follower;
  for (int i = 0; i < 4000; ++i) follower.lean(2.5 * kDeg * std::sin(i * 0.3));
  EXPECT_EQ(follower.seen, ObstacleClass::kNone);
}

}  // namespace
}  // namespace tp100::estimation
