#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "core/arithmetic.h"
#include "course/bundled_files.h"
#include "course/course.h"
#include "course/path.h"
#include "course/robot_file.h"
#include "support/paths.h"

namespace tp100::course {
namespace {

std::string bundled_path(const std::string& name) {
  return source_path("config/" + name + ".toml");
}

Course bundled_course(const std::string& name) {
  const TextFile file = read_text_file(bundled_path("courses/" + name));
  return parse_course(file.text, file.path);
}

TEST(BundledCourses, HaveTheDocumentedLengthsAndEnds) {
  struct Expected {
    const char* name;
    double length_m, end_x_m, end_y_m, end_yaw_deg;
  };
  for (const Expected& expected : {Expected{"1-straight", 1.7, 1.7, 0.0, 0.0},
                                   Expected{"1-curve", 0.8 + 0.35 * kPi, 0.0, 0.7, 180.0},
                                   Expected{"1-sharp", 1.7, 1.0, 0.7, 90.0},
                                   Expected{"2", 2.6 + 0.15 * kPi, 0.3, -0.5, -180.0}}) {
    SCOPED_TRACE(expected.name);
    const Course course = bundled_course(expected.name);
    const Path path(course);
    EXPECT_EQ(course.name, expected.name);
    EXPECT_EQ(course.speed_mps, 0.10);
    EXPECT_NEAR(path.length_m(), expected.length_m, 1e-9);
    EXPECT_NEAR(path.segments().back().end.x_m, expected.end_x_m, 1e-9);
    EXPECT_NEAR(path.segments().back().end.y_m, expected.end_y_m, 1e-9);
    EXPECT_NEAR(path.segments().back().end.yaw_rad, expected.end_yaw_deg * kRadPerDeg, 1e-9);
    // In the paper's arena, with room for a push.
    EXPECT_NEAR(course.fence.max_x_m - course.fence.min_x_m, 1.9, 1e-9);
    EXPECT_NEAR(course.fence.max_y_m - course.fence.min_y_m, 1.0, 1e-9);
    Fence room = course.fence;
    room.min_x_m += 0.095;
    room.min_y_m += 0.095;
    room.max_x_m -= 0.095;
    room.max_y_m -= 0.095;
    EXPECT_FALSE(first_point_outside(path, room));
    EXPECT_EQ(course.disturbances.size(), course.name == "2" ? 2u : 0u);
    for (const Disturbance& push : course.disturbances) {
      EXPECT_DOUBLE_EQ(std::abs(push.sideways_m), 0.04);
      EXPECT_DOUBLE_EQ(std::abs(push.yaw_rad), 15.0 * kRadPerDeg);
    }
  }
}

TEST(BundledCourses, Course3HasThePapersStepAndRampOnItsWayBack) {
  const Course course = bundled_course("3");
  const Path path(course);
  EXPECT_NEAR(path.segments().back().end.x_m, 0.0, 1e-9);
  EXPECT_NEAR(path.segments().back().end.y_m, -0.8, 1e-9);
  EXPECT_NEAR(course.fence.max_x_m - course.fence.min_x_m, 1.9, 1e-9);
  EXPECT_NEAR(course.fence.max_y_m - course.fence.min_y_m, 1.0, 1e-9);
  ASSERT_EQ(course.terrain.blocks.size(), 1u);
  const Block& block = course.terrain.blocks[0];
  EXPECT_EQ(block.place.x_m, 1.20);
  EXPECT_EQ(block.place.y_m, -0.80);
  EXPECT_EQ(block.height_m, 0.037);
  ASSERT_EQ(course.terrain.ramps.size(), 1u);
  const Ramp& ramp = course.terrain.ramps[0];
  EXPECT_EQ(ramp.place.x_m, 0.70);
  EXPECT_EQ(ramp.place.y_m, -0.80);
  EXPECT_DOUBLE_EQ(ramp.up_rad, 28 * kRadPerDeg);
  EXPECT_NEAR(ramp.length_m(), 0.2 + 2 * 0.08 / std::tan(28 * kRadPerDeg), 1e-12);
}

// `scripts/test --accept` rewrites the files from the values that they hold, with the comments of
// the key table.
TEST(BundledRobots, SayWhatTheKeyTableSays) {
  for (const char* name : {"end-loaded", "uniform", "front-heavy", "slippery", "large", "worn"}) {
    const std::string path = bundled_path("robots/" + std::string(name));
    const std::string text = read_text_file(path).text;
    const Robot robot = parse_robot(text, path);
    const std::string written = write_robot(robot, head_note(text));
    if (std::getenv("TP100_ACCEPT"))
      std::ofstream(path, std::ios::binary) << written;
    else
      EXPECT_EQ(text, written) << "the comments of " << path << " differ from the key table";
  }
}

}  // namespace
}  // namespace tp100::course
