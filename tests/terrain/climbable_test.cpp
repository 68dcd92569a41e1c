#include "terrain/climbable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/arithmetic.h"
#include "support/paths.h"
#include "support/refusal.h"

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
  return test::refusal([&] { require_climbable(course, robot); });
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
  EXPECT_EQ(error_of(course, tower),
            "course 3: ramp 1 cannot be climbed by robot tall: it is 45 deg steep, beyond 39 deg "
            "it falls over; make the ramp flatter");
}

TEST(Climbable, ARampIsJudgedByItsSteeperSideToAHairOfTheLimit) {
  const course::Robot any = robot(0.045);
  const double limit_rad = std::atan(any.shape.axle_spacing_m / 2.0 / any.shape.com_height_m);
  course::Course course = course_3();
  course.terrain.blocks.clear();
  for (double course::Ramp::*const side : {&course::Ramp::up_rad, &course::Ramp::down_rad}) {
    course.terrain.ramps = course_3().terrain.ramps;
    course::Ramp& ramp = course.terrain.ramps[0];
    ramp.*side = limit_rad - 1e-9;
    EXPECT_EQ(error_of(course, any), "");
    ramp.*side = limit_rad + 1e-9;
    EXPECT_THAT(error_of(course, any), HasSubstr("ramp 1"));
    ramp.place.y_m = 3.0;
    EXPECT_EQ(error_of(course, any), "") << "beside the path";
  }
}

/// A straight path of 1 m and a wall across it, `along` and `aside` from its start.
course::Course wall_at(double along, double depth_m, double aside = 0.0, double width_m = 0.5) {
  const double yaw = 2.2, c = std::cos(yaw), s = std::sin(yaw);
  course::Course course;
  course.name = "wall";
  course.start = {.x_m = 0.4, .y_m = -0.3, .yaw_rad = yaw};
  course.path = {course::Line{1.0}};
  const course::Place place{0.4 + c * along - s * aside, -0.3 + s * along + c * aside, yaw};
  course.terrain.blocks.push_back({place, 0.1, depth_m, width_m});
  return course;
}

TEST(Climbable, AThinWallAnywhereOnThePathIsMet) {
  for (double x = 0.003; x < 1.0; x += 0.0137)
    EXPECT_NE(error_of(wall_at(x, 0.0102), robot(0.022)), "") << x;
  EXPECT_EQ(error_of(wall_at(-0.03, 0.0102), robot(0.022)), "") << "behind the start";
  EXPECT_EQ(error_of(wall_at(1.03, 0.0102), robot(0.022)), "") << "beyond the end";
}

TEST(Climbable, AWallIsMetByEitherTrackButNotBesideThem) {
  const double track_m = robot(0.022).shape.gauge_m / 2.0;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NE(error_of(wall_at(0.5, 0.1, side * (track_m + 0.049), 0.1), robot(0.022)), "");
    EXPECT_EQ(error_of(wall_at(0.5, 0.1, side * (track_m + 0.051), 0.1), robot(0.022)), "");
  }
  EXPECT_EQ(error_of(wall_at(0.5, 0.1, 0.0, 2.0 * track_m - 0.002), robot(0.022)), "")
      << "between the tracks";
}

TEST(Climbable, TheFirstObstacleThatIsTooMuchIsNamed) {
  course::Course course = wall_at(0.5, 0.1);
  course.terrain.blocks.insert(course.terrain.blocks.begin(), wall_at(0.2, 0.1).terrain.blocks[0]);
  course.terrain.blocks[0].height_m = 0.03;
  course.terrain.blocks.push_back(wall_at(0.8, 0.1).terrain.blocks[0]);
  EXPECT_EQ(error_of(course, robot(0.022)),
            "course wall: block 2 cannot be climbed by robot tall: it is 100 mm high, the limit is "
            "40.2 mm; lower the block or, if the robot file is wrong, shape.com_height_m");
  const course::Place place = course.terrain.blocks[1].place;
  course.terrain.blocks.clear();
  course.terrain.ramps = {{place, 0.05, 0.3, 0.1, 0.4, 0.5}, {place, 0.05, 0.3, 0.1, 1.3, 0.5}};
  EXPECT_THAT(error_of(course, robot(0.022)), HasSubstr("ramp 2"));
}

}  // namespace
}  // namespace tp100::terrain
