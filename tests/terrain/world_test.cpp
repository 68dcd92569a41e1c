// Cuts through ramps and blocks, and what a world makes of them, against the pieces' own shape.

#include "terrain/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/arithmetic.h"
#include "course/course.h"
#include "support/sequence.h"

namespace tp100::terrain {
namespace {

const course::Ramp kRamp{{0.7, -0.4, 0.3}, 0.09, 0.42, 0.17, 0.31, 0.47};
const course::Ramp kPeak{{-0.6, 0.2, -2.4}, 0.06, 0.5, 0.0, 0.35, 0.52};
const course::Block kBlock{{1.9, 0.1, 0.3}, 0.037, 0.31, 0.45};

/// A place in the frame of a piece.
struct Local {
  double along_m, left_m;
};
Local local(const course::Place& place, double x_m, double y_m) {
  const double c = std::cos(place.heading_rad), s = std::sin(place.heading_rad);
  const double dx = x_m - place.x_m, dy = y_m - place.y_m;
  return {c * dx + s * dy, c * dy - s * dx};
}
/// Height of a ramp: its up side, its top or its down side, whichever is lowest.
double height_of(const course::Ramp& ramp, double x_m, double y_m) {
  const auto [along_m, left_m] = local(ramp.place, x_m, y_m);
  if (std::abs(left_m) > ramp.width_m / 2.0) return 0.0;
  const double half_m = ramp.length_m() / 2.0;
  return std::max(0.0, std::min({(along_m + half_m) * std::tan(ramp.up_rad), ramp.height_m,
                                 (half_m - along_m) * std::tan(ramp.down_rad)}));
}
double height_of(const course::Block& block, double x_m, double y_m) {
  const auto [along_m, left_m] = local(block.place, x_m, y_m);
  const bool inside =
      std::abs(along_m) <= block.depth_m / 2.0 && std::abs(left_m) <= block.width_m / 2.0;
  return inside ? block.height_m : 0.0;
}

/// Cuts in many directions: calls check(profile, height of the piece at a distance).
template <class Piece, class Check>
void for_many_cuts(const Piece& piece, Check check) {
  const Outline outline = outlines_of({.obstacles = {piece}, .surfaces = {}}).front();
  test::Sequence any(9);
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const double yaw =
        i % 4 == 0 ? piece.place.heading_rad + i / 4 * kPi / 2.0 : any.between(-4.0, 4.0);
    const double x = piece.place.x_m + any.between(-0.5, 0.5);
    const double y = piece.place.y_m + any.between(-0.5, 0.5);
    const double c = std::cos(yaw), s = std::sin(yaw);
    check(Profile(outline, x, y, c, s),
          [&](double at_m) { return height_of(piece, x + at_m * c, y + at_m * s); });
    if (testing::Test::HasFailure()) return;
  }
}

template <class Piece>
void expect_heights_and_ends(const Piece& piece) {
  for_many_cuts(piece, [](const Profile& profile, const auto& height_at) {
    double begin_m = 9.0, end_m = -9.0;
    for (double at_m = -1.5; at_m < 1.5; at_m += 0.0037) {
      const double height_m = height_at(at_m);
      if (height_m > 0.0) {
        begin_m = std::min(begin_m, at_m);
        end_m = std::max(end_m, at_m);
      }
      // Within rounding of a wall either height may be meant.
      if (std::abs(height_at(at_m - 1e-6) - height_at(at_m + 1e-6)) < 1e-5) {
        ASSERT_NEAR(profile.height_m(at_m), height_m, 1e-9) << at_m;
      }
    }
    if (begin_m > end_m) return;
    ASSERT_FALSE(profile.empty());
    EXPECT_NEAR(profile.begin_m(), begin_m - 0.0037 / 2.0, 0.0038 / 2.0);
    EXPECT_NEAR(profile.end_m(), end_m + 0.0037 / 2.0, 0.0038 / 2.0);
  });
}

TEST(Profile, IsTheHeightOfThePieceAlongTheCut) {
  expect_heights_and_ends(kRamp);
  expect_heights_and_ends(kPeak);
  expect_heights_and_ends(kBlock);
}

constexpr course::ShapeValues kLopsided{.length_m = 0.2,
                                        .height_m = 0.07,
                                        .axle_spacing_m = 0.141,
                                        .wheel_radius_m = 0.028,
                                        .gauge_m = 0.163,
                                        .com_height_m = 0.025,
                                        .com_forward_m = 0.007};

/// A robot that crosses a ramp along its heading, `along_m` from its middle.
Pose crossing(const course::Ramp& ramp, double along_m, bool back, double pitch_rad) {
  const double c = std::cos(ramp.place.heading_rad), s = std::sin(ramp.place.heading_rad);
  return {.x_m = ramp.place.x_m + c * along_m,
          .y_m = ramp.place.y_m + s * along_m,
          .pitch_rad = pitch_rad,
          .yaw_rad = ramp.place.heading_rad + (back ? kPi : 0.0)};
}

// The underside of a track is the hull of its wheels. It rests on the ground on both sides of the
// centre of mass and enters it nowhere.
TEST(World, ATrackRestsOnTheGroundOnBothSidesOfItsMass) {
  course::Terrain terrain;
  terrain.obstacles = {kRamp, kPeak};
  const World world(terrain, kLopsided);
  for (const course::Ramp& ramp : {kRamp, kPeak}) {
    for (const bool back : {false, true}) {
      double pitch_rad = 0.0;
      for (double t = -0.5; t < 0.5; t += 0.0091) {
        const Pose pose = crossing(ramp, back ? -t : t, back, pitch_rad);
        const ContactPose on = world.at(pose);
        pitch_rad = on.pitch_rad;
        SCOPED_TRACE(testing::Message() << t << " back " << back);
        ASSERT_NEAR(on.roll_rad, 0.0, 1e-9);
        ASSERT_EQ(on.slope_rad, -on.pitch_rad);
        const double c = std::cos(on.slope_rad), s = std::sin(on.slope_rad);
        const double r = kLopsided.wheel_radius_m;
        const double mass_m = kLopsided.com_forward_m * c - kLopsided.com_height_m * s;
        double least_m = 9.0, before_m = 9.0, beyond_m = 9.0;
        for (double flat = -0.5; flat <= 0.5001; flat += 0.025) {
          // Centre of a wheel of the track, ahead of and above the reference point.
          const double ahead = flat * kLopsided.axle_spacing_m * c - r * s;
          const double above = on.height_m + flat * kLopsided.axle_spacing_m * s + r * c;
          double room_m = 9.0;
          for (double angle = -1.2; angle <= 1.2; angle += 0.01) {
            const double at = (ahead + r * std::sin(angle)) * (back ? -1.0 : 1.0);
            const Pose place = crossing(ramp, (back ? -t : t) + at, false, 0.0);
            room_m = std::min(room_m,
                              above - r * std::cos(angle) - height_of(ramp, place.x_m, place.y_m));
          }
          least_m = std::min(least_m, room_m);
          const double touches = ahead + r * s;  // along the underside
          double& side = touches < mass_m ? before_m : beyond_m;
          side = std::min(side, room_m);
        }
        EXPECT_GT(least_m, -1.5e-3);
        EXPECT_LT(before_m, 1.5e-3);
        EXPECT_LT(beyond_m, 1.5e-3);
      }
    }
  }
}

TEST(World, IsTheSameWhereverItsPiecesLieAndMirrored) {
  test::Sequence any(12);
  course::Course here;
  here.terrain.obstacles = {kRamp, kPeak, kBlock,
                            course::Block{{-1.7, -0.6, 1.1}, 0.024, 0.11, 0.38}};
  const World world(here.terrain, kLopsided);
  const World mirrored(course::mirrored(here).terrain, kLopsided);
  for (int i = 0; i < 300; ++i) {
    const Transform2d move{any.between(-3.0, 3.0), any.between(-3.0, 3.0), any.between(-4.0, 4.0)};
    course::Terrain there = here.terrain;
    const auto moved = [&](course::Place& place) {
      const Pose at = move.of({.x_m = place.x_m, .y_m = place.y_m, .yaw_rad = place.heading_rad});
      place = {at.x_m, at.y_m, at.yaw_rad};
    };
    for (course::Obstacle& obstacle : there.obstacles)
      std::visit([&](auto& of) { moved(of.place); }, obstacle);
    const course::Place near = i % 3 == 0 ? kBlock.place : i % 3 == 1 ? kRamp.place : kPeak.place;
    const Pose pose{.x_m = near.x_m + any.between(-0.4, 0.4),
                    .y_m = near.y_m + any.between(-0.3, 0.3),
                    .pitch_rad = any.between(-0.3, 0.3),
                    .yaw_rad = any.between(-4.0, 4.0)};
    const Pose across{
        .x_m = pose.x_m, .y_m = -pose.y_m, .pitch_rad = pose.pitch_rad, .yaw_rad = -pose.yaw_rad};
    const ContactPose on = world.at(pose), image = mirrored.at(across);
    const ContactPose same = World(there, kLopsided).at(move.of(pose));
    for (const ContactPose& other : {same, image}) {
      EXPECT_NEAR(other.height_m, on.height_m, 1e-6) << i;
      EXPECT_NEAR(other.pitch_rad, on.pitch_rad, 1e-5) << i;
      EXPECT_EQ(other.obstacle, on.obstacle) << i;
    }
    EXPECT_NEAR(same.roll_rad, on.roll_rad, 1e-5) << i;
    EXPECT_NEAR(image.roll_rad, -on.roll_rad, 1e-5) << i;
  }
}

TEST(World, TheNextBlockIsTheFirstOnTheLineFromTheRearEnd) {
  const std::vector<course::Block> blocks = {
      kBlock, {{2.4, 0.2, 0.3}, 0.03, 0.2, 0.6}, {{1.5, 0.3, 1.0}, 0.02, 0.1, 0.3}};
  course::Terrain terrain;
  terrain.obstacles = {blocks[0], kRamp, blocks[1], blocks[2]};
  const World world(terrain, kLopsided);
  test::Sequence any(14);
  int found = 0;
  for (int i = 0; i < 400; ++i) {
    const Pose pose{.x_m = any.between(1.0, 2.8),
                    .y_m = any.between(-0.4, 0.6),
                    .yaw_rad = any.between(-4.0, 4.0)};
    const double c = std::cos(pose.yaw_rad), s = std::sin(pose.yaw_rad);
    const double rear_m = -kLopsided.axle_spacing_m / 2.0 - kLopsided.wheel_radius_m;
    // Where each block that is not wholly behind begins and ends on the line.
    double first_m = 9.0, depth_m = 0.0;
    for (const course::Block& block : blocks) {
      double begin_m = 9.0, end_m = -9.0;
      for (double at = -1.2; at < 1.2; at += 2e-4) {
        if (height_of(block, pose.x_m + at * c, pose.y_m + at * s) == 0.0) continue;
        begin_m = std::min(begin_m, at);
        end_m = at;
      }
      if (begin_m > end_m || end_m < rear_m || begin_m > 0.5 || begin_m > first_m) continue;
      first_m = begin_m;
      depth_m = end_m - begin_m;
    }
    const auto next = world.next_block(pose, 0.5);
    if (depth_m < 1e-3 || std::abs(first_m - 0.5) < 1e-3 ||
        std::abs(first_m + depth_m - rear_m) < 1e-3)
      continue;
    ASSERT_TRUE(next) << i;
    ASSERT_NEAR(next->distance_m, first_m, 3e-4) << i;
    ++found;
  }
  EXPECT_GT(found, 100);
}

constexpr double kUpRad = 28 * kRadPerDeg;

course::Terrain one_ramp() {
  course::Ramp ramp{};
  ramp.place = {0.7, -0.8, kPi};
  ramp.height_m = 0.20;
  ramp.up_rad = ramp.down_rad = kUpRad;
  ramp.top_m = 0.3;
  ramp.width_m = 0.4;
  course::Terrain terrain;
  terrain.obstacles.emplace_back(ramp);
  return terrain;
}

course::Terrain one_block() {
  course::Block block{};
  block.place = {1.2, -0.8, kPi};
  block.height_m = 0.037;
  block.depth_m = 0.3;
  block.width_m = 0.4;
  course::Terrain terrain;
  terrain.obstacles.emplace_back(block);
  return terrain;
}

Pose heading_back(double x_m, double y_m = -0.8) {
  return {.x_m = x_m, .y_m = y_m, .yaw_rad = kPi};
}

TEST(World, OverACrestItKeepsThePitchThatItHasUntilItsMassIsPastTheEdge) {
  const course::Terrain terrain = one_ramp();
  const World world(terrain, {});
  const double crest = 0.7 + std::get<course::Ramp>(terrain.obstacles[0]).top_m / 2.0;
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
  std::get<course::Ramp>(terrain.obstacles[0]).top_m = 4.0;
  const World world(terrain, {});
  for (const double x : {-1.8, -1.2, 0.3, 1.7})
    EXPECT_NEAR(world.at(heading_back(0.7 + x)).height_m, 0.2, 1e-6) << x;
}

TEST(World, ManyPiecesAtOnePlaceCarryTheRobotAsOne) {
  course::Terrain terrain = one_block();
  terrain.obstacles.resize(12, terrain.obstacles[0]);
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
  terrain.obstacles.push_back(one_block().obstacles[0]);
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

}  // namespace
}  // namespace tp100::terrain
