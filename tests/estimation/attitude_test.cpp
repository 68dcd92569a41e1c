// What the IMU shows: attitude, slope and obstacles by the pitch, and the gyro's bias at rest.

#include "estimation/attitude.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "core/arithmetic.h"
#include "estimation/standstill.h"
#include "interval.h"
#include "model/step_climb.h"
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
    AttitudeFilter filter;
    const double size = share_of_gravity * kG;
    for (int i = 0; i < 40; ++i) filter.update({0, 0, 0}, {-0.6 * size, 0.0, 0.8 * size}, kDt);
    return filter.pitch_rad();
  };
  for (const double share : {0.89, 1.11, 2.0}) EXPECT_EQ(after(share), 0.0) << share;
  for (const double share : {0.91, 1.0, 1.09}) EXPECT_GT(after(share), 0.1) << share;
}

// Both angles go to those of gravity like a low-pass of 0.7 s.
TEST(AttitudeFilter, GravityCountsOverSevenTenthsOfASecond) {
  AttitudeFilter filter;
  const double kept = 0.7 / (0.7 + kDt);
  for (int i = 1; i <= 300; ++i) {
    filter.update({0, 0, 0}, gravity(-0.2, 0.3), kDt);
    ASSERT_NEAR(filter.pitch_rad(), 0.3 * (1.0 - std::pow(kept, i)), 1e-9);
    ASSERT_NEAR(filter.roll_rad(), -0.2 * (1.0 - std::pow(kept, i)), 1e-9);
  }
}

// Else the pitch of a robot that drives drifts by the gyro's offsets.
TEST(AttitudeFilter, WhatTheGyroReadsAtRestIsNoRotation) {
  AttitudeFilter filter;
  const AttitudeFilter::Vector offset_radps = {0.01, -0.02, 0.0};
  for (int i = 0; i < 2000; ++i) filter.level(offset_radps, gravity(0.0, 0.0), kDt);
  for (int i = 0; i < 200; ++i) filter.update(offset_radps, {0, 0, 0}, kDt);
  EXPECT_NEAR(filter.roll_rad(), 0.0, 0.001);
  EXPECT_NEAR(filter.pitch_rad(), 0.0, 0.002);
}

// Without gravity the angles are those of the rotation that the gyro measures; the heading turns
// with them.
TEST(AttitudeFilter, FollowsAnyRotationByTheGyroAlone) {
  test::Sequence any(3);
  for (int round = 0; round < 20; ++round) {
    AttitudeFilter filter;
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
  AttitudeFilter filter;
  filter.update({0, 1.4 / kDt, 0}, {}, kDt);
  EXPECT_NEAR(filter.yaw_rate_radps(1.0), 5.0, 1e-9) << "bounded near the vertical";
}

TEST(AttitudeFilter, ARobotThatIsTiltedOrBeingTiltedTeachesNoLevel) {
  const auto learned = [](const AttitudeFilter::Vector& gyro, double roll, double pitch,
                          double levelled_s) {
    AttitudeFilter filter;
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

constexpr double kDeg = kRadPerDeg;

Slope after(SlopeState& state, double pitch_deg, double duration_s) {
  for (int i = 0; i < std::lround(duration_s / kDt); ++i) state.update(pitch_deg * kDeg, kDt);
  return state.state();
}

TEST(SlopeState, BeginsAboveFourDegreesAndEndsBelowTwoAndAHalfOnceThatLasts) {
  for (const double side : {1.0, -1.0}) {
    const Slope slope = side < 0.0 ? Slope::kUp : Slope::kDown;
    SlopeState state;
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
    slope_ = {};
  }
  ObstacleClass state() const { return obstacle_.state(); }

  ObstacleClass seen = ObstacleClass::kNone;

 private:
  double speed_mps_;
  SlopeState slope_;
  ObstacleState obstacle_{kSpacingM};
};

TEST(ObstacleState, StepsOfEveryHeightAreSteps) {
  for (const double height_m : {0.020, 0.025, 0.030, 0.037}) {
    model::StepClimb climb({}, {.height_m = height_m, .depth_m = 0.1});
    climb.begin(0.05);
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

constexpr double kRate = 0.03;

/// A robot at rest, with what `change` makes of its i-th sample and rate.
class Robot {
 public:
  using Change = std::function<void(Sample&, double& rate_radps, int i)>;

  void feed(
      int samples, const Change& change = [](Sample&, double&, int) {}) {
    for (int i = 0; i < samples; ++i) {
      Sample sample = at_rest;
      double rate = kRate;
      change(sample, rate, i);
      at_rest.device_us += 5000;
      sample.device_us += 5000;
      standstill.update(sample, rate);
    }
  }
  Standstill standstill{Parameters{}};
  Sample at_rest = [] {
    Sample sample;
    sample.imu_age = 0;
    return sample;
  }();
};

TEST(Standstill, NeedsTracksMotorsAndGyroAtRestFromBeginningToEnd) {
  const auto in_the_middle = [](const std::function<void(Sample&, double&)>& change) {
    return [change](Sample& sample, double& rate, int i) {
      if (i == 60) change(sample, rate);
    };
  };
  const struct {
    const char* what;
    Robot::Change change;
    bool rests;
  } cases[] = {
      {"an edge that flickers",
       [](Sample& s, double&, int i) { s.left_counts = s.right_counts = i % 2; }, true},
      {"two edges", in_the_middle([](Sample& s, double&) { s.left_counts = 2; }), false},
      {"two edges right", in_the_middle([](Sample& s, double&) { s.right_counts = -2; }), false},
      {"a slow even turn", [](Sample& s, double&, int i) { s.right_counts = i / 25; }, false},
      {"a duty left", in_the_middle([](Sample& s, double&) { s.left_duty = 0.01; }), false},
      {"a duty right", in_the_middle([](Sample& s, double&) { s.right_duty = -0.01; }), false},
      {"a stale IMU", in_the_middle([](Sample& s, double&) { s.imu_age = 1; }), false},
      {"a jolt", in_the_middle([](Sample&, double& rate) { rate += 0.059; }), true},
      {"a larger one", in_the_middle([](Sample&, double& rate) { rate -= 0.061; }), false},
      {"noise", [](Sample&, double& rate, int i) { rate += i % 2 == 0 ? 0.0099 : -0.0099; }, true},
      {"more noise", [](Sample&, double& rate, int i) { rate += i % 2 == 0 ? 0.0103 : -0.0103; },
       false},
      {"a turn by hand", [](Sample&, double& rate, int i) { rate = 0.3 * std::sin(i * 0.05); },
       false},
      {"the greatest bias", [](Sample&, double& rate, int) { rate = -0.449; }, true},
      {"a turn to the right", [](Sample&, double& rate, int) { rate = -0.451; }, false}};
  for (const auto& of : cases) {
    SCOPED_TRACE(of.what);
    Robot robot;
    robot.feed(120, of.change);
    EXPECT_EQ(robot.standstill.bias_known(), of.rests);
    if (of.rests) continue;
    robot.feed(102);
    EXPECT_TRUE(robot.standstill.bias_known()) << "as soon as after a drive";
    EXPECT_NEAR(robot.standstill.bias_radps(), kRate, 5e-4);
  }
}

}  // namespace
}  // namespace tp100::estimation
