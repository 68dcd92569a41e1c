#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/course.h"
#include "text/format.h"

namespace tp100::course {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kFence = "[fence]\nmin_x_m = -1\nmax_x_m = 3\nmin_y_m = -1\nmax_y_m = 1\n";
const std::string kLine = "[[segment]]\ntype = 'line'\nlength_m = 1.5\n";

std::string course_error(const std::string& text) {
  try {
    parse_course(text, "dir/c.toml");
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
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

TEST(CourseFile, RefusesACourseWithoutPathOrFence) {
  EXPECT_THAT(course_error(kFence), HasSubstr("at least one [[segment]]"));
  EXPECT_THAT(course_error(kLine), HasSubstr("missing key 'fence.min_x_m'"));
  EXPECT_THAT(course_error(kLine + "[fense]\nmin_x_m = -1\n"),
              HasSubstr(":4:2: unknown key 'fense'; did you mean 'fence'?"));
  EXPECT_THAT(
      course_error(kLine + "[fence]\nmin__m = -1\nmax_x_m = 3\nmin_y_m = -1\nmax_y_m = 1\n"),
      HasSubstr(":5:1: unknown key 'fence.min__m'; did you mean 'fence.min_x_m'?"));
  EXPECT_THAT(course_error(kLine + "[fence]\nmax_x_m = 3\nmin_y_m = -1\nmax_y_m = 1\n"),
              HasSubstr(":4:1: missing key 'fence.min_x_m'"));
  EXPECT_THAT(course_error(""), StartsWith("dir/c.toml:1:1: "));
  EXPECT_THAT(course_error("segment = []\n" + kFence), HasSubstr("at least one [[segment]]"));
}

TEST(CourseFile, NamesAMistypedKeyAtItsPlace) {
  EXPECT_EQ(course_error("speeed_mps = 0.1\n" + kLine + kFence),
            "dir/c.toml:1:1: unknown key 'speeed_mps'; did you mean 'speed_mps'?");
  EXPECT_EQ(course_error("[[segments]]\ntype = 'line'\n" + kFence),
            "dir/c.toml:1:3: unknown key 'segments'; did you mean 'segment'?");
  EXPECT_THAT(course_error("[[segment]]\ntype = 'line'\nradius_m = 1\nlength_m = 1\n" + kFence),
              StartsWith("dir/c.toml:3:1: unknown key 'segment.radius_m'"));
}

TEST(CourseFile, RefusesValuesThatMakeNoPath) {
  EXPECT_THAT(course_error("[[segment]]\ntype = 'line'\nlength_m = 0\n" + kFence),
              HasSubstr("'segment.length_m' is 0, allowed 0.001 to 100 m"));
  EXPECT_THAT(course_error("[[segment]]\ntype = 'pivot'\nangle_deg = 0\n" + kFence),
              HasSubstr("smallest turn is 0.1 deg"));
  EXPECT_THAT(course_error("[[segment]]\ntype = 'arc'\nangle_deg = 90\n" + kFence),
              HasSubstr("missing key 'segment.radius_m'"));
  EXPECT_THAT(course_error("[[segment]]\ntype = 'spiral'\n" + kFence),
              HasSubstr("Allowed: 'line', 'arc'"));
  EXPECT_THAT(course_error("[[segment]]\nlength_m = 1\n" + kFence),
              HasSubstr("missing key 'segment.type'"));
}

TEST(CourseFile, ReadsAFenceWithCornersAndAreasToKeepOutOf) {
  const Course course =
      parse_course(kLine +
                       "[fence]\ncorners_m = [[-1, -1], [3, -1], [3, 1], [1.0, 0.5], [-1, 1]]\n"
                       "[[keep_out]]\ncorners_m = [[0, -0.9], [1, -0.9], [1, -0.5]]\n",
                   "c.toml");
  EXPECT_EQ(course.fence.corners.size(), 5U);
  EXPECT_EQ(course.fence.corners[3].y_m, 0.5);
  EXPECT_EQ(course.fence.max_x_m, 3.0);
  EXPECT_EQ(course.fence.min_y_m, -1.0);
  ASSERT_EQ(course.fence.keep_out.size(), 1U);
  EXPECT_EQ(course.fence.keep_out[0][2].y_m, -0.5);
}

TEST(CourseFile, RefusesPolygonsThatAreNone) {
  const auto fence = [](const std::string& corners) {
    return course_error(kLine + "[fence]\ncorners_m = " + corners + "\n");
  };
  EXPECT_THAT(fence("[[0, 0], [1, 1]]"), HasSubstr("at least three corners"));
  EXPECT_THAT(fence("[[-1, -1], [3, 1], [3, -1], [-1, 1]]"), HasSubstr(":5:"));
  EXPECT_THAT(fence("[[-1, -1], [3, 1], [3, -1], [-1, 1]]"), HasSubstr("cross or touch"));
  EXPECT_THAT(fence("[[-1, -1, 0], [3, 1], [3, -1]]"), HasSubstr("a pair of numbers"));
  EXPECT_THAT(fence("[-1, -1, 3, 1]"), HasSubstr("a pair of numbers"));
  EXPECT_THAT(fence("[[-1, \"a\"], [3, 1], [3, -1]]"), HasSubstr("number"));
  EXPECT_THAT(fence("3"), HasSubstr("array of pairs"));
  EXPECT_THAT(fence("[[-1, -1], [3, -1], [300, 1]]"), HasSubstr("300"));
  EXPECT_THAT(fence("[[-1, -1], [3, -1], [3, 1], [-1, 1]]\nmin_x_m = -1"),
              HasSubstr("unknown key 'fence.min_x_m'"));
  EXPECT_THAT(course_error(kLine + kFence + "[[keep_out]]\nx_m = 1\n"), HasSubstr("corners"));
}

TEST(CourseFile, RefusesAPathThatMeetsAKeepOutAreaOrADent) {
  EXPECT_THAT(course_error(kLine + kFence +
                           "[[keep_out]]\ncorners_m = [[0.5, -0.1], [0.51, -0.1], [0.505, 0.1]]\n"),
              HasSubstr("leaves the fence at (0.5"));
  EXPECT_THAT(course_error(kLine + "[fence]\ncorners_m = [[-1, -1], [3, -1], [3, 1], [0.6, 1], "
                                   "[0.6, -0.5], [0.5, 1], [-1, 1]]\n"),
              HasSubstr("leaves the fence at"));
}

TEST(CourseFile, RefusesAFenceThatThePathLeaves) {
  EXPECT_THAT(course_error("[[segment]]\ntype = 'arc'\nradius_m = 0.6\nangle_deg = 180\n" + kFence),
              HasSubstr("leaves the fence at"));
  EXPECT_THAT(course_error(kLine + "[fence]\nmin_x_m = 1\nmax_x_m = 1\nmin_y_m = 0\nmax_y_m = 1\n"),
              HasSubstr("'max_x_m' must exceed 'min_x_m'"));
}

TEST(CourseFile, RefusesDisturbancesBeyondThePathOrOutOfOrder) {
  EXPECT_THAT(course_error(kLine + "[[disturbance]]\nat_m = 1.6\n" + kFence),
              HasSubstr("only 1.5 m long"));
  EXPECT_THAT(
      course_error(kLine + "[[disturbance]]\nat_m = 1.0\n[[disturbance]]\nat_m = 0.5\n" + kFence),
      HasSubstr("order of 'at_m'"));
}

TEST(CourseFile, ReadsTerrain) {
  const Course course = parse_course(
      kLine + kFence +
          "[[ramp]]\nx_m = 0.5\ny_m = 0.1\nheading_deg = 90\nheight_m = 0.08\nup_deg = 28\n"
          "top_m = 0\ndown_deg = 20\nwidth_m = 0.4\n"
          "[[block]]\nx_m = 1\ny_m = 0\nheight_m = 0.03\ndepth_m = 0.1\nwidth_m = 0.4\n"
          "[[surface]]\nname = 'mat'\nx_m = 0\ny_m = 0\nlength_m = 1\nwidth_m = 0.5\n"
          "[[surface]]\nname = 'wet'\nx_m = 0.4\ny_m = 0\nheading_deg = 90\nlength_m = 0.4\n"
          "width_m = 0.1\nfriction_factor = 0.5\nslip_offset = 0.05\n",
      "c.toml");
  const Terrain& terrain = course.terrain;
  ASSERT_EQ(terrain.ramps.size(), 1u);
  EXPECT_DOUBLE_EQ(terrain.ramps[0].place.heading_rad, kPi / 2);
  EXPECT_DOUBLE_EQ(terrain.ramps[0].down_rad, 20 * kRadPerDeg);
  ASSERT_EQ(terrain.blocks.size(), 1u);
  EXPECT_EQ(terrain.blocks[0].depth_m, 0.1);
  EXPECT_FALSE(terrain.flat());
  EXPECT_EQ(terrain.surface_at(0.0, 0.2)->name, "mat");
  EXPECT_EQ(terrain.surface_at(0.4, 0.15)->name, "wet");
  EXPECT_EQ(terrain.surface_at(0.3, 0.15)->name, "mat");
  EXPECT_EQ(terrain.surface_at(0.0, 0.3), nullptr);
}

TEST(CourseFile, RefusesTerrainThatIsNone) {
  EXPECT_THAT(course_error(kLine + "[[block]]\nx_m = 1\n" + kFence),
              HasSubstr("missing key 'block.y_m'"));
  EXPECT_THAT(
      course_error(kLine + "[[ramp]]\nx_m = 1\ny_m = 0\nheight_m = 0.1\nup_deg = 90\n" + kFence),
      HasSubstr("'ramp.up_deg' is 90, allowed 1 to 60 deg"));
  EXPECT_THAT(course_error(kLine + "[[surface]]\nx_m = 1\n" + kFence), HasSubstr("needs a 'name'"));
  EXPECT_THAT(course_error(kLine + "[[shove]]\nat_m = 0.5\n" + kFence),
              HasSubstr("unknown key 'shove'; did you mean 'disturbance'?"));
  EXPECT_THAT(course_error(kLine + "[[blok]]\nx_m = 1\n" + kFence),
              HasSubstr("did you mean 'block'?"));
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
TEST(CourseFile, RefusesAPathOfMoreThanAKilometreWhereItGoesBeyond) {
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

TEST(CourseFile, RefusesMoreSegmentsThanACourseCanHave) {
  std::string text = kFence;
  for (int i = 0; i < 1001; ++i) text += "[[segment]]\ntype='pivot'\nangle_deg=1\n";
  EXPECT_THAT(course_error(text), HasSubstr("more than 1000 segments"));
}

}  // namespace
}  // namespace tp100::course
