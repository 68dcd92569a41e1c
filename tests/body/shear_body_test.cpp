#include "sim/body/shear_body.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "drive.h"
#include "support/refusal.h"

namespace tp100::sim {
namespace {

course::Emulated robot(double modulus_m = 0.001, double unevenness = 0.0) {
  course::Emulated values;
  values.contact_law = course::ContactLaw::kShear;
  values.shear.modulus_m = modulus_m;
  values.shear.pressure_unevenness = unevenness;
  return values;
}

double slip_straight(const course::Emulated& values) {
  ShearBody body(values, {}, false);
  const double begin = drive(body, 0.1, 0.1, 1.0).pose.x_m;
  return 1.0 - (drive(body, 0.1, 0.1, 1.0).pose.x_m - begin) / 0.1;
}

double wheelbase_in_a_spin(const course::Emulated& values, double track_mps = 0.08) {
  ShearBody body(values, {}, false);
  const double begin = drive(body, -track_mps, track_mps, 2.0).pose.yaw_rad;
  const double duration_s = 2.0;
  const double yaw = drive(body, -track_mps, track_mps, duration_s).pose.yaw_rad - begin;
  return 2.0 * track_mps * duration_s / yaw;
}

/// Both tracks as lines under an even load with Coulomb friction, in a steady spin: each slides
/// about a point `out_m` outside its centre line, where the moments of the forces along and across
/// it are balanced.
double wheelbase_by_coulomb(double length_m, double gauge_m) {
  double low = 0.0, high = length_m;
  for (int i = 0; i < 60; ++i) {
    const double out_m = (low + high) / 2.0;
    constexpr int kParts = 2000;
    double driving = 0.0, resisting = 0.0;
    for (int k = 0; k < kParts; ++k) {
      const double x_m = length_m * ((k + 0.5) / kParts - 0.5);
      driving += gauge_m / 2.0 * out_m / std::hypot(out_m, x_m);
      resisting += x_m * x_m / std::hypot(out_m, x_m);
    }
    (driving < resisting ? low : high) = out_m;
  }
  return gauge_m + 2.0 * low;
}

TEST(ShearBody, SlipsStraightAheadAsTheLawIntegratedAlongTheTrack) {
  const course::Emulated values = robot(0.005);
  const double slip = slip_straight(values);
  // A shoe has slid by slip * x after the distance x from the front.
  const double ratio = slip * values.body.axle_spacing_m / values.shear.modulus_m;
  const double mobilised = 1.0 - (1.0 - std::exp(-ratio)) / ratio;
  EXPECT_NEAR(values.body.friction * mobilised, values.shear.motion_resistance, 0.003);
}

TEST(ShearBody, TurnsOnHardGroundAsCoulombFrictionHasIt) {
  course::Emulated values = robot(0.0001);
  values.shear.motion_resistance = 0.0;
  const double expected = wheelbase_by_coulomb(values.body.axle_spacing_m, values.body.gauge_m);
  EXPECT_NEAR(wheelbase_in_a_spin(values), expected, 0.01 * expected);
  EXPECT_NEAR(wheelbase_in_a_spin(values, 0.04), expected, 0.01 * expected) << "at any speed";
}

TEST(ShearBody, TurnsHarderThanItsGaugeAndHarderYetWithItsLoadAtTheEnds) {
  const double even = wheelbase_in_a_spin(robot());
  EXPECT_GT(even, 1.1 * robot().body.gauge_m);
  EXPECT_GT(wheelbase_in_a_spin(robot(0.001, 0.9)), 1.15 * even);
}

TEST(ShearBody, TheGroundNeverHoldsMoreThanFriction) {
  course::Emulated values = robot(0.0005, 0.6);
  values.body.com_forward_m = 0.012;
  values.shear.motion_resistance = 0.0;
  ShearBody body(values, {}, false);
  const double limit_mps2 = values.body.friction * kGravityMps2;
  double hardest_mps2 = 0.0;
  for (int i = 0; i < 3000; ++i) {
    // Full speed ahead, on the spot and back, to cover all motions of the tracks.
    body.step(i % 700 < 350 ? 1.0 : -1.0, i % 500 < 250 ? 1.0 : -0.5);
    const BodyState& state = body.state();
    const double felt_mps2 = std::hypot(state.specific_force_mps2[0], state.specific_force_mps2[1]);
    ASSERT_LE(felt_mps2, limit_mps2 * (1.0 + 1e-9)) << i;
    hardest_mps2 = std::max(hardest_mps2, felt_mps2);
    const double weight_n = values.body.mass_kg * kGravityMps2;
    ASSERT_LE(std::abs(state.left_load_n) + std::abs(state.right_load_n),
              values.body.friction * weight_n * (1.0 + 1e-9));
  }
  EXPECT_GT(hardest_mps2, 0.9 * limit_mps2);
}

/// Kinetic energy of the body less the work of the tracks since the start: above 0, the ground has
/// supplied energy.
TEST(ShearBody, TheGroundGivesNoEnergy) {
  for (const double modulus_m : {0.001, 0.025}) {
    course::Emulated values = robot(modulus_m, 0.6);
    ShearBody body(values, {}, false);
    const double inertia = values.body.mass_kg *
                           (std::pow(values.body.length_m, 2) + std::pow(values.body.width_m, 2)) /
                           12.0;
    double work_j = 0.0;
    for (int i = 0; i < 6000; ++i) {
      const double left = i % 2000 < 1000 ? 0.1 : -0.1, right = i % 1500 < 750 ? 0.1 : -0.05;
      body.step(i < 5000 ? left : 0.0, i < 5000 ? right : 0.0);
      const BodyState& state = body.state();
      if (i < 5000) work_j += (state.left_load_n * left + state.right_load_n * right) * 1e-3;
      const double moving_j =
          values.body.mass_kg / 2.0 *
              (std::pow(state.velocity_mps[0], 2) + std::pow(state.velocity_mps[1], 2)) +
          inertia / 2.0 * std::pow(state.rate_radps[2], 2);
      ASSERT_LE(moving_j, work_j + 1e-3) << i;
    }
  }
}

TEST(ShearBody, LeftAndRightAreExactMirrorImages) {
  course::Emulated values = robot(0.002, 0.6), mirrored = values;
  values.body.com_left_m = 0.004;
  mirrored.body.com_left_m = -0.004;
  ShearBody left(values, {}, false);
  ShearBody right(mirrored, {}, false);
  left.disturbance(0.02, 0.1, 0.3);
  right.disturbance(-0.02, -0.1, 0.3);
  const BodyState& a = drive(left, 0.06, 0.1, 2.0);
  const BodyState& b = drive(right, 0.1, 0.06, 2.0);
  EXPECT_EQ(a.pose.x_m, b.pose.x_m);
  EXPECT_EQ(a.pose.y_m, -b.pose.y_m);
  EXPECT_EQ(a.pose.yaw_rad, -b.pose.yaw_rad);
  EXPECT_EQ(a.left_load_n, b.right_load_n);
  EXPECT_GT(a.pose.yaw_rad, 0.1);
}

TEST(ShearBody, TheAccelerometerFeelsTheCurve) {
  ShearBody body(robot(), {}, false);
  drive(body, 0.05, 0.1, 3.0);
  double sideways = 0.0, expected = 0.0;
  for (int i = 0; i < 1000; ++i) {
    body.step(0.05, 0.1);
    const BodyState& state = body.state();
    sideways += state.specific_force_mps2[1] * 1e-3;
    expected +=
        state.rate_radps[2] * std::hypot(state.velocity_mps[0], state.velocity_mps[1]) * 1e-3;
  }
  EXPECT_NEAR(sideways, expected, 0.02 * expected);
  const double stopped = drive(body, 0.0, 0.0, 0.5).pose.yaw_rad;
  EXPECT_NEAR(drive(body, 0.0, 0.0, 2.0).pose.yaw_rad, stopped, 1e-3) << "it settles";
}

TEST(ShearBody, OfASurfaceOnlyTheFrictionCounts) {
  course::Surface everywhere{.name = "oil", .length_m = 20.0, .width_m = 20.0};
  course::Terrain terrain;
  everywhere.slip_offset = 0.3;
  terrain.surfaces = {everywhere};
  ShearBody plain(robot(), {}, false);
  ShearBody offset(robot(), {}, false, terrain);
  EXPECT_EQ(drive(plain, 0.05, 0.1, 1.0).pose.yaw_rad, drive(offset, 0.05, 0.1, 1.0).pose.yaw_rad);
  terrain.surfaces.front().friction_factor = 0.3;
  course::Emulated slippery = robot();
  slippery.body.friction *= 0.3;
  ShearBody oiled(robot(), {}, false, terrain);
  ShearBody smooth(slippery, {}, false);
  EXPECT_EQ(drive(oiled, 0.05, 0.1, 1.0).pose.yaw_rad, drive(smooth, 0.05, 0.1, 1.0).pose.yaw_rad);
  EXPECT_NE(oiled.state().pose.yaw_rad, plain.state().pose.yaw_rad);
}

TEST(ShearBody, KnowsNothingOfTheOtherBodysTerms) {
  course::Emulated other = robot();
  other.body.track_deficit_left = 0.4;
  other.body.creep_right = 1.5;
  other.body.mid_lift_m = 0.004;
  ShearBody one(robot(), {}, false), two(other, {}, false);
  EXPECT_EQ(drive(one, 0.05, 0.1, 1.0).pose.yaw_rad, drive(two, 0.05, 0.1, 1.0).pose.yaw_rad);
}

TEST(ShearBody, RefusesWhatIsNotLevelByNameAndPlace) {
  course::Terrain terrain;
  terrain.obstacles = {course::Block{
      .place = {.x_m = 1.25, .y_m = -0.5}, .height_m = 0.03, .depth_m = 0.1, .width_m = 0.4}};
  EXPECT_THAT(test::refusal([&] { make_body(robot(), {}, false, terrain); }),
              testing::AllOf(testing::HasSubstr("--body shear"),
                             testing::HasSubstr("block at (1.25, -0.5)"),
                             testing::HasSubstr("--setup flat")));
}

}  // namespace
}  // namespace tp100::sim
