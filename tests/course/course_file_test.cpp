// Course files: what they may hold, and the course to a goal that is made of one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/course.h"
#include "course/goal.h"
#include "course/path.h"
#include "support/refusal.h"
#include "text/format.h"

namespace tp100::course {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kFence = "[fence]\nmin_x_m = -1\nmax_x_m = 3\nmin_y_m = -1\nmax_y_m = 1\n";
const std::string kLine = "[[segment]]\ntype = 'line'\nlength_m = 1.5\n";

std::string course_error(const std::string& text) {
  return test::refusal([&] { parse_course(text, "dir/c.toml"); });
}

/// Every table and key that a course file has, on a floor of 8 m x 8 m.
constexpr const char* kEverything = R"(
description = "everything"
speed_mps = 0.125
identifies = true
start = { x_m = 0.1, y_m = 0.2, yaw_deg = 90.0 }
segment = [
  { type = "line", length_m = 0.3 },
  { type = "arc", radius_m = 0.25, angle_deg = -180.0 },
  { type = "pivot", angle_deg = 45.0 },
]
disturbance = [
  { at_m = 0.1, sideways_m = -0.04, yaw_deg = -15.0, duration_s = 0.5 },
  { at_m = 0.1 },
]
ramp = [
  { x_m = 3.0, y_m = 3.1, heading_deg = 12.3, height_m = 0.05, up_deg = 10.0, top_m = 0.1, down_deg = 12.0, width_m = 0.4 },
]
block = [{ x_m = -3.0, y_m = 3.0, height_m = 0.01, depth_m = 0.1, width_m = 0.4 }]
surface = [
  { name = "mat", x_m = 0.0, y_m = 0.0, length_m = 1.0, width_m = 0.5 },
  { name = "wet \"floor\"", x_m = 0.4, y_m = 0.0, heading_deg = 90.0, length_m = 0.4, width_m = 0.1, friction_factor = 0.5, slip_offset = 0.05 },
]
fence = { corners_m = [[-4.0, -4.0], [4.0, -4.0], [4.0, 4.0], [-4.0, 4.0]] }
keep_out = [{ corners_m = [[3.0, -3.5], [3.5, -3.5], [3.25, -3.0]] }]
)";

TEST(CourseFile, ReadsEveryKey) {
  const Course course = parse_course(kEverything, "dir/c.toml");
  EXPECT_EQ(course.name, "c");
  EXPECT_EQ(course.description, "everything");
  EXPECT_EQ(course.speed_mps, 0.125);
  EXPECT_TRUE(course.identifies);
  EXPECT_EQ(course.start.x_m, 0.1);
  EXPECT_EQ(course.start.y_m, 0.2);
  EXPECT_DOUBLE_EQ(course.start.yaw_rad, kPi / 2);
  EXPECT_EQ(std::get<Line>(course.path.at(0)).length_m, 0.3);
  EXPECT_EQ(std::get<Arc>(course.path.at(1)).radius_m, 0.25);
  EXPECT_DOUBLE_EQ(std::get<Arc>(course.path.at(1)).angle_rad, -kPi);
  EXPECT_DOUBLE_EQ(std::get<Pivot>(course.path.at(2)).angle_rad, kPi / 4);
  EXPECT_EQ(course.disturbances.at(0).sideways_m, -0.04);
  EXPECT_DOUBLE_EQ(course.disturbances.at(0).yaw_rad, -15 * kRadPerDeg);
  EXPECT_EQ(course.disturbances.at(0).duration_s, 0.5);
  EXPECT_EQ(course.disturbances.at(1).duration_s, 0.3);
  const Terrain& terrain = course.terrain;
  EXPECT_DOUBLE_EQ(std::get<Ramp>(terrain.obstacles.at(0)).place.heading_rad, 12.3 * kRadPerDeg);
  EXPECT_DOUBLE_EQ(std::get<Ramp>(terrain.obstacles.at(0)).down_rad, 12 * kRadPerDeg);
  EXPECT_EQ(std::get<Block>(terrain.obstacles.at(1)).depth_m, 0.1);
  EXPECT_EQ(terrain.surface_at(0.0, 0.2)->name, "mat");
  EXPECT_EQ(terrain.surface_at(0.4, 0.15)->slip_offset, 0.05);
  EXPECT_EQ(terrain.surface_at(0.3, 0.15)->name, "mat");
  EXPECT_EQ(terrain.surface_at(0.0, 0.3), nullptr);
  EXPECT_EQ(course.fence.corners.at(3).y_m, 4.0);
  EXPECT_EQ(course.fence.min_y_m, -4.0);
  EXPECT_EQ(course.fence.keep_out.at(0).at(2).y_m, -3.0);
  EXPECT_EQ(parse_course(kLine + kFence, "c.toml").fence.max_x_m, 3.0);
}

struct Refusal {
  std::string text, error;
};

void expect_refused(const std::vector<Refusal>& all) {
  for (const Refusal& one : all) EXPECT_THAT(course_error(one.text), HasSubstr(one.error));
}

TEST(CourseFile, RefusesWhatIsMissingMistypedOrOutOfRangeAtItsPlace) {
  expect_refused({
      {"", "dir/c.toml:1:1: "},
      {kFence, "at least one [[segment]]"},
      {"segment = []\n" + kFence, "at least one [[segment]]"},
      {kLine, "missing key 'fence.min_x_m'"},
      {kLine + "[fence]\nmax_x_m = 3\nmin_y_m = -1\nmax_y_m = 1\n",
       ":4:1: missing key 'fence.min_x_m'"},
      {kLine + "[fence]\nmin__m = -1\nmax_x_m = 3\nmin_y_m = -1\nmax_y_m = 1\n",
       ":5:1: unknown key 'fence.min__m'; did you mean 'fence.min_x_m'?"},
      {"[[segments]]\ntype = 'line'\n" + kFence,
       "dir/c.toml:1:3: unknown key 'segments'; did you mean 'segment'?"},
      {"[[segment]]\ntype = 'line'\nradius_m = 1\nlength_m = 1\n" + kFence,
       "dir/c.toml:3:1: unknown key 'segment.radius_m'"},
      {"[[segment]]\ntype = 'line'\nlength_m = 0\n" + kFence,
       "'segment.length_m' is 0, allowed 0.001 to 100 m"},
      {"[[segment]]\ntype = 'pivot'\nangle_deg = 0\n" + kFence, "smallest turn is 0.1 deg"},
      {"[[segment]]\ntype = 'arc'\nangle_deg = 90\n" + kFence, "missing key 'segment.radius_m'"},
      {"[[segment]]\ntype = 'spiral'\n" + kFence, "allowed: 'line', 'arc'"},
      {"[[segment]]\nlength_m = 1\n" + kFence, "missing key 'segment.type'"},
      {kLine + "[[disturbance]]\nat_m = 1.6\n" + kFence, "only 1.5 m long"},
      {kLine + "[[disturbance]]\nat_m = 1.0\n[[disturbance]]\nat_m = 0.5\n" + kFence,
       "order of 'at_m'"},
      {kLine + "[[block]]\nx_m = 1\n" + kFence, "missing key 'block.y_m'"},
      {kLine + "[[ramp]]\nx_m = 1\ny_m = 0\nheight_m = 0.1\nup_deg = 90\n" + kFence,
       "'ramp.up_deg' is 90, allowed 1 to 60 deg"},
      {kLine + "[[surface]]\nx_m = 1\n" + kFence, "needs a 'name'"},
  });
}

TEST(CourseFile, RefusesPolygonsThatAreNone) {
  const auto fence = [](const std::string& corners) {
    return kLine + "[fence]\ncorners_m = " + corners + "\n";
  };
  expect_refused({
      {fence("[[0, 0], [1, 1]]"), "at least three corners"},
      {fence("[[-1, -1], [3, 1], [3, -1], [-1, 1]]"), ":5:"},
      {fence("[[-1, -1], [3, 1], [3, -1], [-1, 1]]"), "cross or touch"},
      {fence("[[-1, -1, 0], [3, 1], [3, -1]]"), "a pair of numbers"},
      {fence("[-1, -1, 3, 1]"), "a pair of numbers"},
      {fence("[[-1, \"a\"], [3, 1], [3, -1]]"), "number"},
      {fence("3"), "array of pairs"},
      {fence("[[-1, -1], [3, -1], [300, 1]]"), "300"},
      {fence("[[-1, -1], [3, -1], [3, 1], [-1, 1]]\nmin_x_m = -1"), "unknown key 'fence.min_x_m'"},
      {kLine + kFence + "[[keep_out]]\nx_m = 1\n", "corners"},
      {kLine + "[fence]\nmin_x_m = 1\nmax_x_m = 1\nmin_y_m = 0\nmax_y_m = 1\n",
       "'max_x_m' must exceed 'min_x_m'"},
  });
}

TEST(CourseFile, RefusesAPathThatLeavesTheFence) {
  // Through a keep-out area, and through a dent of the fence.
  expect_refused({
      {kLine + kFence + "[[keep_out]]\ncorners_m = [[0.5, -0.1], [0.51, -0.1], [0.505, 0.1]]\n",
       "leaves the fence at (0.5"},
      {kLine + "[fence]\ncorners_m = [[-1, -1], [3, -1], [3, 1], [0.6, 1], [0.6, -0.5], "
               "[0.5, 1], [-1, 1]]\n",
       "leaves the fence at"},
  });
}

std::string lines(int count, const std::string& length_m) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += "[[segment]]\ntype = 'line'\nlength_m = " + length_m +
            "\n[[segment]]\ntype = 'pivot'\nangle_deg = 180\n";
  return text;
}

const std::string kWide =
    "[fence]\nmin_x_m = -100\nmax_x_m = 100\nmin_y_m = -100\nmax_y_m = 100\n[start]\nx_m = -49\n";

// A typing error (3600 for 360, a length that is repeated) must not fill the memory of daemon and
// viewers.
TEST(CourseFile, RefusesAPathOfMoreThanAKilometreOrAThousandSegments) {
  std::string pivots = kFence;
  for (int i = 0; i < 1001; ++i) pivots += "[[segment]]\ntype='pivot'\nangle_deg=1\n";
  EXPECT_THAT(course_error(pivots), HasSubstr("more than 1000 segments"));
  EXPECT_EQ(course_error(lines(10, "100") + kWide), "");
  EXPECT_EQ(
      course_error(lines(10, "100") + "[[segment]]\ntype = 'line'\nlength_m = 0.5\n" + kWide),
      "dir/c.toml:63:12: the path is 1000.5 m long at the end of this segment, at most 1000 m "
      "are accepted; split the course");
  EXPECT_THAT(course_error("[[segment]]\ntype = 'arc'\nradius_m = 49\nangle_deg = -3600\n" + kWide),
              StartsWith("dir/c.toml:4:13: the path is 3078.8 m long"));
}

// The time of a check must not grow with the lengths that a file names: as the daemon makes it, it
// is the operator who waits.
TEST(CourseFile, ChecksTheLongestPathAgainstTheMostCornersInTime) {
  std::string text;
  for (int i = 0; i < 1000; ++i)
    text += "[[segment]]\ntype = 'arc'\nradius_m = 0.95\nangle_deg = 60\n";
  const auto polygon = [](double radius_m) {
    std::string corners = "corners_m = [";
    for (int i = 0; i < 100; ++i)
      corners += text::format("[%.3f, %.3f],", radius_m * std::cos(i * kPi / 50.0) * (i % 2 + 1.0),
                              0.95 + radius_m * std::sin(i * kPi / 50.0) * (i % 2 + 1.0)) +
                 (i % 10 == 9 ? "\n" : "");
    return corners + "]\n";
  };
  text += "[fence]\n" + polygon(2.0);
  for (int i = 0; i < 50; ++i) text += "[[keep_out]]\n" + polygon(0.3 + 0.003 * i);
  EXPECT_EQ(course_error(text), "");
}

using ::testing::HasSubstr;

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
  EXPECT_EQ(std::get<Ramp>(after.terrain.obstacles.at(0)).place.heading_rad,
            std::get<Ramp>(before.terrain.obstacles.at(0)).place.heading_rad);
  EXPECT_EQ(after.terrain.obstacles.size(), 2u);
  EXPECT_EQ(after.terrain.surfaces.at(1).name, "wet \"floor\"");
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
