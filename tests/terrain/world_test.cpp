#include "terrain/world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/arithmetic.h"
#include "support/alloc_count.h"

namespace tp100::terrain {
namespace {

constexpr double kUpRad = 28 * kRadPerDeg;

course::Terrain one_ramp() {
  course::Ramp ramp{};
  ramp.place = {0.7, -0.8, kPi};
  ramp.height_m = 0.20;
  ramp.up_rad = ramp.down_rad = kUpRad;
  ramp.top_m = 0.3;
  ramp.width_m = 0.4;
  course::Terrain terrain;
  terrain.ramps.push_back(ramp);
  return terrain;
}

course::Terrain one_block() {
  course::Block block{};
  block.place = {1.2, -0.8, kPi};
  block.height_m = 0.037;
  block.depth_m = 0.3;
  block.width_m = 0.4;
  course::Terrain terrain;
  terrain.blocks.push_back(block);
  return terrain;
}

Pose heading_back(double x_m, double y_m = -0.8) {
  return {.x_m = x_m, .y_m = y_m, .yaw_rad = kPi};
}

TEST(World, IsLevelWhereNothingStands) {
  const World empty({}, {});
  EXPECT_TRUE(empty.flat());
  EXPECT_EQ(empty.at({.x_m = 1.0}).slope_rad, 0.0);
  const World world(one_ramp(), {});
  const ContactPose contact_pose = world.at({.x_m = 0.5});
  EXPECT_EQ(contact_pose.height_m, 0.0);
  EXPECT_EQ(contact_pose.pitch_rad, 0.0);
  EXPECT_EQ(contact_pose.roll_rad, 0.0);
  EXPECT_EQ(contact_pose.obstacle, ObstacleClass::kNone);
  EXPECT_EQ(contact_pose.surface, nullptr);
}

TEST(World, OnARampTheRobotLiesOnItsSlope) {
  const course::Terrain terrain = one_ramp();
  const World world(terrain, {});
  const double foot = 0.7 + terrain.ramps[0].length_m() / 2.0;
  const ContactPose up = world.at(heading_back(foot - 0.2));
  EXPECT_NEAR(up.slope_rad, kUpRad, 1e-3);
  EXPECT_NEAR(up.pitch_rad, -kUpRad, 1e-3) << "nose-up is negative pitch";
  EXPECT_NEAR(up.height_m, 0.2 * std::tan(kUpRad), 5e-4);
  EXPECT_NEAR(up.roll_rad, 0.0, 1e-9);
  EXPECT_EQ(up.obstacle, ObstacleClass::kRamp);
  const ContactPose top = world.at(heading_back(0.7));
  EXPECT_NEAR(top.slope_rad, 0.0, 1e-6);
  EXPECT_NEAR(top.height_m, 0.20, 1e-6);
  const ContactPose down = world.at(heading_back(2 * 0.7 - foot + 0.2));
  EXPECT_NEAR(down.slope_rad, -kUpRad, 1e-3);
}

TEST(World, OverACrestItKeepsThePitchThatItHasUntilItsMassIsPastTheEdge) {
  const course::Terrain terrain = one_ramp();
  const World world(terrain, {});
  const double crest = 0.7 + terrain.ramps[0].top_m / 2.0;
  Pose pose = heading_back(crest - 0.006);
  EXPECT_NEAR(world.at(pose).slope_rad, 0.0, 1e-3) << "the robot came from the top";
  pose.pitch_rad = -kUpRad;
  EXPECT_NEAR(world.at(pose).slope_rad, kUpRad, 1e-3) << "the robot came from below";
  pose.x_m = crest - 0.013;
  EXPECT_NEAR(world.at(pose).slope_rad, 0.0, 1e-3);
}

TEST(World, BesideARampTheRobotIsOnTheFloor) {
  const World world(one_ramp(), {});
  EXPECT_EQ(world.at(heading_back(0.7, -0.8 + 0.35)).height_m, 0.0);
  const ContactPose half_on = world.at(heading_back(0.7, -0.8 + 0.2));
  EXPECT_NEAR(std::abs(half_on.roll_rad), std::atan2(0.20, 0.155), 1e-6);
  EXPECT_GT(half_on.roll_rad, 0.0) << "its left track is on the ramp";
}

TEST(World, ALongRampCarriesTheRobotFarFromItsMiddle) {
  course::Terrain terrain = one_ramp();
  terrain.ramps[0].top_m = 4.0;
  const World world(terrain, {});
  for (const double x : {-1.8, -1.2, 0.3, 1.7}) {
    EXPECT_NEAR(world.at(heading_back(0.7 + x)).height_m, 0.2, 1e-6) << x;
    EXPECT_EQ(world.at(heading_back(0.7 + x)).obstacle, ObstacleClass::kRamp) << x;
  }
}

TEST(World, ManyPiecesAtOnePlaceCarryTheRobotAsOne) {
  course::Terrain terrain = one_block();
  for (int i = 0; i < 11; ++i) terrain.blocks.push_back(terrain.blocks[0]);
  EXPECT_NEAR(World(terrain, {}).at(heading_back(1.2)).height_m, 0.037, 1e-6);
}

TEST(World, OnABlockTheRobotStandsLevelAtItsHeight) {
  const World world(one_block(), {});
  const ContactPose contact_pose = world.at(heading_back(1.2));
  EXPECT_NEAR(contact_pose.height_m, 0.037, 1e-6);
  EXPECT_NEAR(contact_pose.slope_rad, 0.0, 1e-6);
  EXPECT_EQ(contact_pose.obstacle, ObstacleClass::kBlock);
  const ContactPose climbing = world.at(heading_back(1.2 + 0.15 + 0.03));
  EXPECT_GT(climbing.slope_rad, 15 * kRadPerDeg);
  EXPECT_EQ(climbing.obstacle, ObstacleClass::kBlock);
}

TEST(World, ARobotThatIsDrivenObliquelyOverABlockDoesNotTipBackAndForth) {
  const World world(one_block(), {});
  for (const double yaw_deg : {10.0, 25.0, 40.0, 55.0, 70.0}) {
    const double c = std::cos(yaw_deg * kRadPerDeg), s = std::sin(yaw_deg * kRadPerDeg);
    double pitch_rad = 0.0, jump_before_rad = 0.0;
    for (int i = -10000; i <= 10000; ++i) {
      const double along_m = i * 1e-4;
      const Pose pose{.x_m = 1.2 + along_m * c,
                      .y_m = -0.8 + along_m * s,
                      .pitch_rad = pitch_rad,
                      .yaw_rad = yaw_deg * kRadPerDeg};
      const double jump_rad = world.at(pose).pitch_rad - pitch_rad;
      EXPECT_FALSE(std::abs(jump_rad) > 0.005 && std::abs(jump_before_rad) > 0.005 &&
                   jump_rad * jump_before_rad < 0.0)
          << yaw_deg << " deg, " << along_m << " m: " << jump_rad << " after " << jump_before_rad;
      pitch_rad += jump_rad;
      jump_before_rad = jump_rad;
    }
  }
}

TEST(World, HeightIsThatOfThePieceUnderThePoint) {
  const World ramp(one_ramp(), {});
  EXPECT_NEAR(ramp.height_m(0.7, -0.8), 0.20, 1e-12);
  EXPECT_EQ(ramp.height_m(0.7, -0.5), 0.0);
  const World block(one_block(), {});
  EXPECT_NEAR(block.height_m(1.2, -0.9), 0.037, 1e-12);
  EXPECT_EQ(block.height_m(1.4, -0.8), 0.0);
  EXPECT_EQ(block.next_block(heading_back(1.6), 1.0)->block->height_m, 0.037);
}

TEST(World, SaysTheSurfaceUnderTheReferencePoint) {
  course::Terrain terrain;
  terrain.surfaces.push_back({.name = "mat",
                              .place = {0.5, 0.0, 0.0},
                              .length_m = 0.2,
                              .width_m = 0.2,
                              .friction_factor = 1.0,
                              .slip_offset = 0.05});
  const World world(terrain, {});
  ASSERT_NE(world.at({.x_m = 0.45}).surface, nullptr);
  EXPECT_EQ(world.at({.x_m = 0.45}).surface->name, "mat");
  EXPECT_EQ(world.at({.x_m = 0.75}).surface, nullptr);
}

TEST(World, AnswersEveryPoseWithinBoundsAndWithoutHeap) {
  course::Terrain terrain = one_ramp();
  terrain.blocks = one_block().blocks;
  const World world(terrain, {});
  const test::AllocCount heap;
  for (double x = -0.2; x < 2.0; x += 0.017) {
    for (double y = -1.2; y < 0.0; y += 0.031) {
      for (double yaw = -4.0; yaw < 4.0; yaw += 0.61) {
        const ContactPose contact_pose = world.at({.x_m = x, .y_m = y, .yaw_rad = yaw});
        ASSERT_TRUE(std::abs(contact_pose.slope_rad) < 70 * kRadPerDeg)
            << x << " " << y << " " << yaw;
        ASSERT_TRUE(contact_pose.height_m > -0.05 && contact_pose.height_m < 0.30);
        world.next_block({.x_m = x, .y_m = y, .yaw_rad = yaw}, 0.5);
      }
    }
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  world.at({.x_m = nan, .y_m = nan, .yaw_rad = nan});
  world.at({.x_m = 0.7, .y_m = -0.8, .yaw_rad = nan});
  EXPECT_EQ(heap.calls(), 0u);
}

}  // namespace
}  // namespace tp100::terrain
