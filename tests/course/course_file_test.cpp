#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/course.h"
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

TEST(CourseFile, ReadsEveryKey) {
  const Course course = parse_course(
      "description = 'd'\nspeed_mps = 0.2\n[start]\nx_m = 0.1\ny_m = 0.2\nyaw_deg = 90\n"
      "[[segment]]\ntype = 'line'\nlength_m = 0.3\n"
      "[[segment]]\ntype = 'arc'\nradius_m = 0.25\nangle_deg = -180\n"
      "[[segment]]\ntype = 'pivot'\nangle_deg = 45\n"
      "[[disturbance]]\nat_m = 0.1\nsideways_m = -0.04\nyaw_deg = -15\nduration_s = 0.5\n"
      "[[disturbance]]\nat_m = 0.1\n" +
          kFence,
      "dir/c.toml");
  EXPECT_EQ(course.name, "c");
  EXPECT_EQ(course.description, "d");
  EXPECT_EQ(course.speed_mps, 0.2);
  EXPECT_EQ(course.start.x_m, 0.1);
  EXPECT_EQ(course.start.y_m, 0.2);
  EXPECT_DOUBLE_EQ(course.start.yaw_rad, kPi / 2);
  ASSERT_EQ(course.path.size(), 3u);
  EXPECT_EQ(std::get<Line>(course.path[0]).length_m, 0.3);
  EXPECT_EQ(std::get<Arc>(course.path[1]).radius_m, 0.25);
  EXPECT_DOUBLE_EQ(std::get<Arc>(course.path[1]).angle_rad, -kPi);
  EXPECT_DOUBLE_EQ(std::get<Pivot>(course.path[2]).angle_rad, kPi / 4);
  ASSERT_EQ(course.disturbances.size(), 2u);
  EXPECT_EQ(course.disturbances[0].sideways_m, -0.04);
  EXPECT_DOUBLE_EQ(course.disturbances[0].yaw_rad, -15 * kRadPerDeg);
  EXPECT_EQ(course.disturbances[0].duration_s, 0.5);
  EXPECT_EQ(course.disturbances[1].duration_s, 0.3);
  EXPECT_EQ(course.fence.max_x_m, 3.0);
}

TEST(CourseFile, ReadsFenceAreasToKeepOutOfAndTerrain) {
  const Course course = parse_course(
      kLine +
          "[fence]\ncorners_m = [[-1, -1], [3, -1], [3, 1], [1.0, 0.5], [-1, 1]]\n"
          "[[keep_out]]\ncorners_m = [[0, -0.9], [1, -0.9], [1, -0.5]]\n"
          "[[ramp]]\nx_m = 0.5\ny_m = 0.1\nheading_deg = 90\nheight_m = 0.08\nup_deg = 28\n"
          "top_m = 0\ndown_deg = 20\nwidth_m = 0.4\n"
          "[[block]]\nx_m = 1\ny_m = 0\nheight_m = 0.03\ndepth_m = 0.1\nwidth_m = 0.4\n"
          "[[surface]]\nname = 'mat'\nx_m = 0\ny_m = 0\nlength_m = 1\nwidth_m = 0.5\n"
          "[[surface]]\nname = 'wet'\nx_m = 0.4\ny_m = 0\nheading_deg = 90\nlength_m = 0.4\n"
          "width_m = 0.1\nfriction_factor = 0.5\nslip_offset = 0.05\n",
      "c.toml");
  EXPECT_EQ(course.fence.corners.size(), 5U);
  EXPECT_EQ(course.fence.corners[3].y_m, 0.5);
  EXPECT_EQ(course.fence.max_x_m, 3.0);
  EXPECT_EQ(course.fence.min_y_m, -1.0);
  EXPECT_EQ(course.fence.keep_out.at(0).at(2).y_m, -0.5);
  const Terrain& terrain = course.terrain;
  EXPECT_DOUBLE_EQ(terrain.ramps.at(0).place.heading_rad, kPi / 2);
  EXPECT_DOUBLE_EQ(terrain.ramps.at(0).down_rad, 20 * kRadPerDeg);
  EXPECT_EQ(terrain.blocks.at(0).depth_m, 0.1);
  EXPECT_FALSE(terrain.flat());
  EXPECT_EQ(terrain.surface_at(0.0, 0.2)->name, "mat");
  EXPECT_EQ(terrain.surface_at(0.4, 0.15)->name, "wet");
  EXPECT_EQ(terrain.surface_at(0.3, 0.15)->name, "mat");
  EXPECT_EQ(terrain.surface_at(0.0, 0.3), nullptr);
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
      {"[[segment]]\ntype = 'spiral'\n" + kFence, "Allowed: 'line', 'arc'"},
      {"[[segment]]\nlength_m = 1\n" + kFence, "missing key 'segment.type'"},
      {kLine + "[[disturbance]]\nat_m = 1.6\n" + kFence, "only 1.5 m long"},
      {kLine + "[[disturbance]]\nat_m = 1.0\n[[disturbance]]\nat_m = 0.5\n" + kFence,
       "order of 'at_m'"},
      {kLine + "[[block]]\nx_m = 1\n" + kFence, "missing key 'block.y_m'"},
      {kLine + "[[ramp]]\nx_m = 1\ny_m = 0\nheight_m = 0.1\nup_deg = 90\n" + kFence,
       "'ramp.up_deg' is 90, allowed 1 to 60 deg"},
      {kLine + "[[surface]]\nx_m = 1\n" + kFence, "needs a 'name'"},
      {kLine + "[[shove]]\nat_m = 0.5\n" + kFence,
       "unknown key 'shove'; did you mean 'disturbance'?"},
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
  expect_refused({
      {"[[segment]]\ntype = 'arc'\nradius_m = 0.6\nangle_deg = 180\n" + kFence,
       "leaves the fence at"},
      // Through a keep-out area, and through a dent of the fence.
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

}  // namespace
}  // namespace tp100::course
