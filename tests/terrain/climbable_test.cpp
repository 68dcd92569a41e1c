#include "terrain/climbable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/arithmetic.h"
#include "core/error.h"
#include "support/paths.h"

namespace tp100::terrain {
namespace {

using testing::HasSubstr;

course::Course course_3() {
  const std::string path = source_path("config/courses/3.toml");
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return course::parse_course(text.str(), path);
}

course::Robot robot(double com_height_m) {
  course::Robot robot;
  robot.name = "tall";
  robot.shape.com_height_m = com_height_m;
  return robot;
}

std::string error_of(const course::Course& course, const course::Robot& robot) {
  try {
    require_climbable(course, robot);
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

TEST(Climbable, TheReferenceRobotCanClimbThePapersStep) {
  EXPECT_EQ(error_of(course_3(), robot(0.022)), "");
}

TEST(Climbable, AStepAboveTheLimitIsRefusedByNameWithTheLimit) {
  EXPECT_THAT(error_of(course_3(), robot(0.030)),
              HasSubstr("course 3: block 1 cannot be climbed by robot tall: it is 37 mm high, the "
                        "limit is 33.4 mm"));
  course::Course course = course_3();
  course.terrain.blocks[0].height_m = 0.041;
  EXPECT_THAT(error_of(course, robot(0.022)), HasSubstr("it is 41 mm high, the limit is 40.2 mm"));
}

TEST(Climbable, ABlockBesideThePathIsNoStep) {
  course::Course course = course_3();
  course.terrain.blocks[0].height_m = 0.2;
  course.terrain.blocks[0].place.y_m = -0.4;
  course.terrain.blocks[0].width_m = 0.3;
  EXPECT_EQ(error_of(course, robot(0.022)), "");
  course.terrain.blocks[0].place.y_m = -0.6;
  EXPECT_THAT(error_of(course, robot(0.022)), HasSubstr("block 1"))
      << "the right track meets the block";
}

TEST(Climbable, ARampOnWhichTheRobotFallsOverIsRefused) {
  course::Robot tower = robot(0.045);
  tower.shape.com_forward_m = -0.03;
  course::Course course = course_3();
  course.terrain.blocks.clear();
  EXPECT_EQ(error_of(course, tower), "");
  course.terrain.ramps[0].up_rad = 45 * kRadPerDeg;
  EXPECT_THAT(error_of(course, tower), HasSubstr("ramp 1 cannot be climbed by robot tall"));
}

}  // namespace
}  // namespace tp100::terrain
