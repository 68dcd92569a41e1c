// Climbs over blocks of many shapes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>
#include <vector>

#include "model/step_climb.h"

namespace tp100::model {
namespace {

constexpr double kSpeed = 0.10;

struct Case {
  ClimbGeometry geometry{};
  BlockShape block{};
  double speed = kSpeed;
};

ClimbGeometry scaled(double factor) {
  ClimbGeometry g;
  for (double* length : {&g.axle_spacing_m, &g.wheel_radius_m, &g.com_forward_m, &g.com_height_m,
                         &g.body_length_m, &g.body_height_m}) {
    *length *= factor;
  }
  return g;
}

ClimbGeometry com_forward(double forward_m) {
  ClimbGeometry g;
  g.com_forward_m = forward_m;
  return g;
}

void PrintTo(const Case& what, std::ostream* out) {
  *out << what.block.height_m << " x " << what.block.depth_m << " m, com "
       << what.geometry.com_forward_m << ", " << what.speed << " m/s";
}

std::vector<Case> cases() {
  return {{},
          {.block = {0.026, 0.100}},
          {.block = {0.020, 0.100}},
          {.block = {0.003, 0.100}},
          {.block = {0.039, 0.100}},
          {.block = {0.037, 0.030}},
          {.block = {0.037, 0.200}},
          {.geometry = com_forward(0.060), .block = {0.030, 0.100}},
          {.geometry = com_forward(0.075)},
          {.geometry = scaled(2.0), .block = {0.074, 0.200}, .speed = 0.2},
          {.speed = 0.05},
          {.speed = 0.14},
          {.block = {0.037, 0.200}, .speed = 0.28}};
}

std::vector<ClimbState> drive(const Case& what, double dt_s, double duration_s) {
  StepClimb climb(what.geometry, what.block);
  climb.begin(0.02);
  std::vector<ClimbState> states{climb.state()};
  const auto steps = static_cast<int>(duration_s / dt_s);
  for (int i = 0; i < steps; ++i) states.push_back(climb.advance(what.speed * dt_s, dt_s));
  return states;
}

double distance_m(const Case& what) {
  return 2.5 * what.geometry.body_length_m + what.block.depth_m + 0.05;
}

class EveryClimb : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Climbs, EveryClimb, testing::ValuesIn(cases()));

TEST_P(EveryClimb, PassesThePhasesInOrderAndEndsFlatBehindTheBlock) {
  const Case& what = GetParam();
  const auto states = drive(what, 1e-3, distance_m(what) / what.speed);
  std::vector<ClimbPhase> seen;
  for (const ClimbState& state : states)
    if (seen.empty() || seen.back() != state.phase) seen.push_back(state.phase);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  const bool riser = what.block.height_m > what.geometry.wheel_radius_m;
  const bool flat = std::ranges::count(seen, ClimbPhase::kFlat) == 1;
  EXPECT_EQ(std::ranges::count(seen, ClimbPhase::kRiser), riser ? 1 : 0);
  EXPECT_EQ(seen.size(), 8u + (riser ? 1u : 0u) + (flat ? 1u : 0u));
  EXPECT_TRUE(flat || what.block.depth_m < 0.1);
  const StepClimb climb(what.geometry, what.block);
  EXPECT_NEAR(climb.touch_x_m(), climb.state().reference_m.x, 1e-12) << "it begins at first touch";
  const ClimbState& last = states.back();
  EXPECT_EQ(last.phase, ClimbPhase::kDown);
  EXPECT_EQ(last.pitch_rad, 0.0);
  EXPECT_NEAR(last.reference_m.z, 0.0, 1e-12);
  EXPECT_GT(last.reference_m.x - what.geometry.axle_spacing_m / 2, what.block.depth_m);
  EXPECT_NEAR(last.reference_m.x - states[states.size() - 2].reference_m.x, what.speed * 1e-3,
              1e-12);
}

TEST_P(EveryClimb, NeverEntersTheGroundOrTheBlock) {
  const Case& what = GetParam();
  const double radius = what.geometry.wheel_radius_m, height = what.block.height_m;
  for (const ClimbState& state : drive(what, 1e-3, distance_m(what) / what.speed)) {
    const double s = std::sin(-state.pitch_rad), c = std::cos(state.pitch_rad);
    for (double along = -0.5; along <= 0.501; along += 0.02) {
      // The stadium is the hull of circles along the line between the axles.
      const double forward = along * what.geometry.axle_spacing_m;
      const double x = state.reference_m.x + forward * c - radius * s;
      const double z = state.reference_m.z + forward * s + radius * c;
      ASSERT_GE(z, radius - 1e-9);
      const double dx = std::max({-x, 0.0, x - what.block.depth_m});
      const double dz = std::max(0.0, z - height);
      ASSERT_GE(std::hypot(dx, dz), radius - 1e-9)
          << "phase " << static_cast<int>(state.phase) << " travel " << state.travel_m;
    }
  }
}

// No body of this size turns faster than 15 rad/s while it falls.
TEST_P(EveryClimb, MovesWithoutAJump) {
  const Case& what = GetParam();
  const double dt = 4e-5;
  const auto states = drive(what, dt, distance_m(what) / what.speed);
  for (std::size_t i = 1; i < states.size(); ++i) {
    const ClimbState &a = states[i - 1], &b = states[i];
    const double turned = std::abs(b.pitch_rad - a.pitch_rad);
    ASSERT_LE(turned, 15.0 * dt) << i;
    ASSERT_LE(std::hypot(b.reference_m.x - a.reference_m.x, b.reference_m.z - a.reference_m.z),
              what.geometry.body_length_m * turned + 1.2 * what.speed * dt)
        << i;
  }
}

// Which decides where the rear contact lifts off.
TEST_P(EveryClimb, BendsAsItsRateChanges) {
  const Case& what = GetParam();
  const ClimbCurve curve(what.geometry, what.block);
  const double h = 1e-5;
  for (double s = curve.marks().wrap_end + 0.001; s < curve.marks().cross_end; s += 0.003) {
    const double bend = (curve.cross(s + h).rate_radpm - curve.cross(s - h).rate_radpm) / (2 * h);
    EXPECT_NEAR(curve.cross_bend(s), bend, 1e-5 * std::abs(bend) + 1e-6);
  }
}

TEST_P(EveryClimb, ComesOutTheSameWhateverTheStep) {
  const Case& what = GetParam();
  const double duration = distance_m(what) / what.speed;
  StepClimb coarse(what.geometry, what.block);
  StepClimb fine(what.geometry, what.block);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step(1e-3, 5e-2);
  for (double at = 0.0; at < duration;) {
    const double dt = step(random);
    coarse.advance(what.speed * dt, dt);
    for (int i = 0; i < 16; ++i) fine.advance(what.speed * dt / 16, dt / 16);
    at += dt;
    // Only the moment at which the rear contact lifts off is resolved to one step of the fall.
    ASSERT_NEAR(coarse.state().pitch_rad, fine.state().pitch_rad, 2e-5);
    ASSERT_NEAR(coarse.state().reference_m.x, fine.state().reference_m.x, 1e-5);
    ASSERT_NEAR(coarse.state().reference_m.z, fine.state().reference_m.z, 1e-5);
  }
  EXPECT_EQ(coarse.state().phase, ClimbPhase::kDown);
}

}  // namespace
}  // namespace tp100::model
