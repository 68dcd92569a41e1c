// How a robot climbs a block, and which ones it can climb.

#include "model/step_climb.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "core/error.h"
#include "model/climb_curve.h"
#include "support/refusal.h"

namespace tp100::model {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kNoLength = std::numeric_limits<double>::quiet_NaN();

ClimbGeometry with_com_height(double height_m) {
  ClimbGeometry geometry;
  geometry.com_height_m = height_m;
  return geometry;
}

/// The centre of mass.
PlaneVector com_of(const ClimbState& state, const ClimbGeometry& g = {}) {
  const double s = std::sin(-state.pitch_rad), c = std::cos(state.pitch_rad);
  const double forward = g.com_forward_m - g.axle_spacing_m / 2.0;
  return {state.reference_m.x + forward * c - g.com_height_m * s,
          state.reference_m.z + forward * s + g.com_height_m * c};
}

/// The body between two states that are a short time apart.
struct Moving {
  Moving(const ClimbState& before, const ClimbState& after, double dt_s)
      : rate_radps((after.pitch_rad - before.pitch_rad) / dt_s) {
    const PlaneVector a = com_of(before), b = com_of(after);
    com_m = {(a.x + b.x) / 2.0, (a.z + b.z) / 2.0};
    com_mps = {(b.x - a.x) / dt_s, (b.z - a.z) / dt_s};
  }
  PlaneVector com_m{}, com_mps{};
  double rate_radps;
};

TEST(ClimbLimit, AndTipAngleAreThePublishedOnes) {
  // The published values are the smallest heights, in steps of 0.2 mm, that cannot be climbed.
  EXPECT_NEAR(climb_limit_m(with_com_height(0.018)), 0.0446, 2e-4);
  EXPECT_NEAR(climb_limit_m(with_com_height(0.022)), 0.0404, 2e-4);
  EXPECT_NEAR(climb_limit_m(with_com_height(0.026)), 0.0366, 2e-4);
  EXPECT_NEAR(climb_limit_m(with_com_height(0.030)), 0.0336, 2e-4);
  EXPECT_NEAR(tip_angle_rad({}, 0.037).value() * kDegPerRad, 40.1, 0.05);
}

TEST(ClimbLimit, IsTheHighestStepOfACoarseSearchOverAllAngles) {
  for (const auto& [com_m, forward_m] : {std::pair{0.004, 0.0665}, std::pair{0.022, 0.0665},
                                         std::pair{0.09, 0.0665}, std::pair{0.02, 0.01}}) {
    ClimbGeometry g = with_com_height(com_m);
    g.com_forward_m = forward_m;
    double best = 0.0;
    // Up to where the edge leaves the flat of the track.
    const double last = std::atan2(g.com_forward_m, g.com_height_m);
    for (double angle = 0.0; angle < last; angle += 1e-4) {
      const double height = g.wheel_radius_m * (1 - std::cos(angle)) +
                            g.com_forward_m * std::sin(angle) -
                            g.com_height_m * std::sin(angle) * std::tan(angle);
      best = std::max(best, height);
      if (best > height) continue;
      const auto tip = tip_angle_rad(g, height);
      ASSERT_TRUE(tip.has_value());
      ASSERT_NEAR(*tip, angle, 1e-3) << "where the centre of mass passes the edge";
    }
    EXPECT_NEAR(climb_limit_m(g), best, 1e-5) << com_m;
    EXPECT_TRUE(tip_angle_rad(g, climb_limit_m(g) - 1e-6)) << com_m;
    EXPECT_FALSE(tip_angle_rad(g, climb_limit_m(g) + 1e-6)) << com_m;
  }
}

/// What is wrong with this block for this robot; empty: nothing.
std::string refused(const ClimbGeometry& geometry, const BlockShape& block = {}) {
  return test::refusal([&] { check_climb(geometry, block); });
}

TEST(CheckClimb, NamesTheLimitOfAStepThatIsTooHigh) {
  EXPECT_THAT(refused(with_com_height(0.030), {0.037, 0.1}),
              AllOf(HasSubstr("37.0 mm"), HasSubstr("33.4 mm")));
}

TEST(CheckClimb, RefusesWhatIsNoGeometry) {
  EXPECT_EQ(refused({}), "");
  EXPECT_EQ(refused({}, {0.037, std::numeric_limits<double>::infinity()}), "");
  for (const BlockShape& block :
       {BlockShape{kNoLength, 0.1}, {0.037, kNoLength}, {0.037, 0.0}, {-0.01, 0.1}})
    EXPECT_NE(refused({}, block), "");
  ClimbGeometry geometry;
  geometry.com_forward_m = 0.140;
  EXPECT_NE(refused(geometry), "");
  EXPECT_THROW(ClimbCurve({}, {0.2, 0.1}), UserError);
}

TEST(ClimbCurve, IsFiniteEvenWhereTheRearCannotReachTheGround) {
  const ClimbGeometry small_wheels{.wheel_radius_m = 0.012, .com_height_m = 0.015};
  const ClimbCurve curve(small_wheels, {0.036, 0.1});
  const double edge_at_the_axle_m = curve.marks().flat_begin + small_wheels.com_forward_m;
  EXPECT_NEAR(curve.cross(edge_at_the_axle_m).angle_rad, kPi, 1e-6);
}

TEST(CheckClimb, EveryLengthOfTheRobotIsPositiveAndFinite) {
  const struct {
    double ClimbGeometry::*length;
    const char* name;
  } lengths[] = {{&ClimbGeometry::axle_spacing_m, "axle spacing"},
                 {&ClimbGeometry::wheel_radius_m, "track radius"},
                 {&ClimbGeometry::com_forward_m, "centre of mass ahead of the rear axle"},
                 {&ClimbGeometry::com_height_m, "centre of mass height"},
                 {&ClimbGeometry::body_length_m, "body length"},
                 {&ClimbGeometry::body_height_m, "body height"}};
  for (const auto& [length, name] : lengths) {
    for (const double value : {0.0, -0.1, kNoLength, std::numeric_limits<double>::infinity()}) {
      ClimbGeometry geometry;
      geometry.*length = value;
      EXPECT_THAT(refused(geometry),
                  HasSubstr(std::string(name) + " must be a positive length in metres"))
          << value;
    }
  }
}

TEST(CheckClimb, RefusesABlockBehindWhichTheRobotFallsOnItsNoseWithTheLimitThatApplies) {
  ClimbGeometry geometry;
  geometry.com_forward_m = 0.125;
  ASSERT_GT(climb_limit_m(geometry), 0.060);
  EXPECT_NE(refused(geometry, {0.060, 0.1}), "");
  const double lowest_m =
      std::hypot(geometry.axle_spacing_m - geometry.com_forward_m, geometry.wheel_radius_m) +
      geometry.wheel_radius_m;
  EXPECT_EQ(refused(geometry, {lowest_m - 1e-6, 0.1}), "");
  EXPECT_THAT(refused(geometry, {lowest_m + 1e-6, 0.1}), HasSubstr("below 53.2 mm"));
}

TEST(StepClimb, GivesThePublishedCheckValues) {
  const ClimbCurve curve({}, {});
  const ClimbMarks& marks = curve.marks();
  EXPECT_NEAR(marks.riser_end, 0.0132, 5e-5);
  EXPECT_NEAR(curve.riser(marks.riser_end).angle_rad * kDegPerRad, 4.74, 5e-3);
  EXPECT_NEAR(marks.wrap_end, 0.0518, 5e-5);
  EXPECT_NEAR(curve.wrap(marks.wrap_end).angle_rad * kDegPerRad, 15.7, 0.05);
  EXPECT_NEAR(marks.cross_end, 0.1369, 1e-4);
  EXPECT_NEAR(curve.cross(marks.cross_end).angle_rad * kDegPerRad, 40.1, 0.05);
  StepClimb climb({}, {});
  while (climb.state().phase != ClimbPhase::kFlat) climb.advance(1e-5, 1e-4);
  EXPECT_NEAR(climb.state().travel_m, 0.1764, 5e-3)
      << "where it lands on the block; it lifts off before its mass is over the edge, as published";
}

// There the ground no longer pushes: just after, the body's rotation accelerates as just before.
TEST(StepClimb, LiftsOffWhereItsRearContactWouldHaveToPull) {
  constexpr double kStepS = 1e-4;
  for (const double mps : {0.05, 0.10, 0.20}) {
    StepClimb climb({}, {});
    const auto rate = [&] {
      const double before_rad = climb.state().pitch_rad;
      return (climb.advance(mps * kStepS, kStepS).pitch_rad - before_rad) / kStepS;
    };
    double last = 0.0, before = 0.0, here = 0.0;
    while (climb.state().phase != ClimbPhase::kTip) {
      before = last;
      last = here;
      here = rate();
    }
    const double slower = (last - before) / kStepS, first = rate();
    EXPECT_NEAR((rate() - first) / kStepS, slower, 0.05 * std::abs(slower)) << mps;
    EXPECT_GT(std::abs(slower), 0.01);
  }
}

TEST(StepClimb, FallsWithoutLosingEnergyWhenTheTracksStand) {
  StepClimb climb({}, {});
  // So slow that it does not lift off before its mass is over the edge.
  while (climb.state().phase != ClimbPhase::kTip) climb.advance(1e-5, 0.1);
  climb.advance(1e-4, 1e-3);
  constexpr double kStepS = 1e-4;
  const ClimbState begin = climb.state();
  const auto energy = [](const Moving& body) {
    return 9.80665 * body.com_m.z +
           (body.com_mps.x * body.com_mps.x + body.com_mps.z * body.com_mps.z +
            gyration_squared_m2({}) * body.rate_radps * body.rate_radps) /
               2;
  };
  const double before = energy({begin, climb.advance(0.0, kStepS), kStepS});
  double fastest = 0.0;
  int falling = 0;
  for (ClimbState last = climb.state();; ++falling, last = climb.state()) {
    ASSERT_LT(falling, 50'000);
    if (climb.advance(0.0, kStepS).phase != ClimbPhase::kTip) break;
    const Moving body(last, climb.state(), kStepS);
    ASSERT_NEAR(energy(body), before, 1e-6);
    fastest = std::max(fastest, std::abs(body.rate_radps));
  }
  EXPECT_GT(falling, 500);
  EXPECT_GT(fastest * kDegPerRad, 300.0);
  EXPECT_EQ(climb.state().phase, ClimbPhase::kFlat);
}

TEST(StepClimb, DrivingBackOnTheWayUpRetracesIt) {
  StepClimb climb({}, {});
  climb.begin(0.01);
  std::vector<ClimbState> up;
  for (int i = 0; i < 140; ++i) up.push_back(climb.advance(1e-3, 1e-2));
  ASSERT_EQ(up.back().phase, ClimbPhase::kCross);
  for (std::size_t i = up.size() - 1; i-- > 0;) {
    const ClimbState& back = climb.advance(-1e-3, 1e-2);
    EXPECT_NEAR(back.pitch_rad, up[i].pitch_rad, 1e-9);
    EXPECT_NEAR(back.reference_m.x, up[i].reference_m.x, 1e-9);
  }
  EXPECT_NEAR(climb.advance(-0.05, 0.5).reference_m.z, 0.0, 1e-12);
  EXPECT_EQ(climb.state().phase, ClimbPhase::kApproach);
}

TEST(StepClimb, DrivingBackOffTheBlockTipsBackOntoTheRear) {
  StepClimb climb({}, {});
  while (climb.state().phase != ClimbPhase::kFlat) climb.advance(1e-4, 1e-3);
  bool tipped = false;
  for (int i = 0; i < 4000; ++i) {
    const ClimbState& state = climb.advance(-1e-4, 1e-3);
    tipped |= state.phase == ClimbPhase::kTip;
    ASSERT_LE(state.pitch_rad, 0.0);
  }
  EXPECT_TRUE(tipped);
  EXPECT_EQ(climb.state().phase, ClimbPhase::kApproach);
}

// The blow of that edge has no lever about it. The body then turns about a nearer point, and
// faster.
TEST(StepClimb, LandingBeyondAShortBlockItKeepsItsAngularMomentumAboutTheFarEdge) {
  constexpr double kDepthM = 0.01, kHeightM = 0.037;
  StepClimb climb({}, {kHeightM, kDepthM});
  const auto step = [&] {
    const ClimbState from = climb.state();
    return Moving(from, climb.advance(1e-6, 1e-5), 1e-5);
  };
  const auto momentum = [](const Moving& body) {
    return (body.com_m.x - kDepthM) * body.com_mps.z - (body.com_m.z - kHeightM) * body.com_mps.x -
           gyration_squared_m2({}) * body.rate_radps;
  };
  Moving before = step(), landing = before;
  while (climb.state().phase != ClimbPhase::kTipOff) {
    ASSERT_LT(climb.state().travel_m, 0.5);
    before = landing;
    landing = step();
  }
  const Moving after = step();
  EXPECT_GT(before.rate_radps, 3.0);
  EXPECT_NEAR(momentum(after), momentum(before), 2e-3 * std::abs(momentum(before)));
  EXPECT_GT(after.rate_radps, 1.02 * before.rate_radps);
}

TEST(StepClimb, StandsStillWhileTheTracksStandExceptWhereItFalls) {
  StepClimb climb({}, {});
  std::map<ClimbPhase, int> held;
  for (int i = 0; i < 4000; ++i) {
    climb.advance(1e-4, 1e-3);
    if (i % 50 != 0) continue;
    StepClimb still = climb;
    const ClimbState before = climb.state();
    const ClimbState after = still.advance(0.0, 0.2);
    const bool falls = before.phase == ClimbPhase::kTip || before.phase == ClimbPhase::kTipOff;
    EXPECT_EQ(before.pitch_rad != after.pitch_rad, falls);
    EXPECT_TRUE(falls || before.reference_m.x == after.reference_m.x);
    ++held[before.phase];
  }
  EXPECT_GE(held.size(), 8u);
}

TEST(StepClimb, APlateauIsNeverLeft) {
  StepClimb climb({}, {0.037, std::numeric_limits<double>::infinity()});
  climb.advance(5.0, 50.0);
  EXPECT_EQ(climb.state().phase, ClimbPhase::kFlat);
  EXPECT_NEAR(climb.state().reference_m.z, 0.037, 1e-12);
}

TEST(StepClimb, IgnoresTimesAndTravelsThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  StepClimb climb({}, {});
  climb.advance(0.15, 1.5);
  const ClimbState before = climb.state();
  for (const auto& [travel_m, dt_s] : {std::pair{nan, 0.1},
                                       {0.1, nan},
                                       {inf, 0.1},
                                       {0.1, inf},
                                       {0.1, 0.0},
                                       {0.1, -1.0},
                                       {1e300, 1e-300}}) {
    climb.advance(travel_m, dt_s);
    EXPECT_EQ(climb.state().travel_m, before.travel_m);
    EXPECT_EQ(climb.state().pitch_rad, before.pitch_rad);
  }
  climb.advance(1e6, 1e9);
  EXPECT_TRUE(std::isfinite(climb.state().reference_m.x));
}

TEST(StepClimb, SurvivesAnyDrivingBackAndForth) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> speed(-0.25, 0.3), dt(1e-4, 0.05);
  for (int run = 0; run < 20; ++run) {
    StepClimb climb({}, {});
    for (int i = 0; i < 2000; ++i) {
      const double step = dt(random);
      const double before_m = com_of(climb.state()).x;
      const ClimbState& state = climb.advance(speed(random) * step, step);
      const PlaneVector com_m = com_of(state);
      ASSERT_LT(std::abs(state.pitch_rad), 1.0);
      ASSERT_GT(com_m.z, 0.0);
      ASSERT_LT(std::abs(com_m.x - before_m), 0.05 * 0.3 + 0.05);
    }
  }
}

TEST(StepClimb, BackingUpItTipsOntoTheBlockWhereItsMassIsOverTheFarEdge) {
  for (const double com_forward_m : {0.063, 0.0665, 0.070}) {
    SCOPED_TRACE(com_forward_m);
    ClimbGeometry geometry;
    geometry.com_forward_m = com_forward_m;
    StepClimb climb(geometry, {});
    for (int i = 0; i < 400 && climb.state().phase != ClimbPhase::kNose; ++i)
      climb.advance(1e-3, 1e-2);
    double until_now_m = 0.0;
    for (int i = 0; i < 10'000 && climb.state().phase == ClimbPhase::kNose; ++i) {
      until_now_m = com_of(climb.state(), geometry).x;
      climb.advance(-1e-5, 1e-4);
    }
    EXPECT_EQ(climb.state().phase, ClimbPhase::kTipOff);
    EXPECT_NEAR(until_now_m, 0.100, 5e-5);
  }
}

}  // namespace
}  // namespace tp100::model
