#include "course/goal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/arithmetic.h"
#include "course/course.h"
#include "course/path.h"
#include "support/refusal.h"

namespace tp100::course {
namespace {

using ::testing::HasSubstr;

/// Every table and key that a course file has, and a floor of 8 m x 8 m.
constexpr const char* kEverything = R"(description = "everything"
speed_mps = 0.125
identifies = true
start = { x_m = 1.0, yaw_deg = 30.0 }
segment = [{ type = "line", length_m = 1.0 }, { type = "pivot", angle_deg = 90.0 }]
[[disturbance]]
at_m = 0.5
sideways_m = 0.04
[[ramp]]
x_m = 3.0
y_m = 3.1
heading_deg = 12.3
height_m = 0.05
up_deg = 10.0
top_m = 0.1
down_deg = 12.0
width_m = 0.4
[[block]]
x_m = -3.0
y_m = 3.0
height_m = 0.01
depth_m = 0.1
width_m = 0.4
[[surface]]
name = "wet \"floor\""
x_m = 0.1
y_m = 0.2
length_m = 0.3
width_m = 0.4
slip_offset = 0.05
[fence]
corners_m = [[-4.0, -4.0], [4.0, -4.0], [4.0, 4.0], [-4.0, 4.0]]
[[keep_out]]
corners_m = [[3.0, -3.5], [3.5, -3.5], [3.25, -3.0]]
)";
constexpr const char* kFree =
    "[[segment]]\ntype = \"line\"\nlength_m = 0.3\n"
    "[fence]\nmin_x_m = -100\nmax_x_m = 100\nmin_y_m = -100\nmax_y_m = 100\n";

Course to(const char* course, const Pose& from, const Pose& goal) {
  const TextFile file = course_to({"c.toml", course}, {from, goal});
  return parse_course(file.text, file.path);
}

std::string why_not(const char* course, const Pose& from, const Pose& goal) {
  return test::refusal([&] { to(course, from, goal); });
}

struct Miss {
  double m, rad;
};
Miss miss(const Course& course, const Pose& goal) {
  const PathPoint end = Path(course).segments().back().end;
  return {magnitude(end.x_m - goal.x_m, end.y_m - goal.y_m),
          std::abs(wrap_angle(end.yaw_rad - goal.yaw_rad))};
}

TEST(GoalCourse, StartsAtThePoseAndEndsAtTheGoal) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-35.0, 35.0), yaw(-100.0, 100.0);
  for (int i = 0; i < 2'000; ++i) {
    const Pose from{.x_m = place(random), .y_m = place(random), .yaw_rad = yaw(random)};
    const Pose goal{.x_m = place(random), .y_m = place(random), .yaw_rad = yaw(random)};
    const Course course = to(kFree, from, goal);
    EXPECT_EQ(course.start.x_m, from.x_m);
    EXPECT_EQ(course.start.y_m, from.y_m);
    EXPECT_NEAR(wrap_angle(course.start.yaw_rad - from.yaw_rad), 0.0, 1e-12);
    const Miss by = miss(course, goal);
    // A turn that is too small for the course is left out: the yaw is off by that turn.
    const bool whole = course.path.size() == 3;
    const double off_rad = whole ? 1e-9 : 0.1 * kRadPerDeg;
    const double length_m = magnitude(goal.x_m - from.x_m, goal.y_m - from.y_m);
    EXPECT_LT(by.m, whole ? 1e-9 : off_rad * length_m) << i;
    EXPECT_LT(by.rad, off_rad) << i;
  }
}

TEST(GoalCourse, LeavesOutWhatNoCourseFileHas) {
  // On the spot, straight ahead, and hardly any motion.
  EXPECT_EQ(to(kFree, {}, {.x_m = 0.0009, .yaw_rad = 1.0}).path.size(), 1u);
  const Pose ahead{.x_m = 2.0, .y_m = 0.003, .yaw_rad = 0.001};
  const Course straight = to(kFree, {}, ahead);
  EXPECT_EQ(straight.path.size(), 1u);
  EXPECT_LT(miss(straight, ahead).m, 0.0031);
  EXPECT_LT(miss(straight, ahead).rad, 0.1 * kRadPerDeg);
  EXPECT_EQ(why_not(kFree, {.x_m = 1.0}, {.x_m = 1.0, .yaw_rad = 2 * kPi}),
            "the robot is there already");
}

TEST(GoalCourse, KeepsFloorAndSpeedOfTheCourseAndNothingElse) {
  const Course before = parse_course(kEverything, "c.toml");
  const Course after = to(kEverything, {.x_m = -1.0}, {.x_m = 1.0});
  EXPECT_EQ(after.name, "goal");
  EXPECT_EQ(after.description, "to (1.000, 0.000) m, 0.0 deg");
  EXPECT_EQ(after.speed_mps, 0.125);
  EXPECT_FALSE(after.identifies);
  EXPECT_TRUE(after.disturbances.empty());
  EXPECT_EQ(after.path.size(), 1u);
  EXPECT_EQ(after.terrain.ramps.at(0).place.heading_rad,
            before.terrain.ramps.at(0).place.heading_rad);
  EXPECT_EQ(after.terrain.blocks.size(), 1u);
  EXPECT_EQ(after.terrain.surfaces.at(0).name, "wet \"floor\"");
  EXPECT_EQ(after.fence.corners.size(), 4u);
  EXPECT_EQ(after.fence.keep_out.size(), 1u);
  // And again from its own output.
  const TextFile first = course_to({"c.toml", kEverything}, {{}, {.x_m = 1.0}});
  const TextFile second = course_to(first, {{.x_m = 1.0}, {.y_m = 1.0}});
  EXPECT_LT(miss(parse_course(second.text, second.path), {.y_m = 1.0}).m, 1e-9);
}

TEST(GoalCourse, OutsideOfTheFenceIsRefused) {
  // Through the keep-out area, and beside it.
  EXPECT_THAT(why_not(kEverything, {.x_m = 2.5, .y_m = -3.2}, {.x_m = 3.9, .y_m = -3.2}),
              HasSubstr("the path leaves the fence at (3"));
  EXPECT_EQ(why_not(kEverything, {.x_m = 2.5, .y_m = -2.9}, {.x_m = 3.9, .y_m = -2.9}), "");
  EXPECT_THAT(why_not(kFree, {.x_m = -99.0}, {.x_m = 99.0}),
              HasSubstr("'segment.length_m' is 198"));
  EXPECT_THAT(why_not("", {}, {.x_m = 1.0}), HasSubstr("choose a course"));
  // The fence is convex: from within it, exactly the goals outside are refused.
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> inside(-2.9, 2.9), anywhere(-6.0, 6.0);
  int refused = 0;
  for (int i = 0; i < 500; ++i) {
    const Pose goal{.x_m = anywhere(random), .y_m = std::abs(anywhere(random))};
    const bool out = std::max(std::abs(goal.x_m), goal.y_m) > 4.0;
    const std::string why =
        why_not(kEverything, {.x_m = inside(random), .y_m = std::abs(inside(random))}, goal);
    EXPECT_EQ(why.empty(), !out) << why;
    refused += out ? 1 : 0;
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace tp100::course
