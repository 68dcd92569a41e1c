#include "terrain/terrain_follower.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/arithmetic.h"

namespace tp100::terrain {
namespace {

constexpr double kSteepRad = 28 * kRadPerDeg;
constexpr double kDistanceM = 5e-4, kStepS = 5e-3;
constexpr double kTouchM = 0.45 - 0.133 / 2.0 - 0.026;  // of the block below

course::Terrain ramp_at_half_a_metre() {
  course::Terrain terrain;
  terrain.obstacles = {course::Ramp{{0.5, 0.0, 0.0}, 0.08, kSteepRad, 0.2, kSteepRad, 0.4}};
  return terrain;
}

course::Terrain block_at_half_a_metre() {
  course::Terrain terrain;
  terrain.obstacles = {course::Block{{0.5, 0.0, 0.0}, 0.037, 0.1, 0.4}};
  return terrain;
}

/// Drives along x until `x_m`; returns the distance along the ground.
template <class Watch>
double drive(TerrainFollower& terrain_follower, Pose& pose, double x_m, Watch watch) {
  double distance_m = 0.0;
  while (pose.x_m < x_m && distance_m < 5.0) {
    const ContactState& on = terrain_follower.advance(pose, kDistanceM, kStepS);
    pose.x_m += kDistanceM * on.incline.horizontal_fraction;
    distance_m += kDistanceM;
    watch(on);
  }
  return distance_m;
}

TEST(TerrainFollower, OverARampTheWayIsThatOverItsSurface) {
  const World world(ramp_at_half_a_metre(), {});
  TerrainFollower terrain_follower(world, {});
  Pose pose{};
  double steepest = 0.0, highest = 0.0;
  const double distance_m = drive(terrain_follower, pose, 1.0, [&](const ContactState& on) {
    steepest = std::max(steepest, on.incline.slope_rad);
    highest = std::max(highest, on.height_m);
    ASSERT_EQ(on.pitch_rad, -on.incline.slope_rad) << "what the page shows of it";
    if (on.height_m > 1e-3) {
      ASSERT_EQ(on.obstacle, ObstacleClass::kRamp);
    }
  });
  // Each of the two faces is 0.08 / sin(28 deg) long instead of 0.08 / tan(28 deg); rounding the
  // corners shortens the path a little.
  const double surface_m =
      1.0 + 2.0 * 0.08 * (1.0 / std::sin(kSteepRad) - 1.0 / std::tan(kSteepRad));
  EXPECT_NEAR(distance_m, surface_m, 0.006);
  EXPECT_NEAR(steepest, kSteepRad, 0.01);
  EXPECT_GT(highest, 0.079);
  EXPECT_EQ(terrain_follower.state().height_m, 0.0);
}

// A block is a slope of the pitch: uphill before and downhill behind it.
TEST(TerrainFollower, OverABlockItClimbsTipsAndComesDownAgain) {
  const World world(block_at_half_a_metre(), {});
  TerrainFollower terrain_follower(world, {});
  Pose pose{};
  double nose_up = 0.0, nose_down = 0.0, highest = 0.0;
  const double distance_m = drive(terrain_follower, pose, 1.0, [&](const ContactState& on) {
    ASSERT_EQ(on.incline.slope_rad, -on.pitch_rad) << pose.x_m;
    if (!on.climbing) return;
    highest = std::max(highest, on.height_m);
    nose_up = std::max(nose_up, -on.pitch_rad);
    nose_down = std::max(nose_down, on.pitch_rad);
  });
  EXPECT_NEAR(nose_up * kDegPerRad, 45.0, 4.0);
  EXPECT_GT(nose_down, 15 * kRadPerDeg);
  EXPECT_GT(highest, 0.036);
  EXPECT_EQ(terrain_follower.state().height_m, 0.0);
  EXPECT_FALSE(terrain_follower.state().climbing);
  EXPECT_EQ(terrain_follower.state().pitch_rad, 0.0);
  EXPECT_GT(distance_m, 1.02);
  EXPECT_LT(distance_m, 1.12);
}

/// Drives along x, forward or back, until `x_m`.
void drive_to(TerrainFollower& terrain_follower, Pose& pose, double x_m) {
  const double distance_m = x_m > pose.x_m ? kDistanceM : -kDistanceM;
  for (int i = 0; i < 10'000 && (x_m - pose.x_m) * distance_m > 0.0; ++i)
    pose.x_m +=
        distance_m * terrain_follower.advance(pose, distance_m, kStepS).incline.horizontal_fraction;
}

void expect_climbed_again_only_from_far_away(double height_m, double touch_m) {
  course::Terrain terrain = block_at_half_a_metre();
  std::get<course::Block>(terrain.obstacles[0]).height_m = height_m;
  const World world(terrain, {});
  TerrainFollower terrain_follower(world, {});
  Pose pose{};
  drive_to(terrain_follower, pose, touch_m + 0.005);
  EXPECT_TRUE(terrain_follower.state().climbing);
  for (int i = 0; i < 1000 && terrain_follower.state().climbing; ++i)
    drive_to(terrain_follower, pose, pose.x_m + 1e-6);
  EXPECT_GT(pose.x_m, 0.6);
  drive_to(terrain_follower, pose, touch_m + 0.04);
  EXPECT_FALSE(terrain_follower.state().climbing) << "back onto the block";
  drive_to(terrain_follower, pose, touch_m - 0.02);
  drive_to(terrain_follower, pose, touch_m + 0.005);
  EXPECT_FALSE(terrain_follower.state().climbing) << "the block is the one that was left last";
  drive_to(terrain_follower, pose, 0.1);
  drive_to(terrain_follower, pose, touch_m + 0.005);
  EXPECT_TRUE(terrain_follower.state().climbing);
  drive_to(terrain_follower, pose, touch_m - 0.02);
  EXPECT_FALSE(terrain_follower.state().climbing) << "backed off";
  EXPECT_EQ(terrain_follower.state().pitch_rad, 0.0);
  drive_to(terrain_follower, pose, touch_m + 0.005);
  EXPECT_TRUE(terrain_follower.state().climbing);
}

TEST(TerrainFollower, ABlockThatWasClimbedIsClimbedAgainOnlyAfterItWasFarAway) {
  expect_climbed_again_only_from_far_away(0.015, 0.45 - 0.133 / 2.0 - 0.0236);
  expect_climbed_again_only_from_far_away(0.037, 0.45 - 0.133 / 2.0 - 0.026);
}

TEST(TerrainFollower, ARestartEndsAClimbAndForgetsTheBlockBehind) {
  const World world(block_at_half_a_metre(), {});
  TerrainFollower terrain_follower(world, {});
  Pose pose{};
  drive_to(terrain_follower, pose, kTouchM + 0.02);
  ASSERT_TRUE(terrain_follower.state().climbing);
  terrain_follower.restart();
  EXPECT_FALSE(terrain_follower.state().climbing);
  EXPECT_EQ(terrain_follower.state().pitch_rad, 0.0);
  terrain_follower.advance({}, kDistanceM, kStepS);
  EXPECT_FALSE(terrain_follower.state().climbing);
  drive_to(terrain_follower, pose, 0.7);
  terrain_follower.restart();
  terrain_follower.advance({.x_m = kTouchM + 0.01}, kDistanceM, kStepS);
  EXPECT_TRUE(terrain_follower.state().climbing);
}

TEST(TerrainFollower, ARealBodyClimbsWhenItsNoseRisesNotWhereTheMapHasTheBlock) {
  const World world(block_at_half_a_metre(), {});
  TerrainFollower terrain_follower(world, {});
  Pose pose{.x_m = kTouchM + 0.03};
  terrain_follower.advance(pose, kDistanceM, kStepS, Attitude{});
  EXPECT_FALSE(terrain_follower.state().climbing);
  terrain_follower.advance(pose, kDistanceM, kStepS, Attitude{.pitch_rad = -4 * kRadPerDeg});
  EXPECT_TRUE(terrain_follower.state().climbing);
  // Until the climb was detected, the pose moved ahead while the robot moved up.
  EXPECT_LT(terrain_follower.state().incline.horizontal_fraction * kDistanceM, -0.005);
}

/// Whether a robot that is set down `past_m` beyond the place where it touches the block, turned by
/// `askew_deg`, begins to climb.
bool begins(double past_m, double askew_deg, std::optional<Attitude> measured) {
  const World world(block_at_half_a_metre(), {});
  TerrainFollower follower(world, {});
  const double yaw = askew_deg * kRadPerDeg;
  // Along its heading, the block begins as far ahead as if it went straight at it.
  const double ahead_m = 0.133 / 2.0 + 0.026 - past_m;
  follower.advance({.x_m = 0.45 - ahead_m * std::cos(yaw),
                    .y_m = -ahead_m * std::sin(yaw),
                    .yaw_rad = yaw + 2.0 * kPi},
                   kDistanceM, kStepS, measured);
  return follower.state().climbing;
}

TEST(TerrainFollower, AClimbBeginsNearABlockThatIsMetSquarelyOnceTheNoseRises) {
  const Attitude up{.roll_rad = 0.01, .pitch_rad = -0.11};
  EXPECT_FALSE(begins(-0.001, 0.0, {})) << "by the map not before it touches";
  EXPECT_TRUE(begins(0.001, 0.0, {}));
  EXPECT_TRUE(begins(0.079, 0.0, {}));
  EXPECT_FALSE(begins(0.081, 0.0, {}));
  EXPECT_TRUE(begins(-0.079, 0.0, up)) << "a pose may be wrong by that";
  EXPECT_FALSE(begins(-0.081, 0.0, up));
  for (const double side : {1.0, -1.0}) {
    EXPECT_TRUE(begins(0.005, side * 29.0, up));
    EXPECT_FALSE(begins(0.005, side * 31.0, up));
    EXPECT_FALSE(begins(0.005, side * 179.0, up)) << "the block is behind";
  }
  EXPECT_TRUE(begins(0.005, 0.0, Attitude{.pitch_rad = -3.1 * kRadPerDeg}));
  EXPECT_FALSE(begins(0.005, 0.0, Attitude{.pitch_rad = -2.9 * kRadPerDeg}));
  EXPECT_FALSE(begins(0.005, 0.0, Attitude{.pitch_rad = 3.1 * kRadPerDeg}));
}

TEST(TerrainFollower, AMeasuredAttitudeAwayFromBlocksIsASlopeUnlessItIsNoise) {
  const World world(block_at_half_a_metre(), {});
  TerrainFollower follower(world, {});
  for (const double roll_deg : {1.9, -1.9, 2.1, -2.1}) {
    for (const double pitch_deg : {1.9, -1.9, 2.1, -2.1, -10.0}) {
      const bool noise = std::abs(roll_deg) < 2.0 && std::abs(pitch_deg) < 2.0;
      const double pitch = noise ? 0.0 : pitch_deg * kRadPerDeg;
      follower.advance({.x_m = -0.3}, kDistanceM, kStepS,
                       Attitude{roll_deg * kRadPerDeg, pitch_deg * kRadPerDeg});
      EXPECT_FALSE(follower.state().climbing);
      EXPECT_EQ(follower.state().pitch_rad, pitch);
      EXPECT_EQ(follower.state().roll_rad, noise ? 0.0 : roll_deg * kRadPerDeg);
      EXPECT_EQ(follower.state().incline.slope_rad, -pitch);
      EXPECT_NEAR(follower.state().incline.horizontal_fraction, std::cos(pitch), 1e-12);
    }
  }
}

// A body that falls moves ahead without any travel; a bound keeps its fraction finite.
TEST(TerrainFollower, AFallAlmostWithoutTravelStaysBounded) {
  const World world(block_at_half_a_metre(), {});
  for (const double distance_m : {0.0, 9e-7, -9e-7, 2e-6, -2e-6}) {
    TerrainFollower follower(world, {});
    Pose pose{};
    double before = 0.0;
    while (before > -0.3 || follower.state().pitch_rad <= before) {
      before = follower.state().pitch_rad;
      drive_to(follower, pose, pose.x_m + 1e-6);
      ASSERT_LT(pose.x_m, 0.6);
    }
    double most = 0.0;
    for (int i = 0; i < 80; ++i) {
      const double fraction =
          follower.advance(pose, distance_m, kStepS).incline.horizontal_fraction;
      most = std::max(most, std::abs(fraction - 1.0));
      ASSERT_LE(std::abs(fraction), 30.0);
    }
    EXPECT_GT(follower.state().pitch_rad, before + 0.1) << "it fell";
    EXPECT_EQ(most > 0.0, std::abs(distance_m) > 1e-6) << distance_m;
  }
}

TEST(TerrainFollower, SurfacesAddTheirSlip) {
  course::Terrain terrain;
  terrain.surfaces.push_back({"felt", {0.0, 0.0, 0.0}, 1.0, 1.0, 1.0, 0.07});
  const World world(terrain, {});
  TerrainFollower terrain_follower(world, {});
  EXPECT_EQ(terrain_follower.advance({}, kDistanceM, kStepS).incline.slip_offset, 0.07);
  EXPECT_EQ(terrain_follower.advance({.x_m = 2.0}, kDistanceM, kStepS).incline.slip_offset, 0.0);
}

}  // namespace
}  // namespace tp100::terrain
