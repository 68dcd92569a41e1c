#include "terrain/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/arithmetic.h"

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
  EXPECT_EQ(half_on.obstacle, ObstacleClass::kRamp);
}

TEST(World, ALongRampCarriesTheRobotFarFromItsMiddle) {
  course::Terrain terrain = one_ramp();
  terrain.ramps[0].top_m = 4.0;
  const World world(terrain, {});
  for (const double x : {-1.8, -1.2, 0.3, 1.7})
    EXPECT_NEAR(world.at(heading_back(0.7 + x)).height_m, 0.2, 1e-6) << x;
}

TEST(World, ManyPiecesAtOnePlaceCarryTheRobotAsOne) {
  course::Terrain terrain = one_block();
  for (int i = 0; i < 11; ++i) terrain.blocks.push_back(terrain.blocks[0]);
  const World world(terrain, {});
  EXPECT_NEAR(world.at(heading_back(1.2)).height_m, 0.037, 1e-6);
  EXPECT_EQ(world.at(heading_back(1.2)).obstacle, ObstacleClass::kBlock);
  EXPECT_EQ(world.height_m(1.2, -0.9), 0.037);
  EXPECT_EQ(world.height_m(1.4, -0.8), 0.0);
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

TEST(World, AnswersEveryPoseWithinBounds) {
  course::Terrain terrain = one_ramp();
  terrain.blocks = one_block().blocks;
  const World world(terrain, {});
  for (double x = -0.2; x < 2.0; x += 0.017) {
    for (double y = -1.2; y < 0.0; y += 0.031) {
      const ContactPose on = world.at({.x_m = x, .y_m = y, .yaw_rad = 7.0 * x + 5.0 * y});
      ASSERT_LT(std::abs(on.slope_rad), 70 * kRadPerDeg) << x << ' ' << y;
      ASSERT_TRUE(on.height_m > -0.05 && on.height_m < 0.30) << x << ' ' << y;
    }
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  world.at({.x_m = nan, .y_m = nan, .yaw_rad = nan});
  world.at({.x_m = 0.7, .y_m = -0.8, .yaw_rad = nan});
}

constexpr std::size_t kPlaces = SupportLine::kPlaces;

double highest_of_all(const WheelHeights& wheel, double com) {
  const auto before =
      static_cast<std::size_t>(std::clamp(std::floor(com), 0.0, static_cast<double>(kPlaces - 2)));
  double highest = -1e9;
  for (std::size_t i = 0; i <= before; ++i) {
    for (std::size_t j = before + 1; j < kPlaces; ++j) {
      const double rise = (wheel[j] - wheel[i]) / static_cast<double>(j - i);
      highest = std::max(highest, wheel[i] + rise * (com - static_cast<double>(i)));
    }
  }
  return highest;
}

TEST(SupportLine, NoOtherLineIsHigher) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> height(0.02, 0.12);
  std::uniform_real_distribution<double> place(-3.0, 43.0);
  for (int i = 0; i < 20'000; ++i) {
    WheelHeights wheel{};
    wheel.fill(0.03);
    // The ground ranges from a few peaks to a rough surface.
    for (int n = 0; n < 1 + i % 40; ++n) wheel[random() % kPlaces] = height(random);
    // The centre of mass may also lie exactly at a place or next to one.
    double com = place(random);
    if (i % 3 == 1) com = std::round(com);
    if (i % 3 == 2) com = std::nextafter(std::round(com), -1.0);
    const SupportLine line = support_line(wheel, com);
    ASSERT_NEAR(line.height, highest_of_all(wheel, com), 1e-9) << i << " com " << com;
    ASSERT_LT(line.before, line.after);
    ASSERT_DOUBLE_EQ(line.rise, (wheel[line.after] - wheel[line.before]) /
                                    static_cast<double>(line.after - line.before));
  }
}

}  // namespace
}  // namespace tp100::terrain
