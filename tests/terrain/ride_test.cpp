#include "terrain/ride.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "support/alloc_count.h"

namespace tp100::terrain {
namespace {

constexpr double kSlope = 28 * kRadPerDeg;
constexpr double kWayM = 5e-4, kStepS = 5e-3;

course::Terrain ramp_at_half_a_metre() {
  course::Terrain terrain;
  terrain.ramps.push_back({{0.5, 0.0, 0.0}, 0.08, kSlope, 0.2, kSlope, 0.4});
  return terrain;
}

course::Terrain block_at_half_a_metre() {
  course::Terrain terrain;
  terrain.blocks.push_back({{0.5, 0.0, 0.0}, 0.037, 0.1, 0.4});
  return terrain;
}

/// Drives along x until `x_m`; returns the way along the ground.
template <class Watch>
double drive(Ride& ride, Pose& pose, double x_m, Watch watch) {
  double way_m = 0.0;
  while (pose.x_m < x_m && way_m < 5.0) {
    const RideState& on = ride.advance(pose, kWayM, kStepS);
    pose.x_m += kWayM * on.incline.planar;
    way_m += kWayM;
    watch(on);
  }
  return way_m;
}

TEST(Ride, OnAPlaneEveryMillimetreGoesAhead) {
  const World world({}, {});
  Ride ride(world, {});
  Pose pose{};
  EXPECT_FALSE(ride.state().climbing);
  EXPECT_NEAR(drive(ride, pose, 1.0, [](const RideState&) {}), 1.0, 2 * kWayM);
  EXPECT_EQ(ride.state().obstacle, Obstacle::kNone);
}

TEST(Ride, OverARampTheWayIsThatOverItsSurface) {
  const World world(ramp_at_half_a_metre(), {});
  Ride ride(world, {});
  Pose pose{};
  double steepest = 0.0, highest = 0.0;
  const double way_m = drive(ride, pose, 1.0, [&](const RideState& on) {
    steepest = std::max(steepest, on.incline.slope_rad);
    highest = std::max(highest, on.height_m);
  });
  // Two faces of 0.08 / sin(28 deg) instead of 0.08 / tan(28 deg); rounding off the corners saves
  // a little.
  const double surface_m = 1.0 + 2.0 * 0.08 * (1.0 / std::sin(kSlope) - 1.0 / std::tan(kSlope));
  EXPECT_NEAR(way_m, surface_m, 0.006);
  EXPECT_NEAR(steepest, kSlope, 0.01);
  EXPECT_GT(highest, 0.079);
  EXPECT_EQ(ride.state().height_m, 0.0);
}

TEST(Ride, OverABlockItClimbsTipsAndComesDownAgain) {
  const World world(block_at_half_a_metre(), {});
  Ride ride(world, {});
  Pose pose{};
  double nose_up = 0.0, nose_down = 0.0, highest = 0.0;
  bool climbed = false;
  const double way_m = drive(ride, pose, 1.0, [&](const RideState& on) {
    highest = std::max(highest, on.height_m);
    nose_up = std::max(nose_up, -on.pitch_rad);
    nose_down = std::max(nose_down, on.pitch_rad);
    climbed = climbed || on.climbing;
  });
  EXPECT_TRUE(climbed);
  EXPECT_NEAR(nose_up * kDegPerRad, 45.0, 4.0);
  EXPECT_GT(nose_down, 15 * kRadPerDeg);
  EXPECT_GT(highest, 0.036);
  EXPECT_EQ(ride.state().height_m, 0.0);
  EXPECT_FALSE(ride.state().climbing);
  EXPECT_EQ(ride.state().pitch_rad, 0.0);
  EXPECT_GT(way_m, 1.02);
  EXPECT_LT(way_m, 1.12);
}

TEST(Ride, ABlockIsASlopeOfThePitchUphillBeforeAndDownhillBehindIt) {
  const World world(block_at_half_a_metre(), {});
  Ride ride(world, {});
  Pose pose{};
  double steepest_up = 0.0, steepest_down = 0.0;
  drive(ride, pose, 1.0, [&](const RideState& on) {
    ASSERT_EQ(on.incline.slope_rad, -on.pitch_rad) << pose.x_m;
    if (!on.climbing) return;
    steepest_up = std::max(steepest_up, on.incline.slope_rad);
    steepest_down = std::min(steepest_down, on.incline.slope_rad);
  });
  EXPECT_GT(steepest_up, 40 * kRadPerDeg);
  EXPECT_LT(steepest_down, -15 * kRadPerDeg);
}

TEST(Ride, WhoBacksOffABlockStandsOnTheFloorAgain) {
  const World world(block_at_half_a_metre(), {});
  Ride ride(world, {});
  Pose pose{};
  while (!ride.state().climbing)
    pose.x_m += kWayM * ride.advance(pose, kWayM, kStepS).incline.planar;
  const double touch_m = pose.x_m;
  // Up the riser a little; back on the way, and off.
  for (int i = 0; i < 20; ++i) pose.x_m += kWayM * ride.advance(pose, kWayM, kStepS).incline.planar;
  EXPECT_LT(ride.state().pitch_rad, 0.0);
  for (int i = 0; i < 60; ++i)
    pose.x_m -= kWayM * ride.advance(pose, -kWayM, kStepS).incline.planar;
  EXPECT_LT(pose.x_m, touch_m - 0.01);
  EXPECT_FALSE(ride.state().climbing);
  EXPECT_EQ(ride.state().pitch_rad, 0.0);
}

TEST(Ride, ARealBodyClimbsWhenItsNoseRisesNotWhereTheMapHasTheBlock) {
  const World world(block_at_half_a_metre(), {});
  Ride ride(world, {});
  const double touch_m = 0.45 - 0.133 / 2.0 - 0.026;
  Pose pose{.x_m = touch_m + 0.03};
  ride.advance(pose, kWayM, kStepS, Attitude{});
  EXPECT_FALSE(ride.state().climbing);
  ride.advance(pose, kWayM, kStepS, Attitude{.pitch_rad = -4 * kRadPerDeg});
  EXPECT_TRUE(ride.state().climbing);
  // Until it was noticed the pose went ahead, the robot went up.
  EXPECT_LT(ride.state().incline.planar * kWayM, -0.005);
}

TEST(Ride, ANoseThatRisesFarFromAnyBlockIsASlope) {
  const World world(block_at_half_a_metre(), {});
  Ride ride(world, {});
  ride.advance({}, kWayM, kStepS, Attitude{.pitch_rad = -10 * kRadPerDeg});
  EXPECT_FALSE(ride.state().climbing);
  EXPECT_NEAR(ride.state().incline.planar, std::cos(10 * kRadPerDeg), 1e-12);
}

TEST(Ride, TheNoiseOfALevelImuIsNoTerrain) {
  const World world(block_at_half_a_metre(), {});
  Ride ride(world, {});
  ride.advance({}, kWayM, kStepS, Attitude{.roll_rad = 0.02, .pitch_rad = 0.02});
  EXPECT_EQ(ride.state().incline.planar, 1.0);
  EXPECT_EQ(ride.state().pitch_rad, 0.0);
}

TEST(Ride, WhoStartsBehindABlockDoesNotClimbIt) {
  const World world(block_at_half_a_metre(), {});
  Ride ride(world, {});
  Pose pose{.x_m = 0.7};
  drive(ride, pose, 1.0, [](const RideState& on) { ASSERT_FALSE(on.climbing); });
}

TEST(Ride, SurfacesAddTheirSlip) {
  course::Terrain terrain;
  terrain.surfaces.push_back({"felt", {0.0, 0.0, 0.0}, 1.0, 1.0, 1.0, 0.07});
  const World world(terrain, {});
  Ride ride(world, {});
  EXPECT_EQ(ride.advance({}, kWayM, kStepS).incline.slip_offset, 0.07);
  EXPECT_EQ(ride.advance({.x_m = 2.0}, kWayM, kStepS).incline.slip_offset, 0.0);
}

TEST(Ride, AllocatesNothing) {
  const World world(block_at_half_a_metre(), {});
  Ride ride(world, {});
  Pose pose{};
  const test::AllocCount watch;
  drive(ride, pose, 1.0, [](const RideState&) {});
  EXPECT_EQ(watch.calls(), 0u);
}

}  // namespace
}  // namespace tp100::terrain
