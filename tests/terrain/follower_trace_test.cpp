#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/arithmetic.h"
#include "support/golden_trace.h"
#include "terrain/terrain_follower.h"

namespace tp100::terrain {
namespace {

using test::GoldenTrace;

constexpr course::ShapeValues kShape{.length_m = 0.2,
                                     .height_m = 0.07,
                                     .axle_spacing_m = 0.141,
                                     .wheel_radius_m = 0.028,
                                     .gauge_m = 0.163,
                                     .com_height_m = 0.021,
                                     .com_forward_m = 0.006};

/// A ramp, two blocks and one that is too high to climb, along x.
course::Terrain course_of_obstacles() {
  course::Terrain terrain;
  terrain.ramps.push_back({{0.5, 0.0, 0.0}, 0.07, 0.45, 0.12, 0.36, 0.5});
  terrain.blocks.push_back({{1.3, 0.02, 0.0}, 0.035, 0.1, 0.5});
  terrain.blocks.push_back({{2.1, -0.02, kPi}, 0.022, 0.25, 0.6});
  terrain.blocks.push_back({{3.0, 0.0, 0.0}, 0.08, 0.2, 0.6});
  terrain.surfaces.push_back({"felt", {0.5, 0.0, 0.0}, 0.3, 1.0, 0.9, 0.07});
  return terrain;
}

const std::vector<std::string> kColumns = {"x_m",      "slope_rad", "slip_offset",
                                           "fraction", "height_m",  "pitch_rad",
                                           "roll_rad", "obstacle",  "climbing"};

void add(GoldenTrace& trace, const Pose& pose, const ContactState& on) {
  trace.row({pose.x_m, on.incline.slope_rad, on.incline.slip_offset, on.incline.horizontal_fraction,
             on.height_m, on.pitch_rad, on.roll_rad, static_cast<double>(on.obstacle),
             on.climbing ? 1.0 : 0.0});
}

/// Drives along the pose's heading and records every n-th interval.
void drive(GoldenTrace& trace, TerrainFollower& follower, Pose& pose, int steps, int every,
           const std::function<double(int)>& distance_m, double dt_s = 0.005,
           const std::function<std::optional<Attitude>(int)>& measured = nullptr) {
  for (int i = 0; i < steps; ++i) {
    const double distance = distance_m(i);
    const ContactState& on =
        follower.advance(pose, distance, dt_s, measured ? measured(i) : std::nullopt);
    pose.x_m += distance * on.incline.horizontal_fraction * std::cos(pose.yaw_rad);
    pose.y_m += distance * on.incline.horizontal_fraction * std::sin(pose.yaw_rad);
    if (i % every == 0) add(trace, pose, on);
  }
}

TEST(GoldenTrace, OfAFollowerByTheMap) {
  GoldenTrace trace("terrain/follower.csv", kColumns);
  const World world(course_of_obstacles(), kShape);
  TerrainFollower follower(world, kShape);
  const auto forth = [](int i) { return 6e-4 * (1.0 + 0.5 * std::sin(0.05 * i)); };
  const auto back = [](int) { return -7e-4; };
  Pose pose{.x_m = 0.02, .y_m = 0.01};
  add(trace, pose, follower.state());
  drive(trace, follower, pose, 2200, 24, forth);
  // Back onto the block and off again in front of it.
  drive(trace, follower, pose, 900, 24, back);
  follower.restart();
  add(trace, pose, follower.state());
  pose = {.x_m = 1.05, .y_m = 0.03, .yaw_rad = 0.1};
  drive(trace, follower, pose, 150, 6, forth);
  drive(trace, follower, pose, 150, 6, back);
  drive(trace, follower, pose, 700, 24, forth);
  // Back onto the block that was left, before and after it was out of reach.
  drive(trace, follower, pose, 300, 12, back);
  drive(trace, follower, pose, 1000, 40, forth);
  drive(trace, follower, pose, 500, 12, back);
  drive(trace, follower, pose, 2400, 30, forth);
  // The other way.
  pose = {.x_m = 2.6, .y_m = 0.04, .yaw_rad = kPi - 0.06};
  follower.restart();
  drive(trace, follower, pose, 2600, 24, forth);
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfAFollowerThatFallsAlmostWithoutTravel) {
  GoldenTrace trace("terrain/follower_fall.csv", kColumns);
  const World world(course_of_obstacles(), kShape);
  for (const double distance_m : {0.0, 6e-7, -1.3e-6, 2.4e-6, 4e-5, -4e-5, 3e-4}) {
    TerrainFollower follower(world, kShape);
    Pose pose{.x_m = 1.1};
    // Up to where the fall has begun.
    for (double rise = 0.0; rise <= 0.0 && pose.x_m < 1.6;) {
      const double until_now = follower.state().pitch_rad;
      const ContactState& on = follower.advance(pose, 5e-4, 0.005);
      pose.x_m += 5e-4 * on.incline.horizontal_fraction;
      rise = on.pitch_rad < -0.3 ? on.pitch_rad - until_now : 0.0;
    }
    drive(
        trace, follower, pose, 40, 2, [&](int) { return distance_m; }, 0.006);
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfAFollowerOfARealBody) {
  GoldenTrace trace("terrain/follower_real.csv", kColumns);
  const World world(course_of_obstacles(), kShape);
  TerrainFollower follower(world, kShape);
  Pose pose{.x_m = 0.1, .y_m = -0.01, .yaw_rad = -0.03};
  // A pitch and a roll that are partly terrain, partly noise, with the nose up at the blocks.
  drive(
      trace, follower, pose, 2300, 12, [](int) { return 1e-3; }, 0.01,
      [&](int i) -> std::optional<Attitude> {
        const double pitch = pose.x_m > 1.19 && pose.x_m < 1.28 ? -0.2 : 0.05 * std::sin(0.03 * i);
        return Attitude{.roll_rad = 0.06 * std::sin(0.017 * i), .pitch_rad = pitch};
      });
  EXPECT_EQ(trace.difference(), "");
}

// A robot is set down near a block with some pose and attitude; its first interval tells whether a
// climb begins.
TEST(GoldenTrace, OfWhereAClimbBegins) {
  std::vector<std::string> columns = kColumns;
  columns.front() = "varied";
  GoldenTrace trace("terrain/climb_begins.csv", columns);
  const World world(course_of_obstacles(), kShape);
  const auto row = [&](double varied, const Pose& pose, std::optional<Attitude> measured) {
    TerrainFollower follower(world, kShape);
    add(trace, {.x_m = varied}, follower.advance(pose, 7e-4, 0.005, measured));
    add(trace, {.x_m = varied}, follower.advance(pose, 6e-4, 0.005, measured));
  };
  const Attitude nose_up{.roll_rad = 0.01, .pitch_rad = -0.11};
  const double touch_m = 1.25 - kShape.axle_spacing_m / 2.0 - kShape.wheel_radius_m;
  for (double askew = -0.75; askew < 0.8; askew += 0.047)
    row(askew, {.x_m = touch_m + 0.01, .yaw_rad = askew}, nose_up);
  for (double past = -0.105; past < 0.11; past += 0.0043) {
    row(past, {.x_m = touch_m + past}, nose_up);
    row(past, {.x_m = touch_m + past}, std::nullopt);
  }
  for (double pitch = -0.9; pitch < -0.2; pitch += 0.06)
    row(pitch, {.x_m = touch_m + 0.01}, Attitude{.roll_rad = 0.02, .pitch_rad = pitch});
  for (double pitch = -0.4; pitch < -0.1; pitch += 0.05)
    row(pitch, {.x_m = 2.31, .y_m = 0.01, .yaw_rad = kPi}, Attitude{.pitch_rad = pitch});
  for (double pitch = -0.1; pitch < 0.08; pitch += 0.0037)
    row(pitch, {.x_m = touch_m + 0.01}, Attitude{.roll_rad = 0.02, .pitch_rad = pitch});
  for (double roll = -0.08; roll < 0.08; roll += 0.0041)
    row(roll, {.x_m = -0.5}, Attitude{.roll_rad = roll, .pitch_rad = 0.02});
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::terrain
