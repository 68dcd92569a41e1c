// Whether a robot can climb what stands on its path.

#include "terrain/climbable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"
#include "support/refusal.h"

namespace tp100::terrain {
namespace {

using testing::HasSubstr;

course::Robot robot(double com_height_m = 0.022) {
  course::Robot robot;
  robot.name = "tall";
  robot.shape.com_height_m = com_height_m;
  return robot;
}

std::string error_of(const course::Course& course, const course::Robot& robot = terrain::robot()) {
  return test::refusal([&] { require_climbable(course, robot); });
}

/// A straight path of 1 m, and a place `along` and `aside` from its start.
course::Course straight() {
  course::Course course;
  course.name = "wall";
  course.start = {.x_m = 0.4, .y_m = -0.3, .yaw_rad = 2.2};
  course.path = {course::Line{1.0}};
  return course;
}
course::Place place_at(double along, double aside = 0.0) {
  const double c = std::cos(2.2), s = std::sin(2.2);
  return {0.4 + c * along - s * aside, -0.3 + s * along + c * aside, 2.2};
}
course::Course wall_at(double along, double depth_m, double aside = 0.0, double width_m = 0.5,
                       double height_m = 0.1) {
  course::Course course = straight();
  course.terrain.obstacles.push_back(
      course::Block{place_at(along, aside), height_m, depth_m, width_m});
  return course;
}

TEST(Climbable, AStepAboveTheLimitIsRefusedByNameWithTheLimit) {
  const course::Course paper = wall_at(0.5, 0.1, 0.0, 0.5, 0.037);
  EXPECT_EQ(error_of(paper), "");
  EXPECT_THAT(error_of(paper, robot(0.030)),
              HasSubstr("course wall: block 1 cannot be climbed by robot tall: it is 37 mm high, "
                        "the limit is 33.4 mm"));
}

TEST(Climbable, ARampIsJudgedByItsSteeperSideToAHairOfTheLimit) {
  for (const double forward_m : {0.0, -0.03}) {
    course::Robot tower = robot(0.045);
    tower.shape.com_forward_m = forward_m;
    const double behind_m = tower.shape.axle_spacing_m / 2.0 - std::abs(forward_m);
    const double limit_rad = std::atan(behind_m / tower.shape.com_height_m);
    for (double course::Ramp::*const side : {&course::Ramp::up_rad, &course::Ramp::down_rad}) {
      course::Course course = straight();
      course.terrain.obstacles = {course::Ramp{place_at(0.5), 0.05, 0.2, 0.1, 0.2, 0.5}};
      auto& ramp = std::get<course::Ramp>(course.terrain.obstacles[0]);
      ramp.*side = limit_rad - 1e-9;
      EXPECT_EQ(error_of(course, tower), "");
      ramp.*side = limit_rad + 1e-9;
      EXPECT_THAT(error_of(course, tower), HasSubstr("ramp 1"));
      ramp.place.y_m = 3.0;
      EXPECT_EQ(error_of(course, tower), "") << "beside the path";
    }
  }
}

TEST(Climbable, AThinWallAnywhereOnThePathIsMet) {
  for (double x = 0.003; x < 1.0; x += 0.0137) EXPECT_NE(error_of(wall_at(x, 0.0102)), "") << x;
  EXPECT_EQ(error_of(wall_at(-0.03, 0.0102)), "") << "behind the start";
  EXPECT_EQ(error_of(wall_at(1.03, 0.0102)), "") << "beyond the end";
}

TEST(Climbable, AWallIsMetByEitherTrackButNotBesideThem) {
  const double track_m = robot().shape.gauge_m / 2.0;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NE(error_of(wall_at(0.5, 0.1, side * (track_m + 0.049), 0.1)), "");
    EXPECT_EQ(error_of(wall_at(0.5, 0.1, side * (track_m + 0.051), 0.1)), "");
  }
  EXPECT_EQ(error_of(wall_at(0.5, 0.1, 0.0, 2.0 * track_m - 0.002)), "") << "between the tracks";
}

TEST(Climbable, TheFirstObstacleThatIsTooMuchIsNamed) {
  course::Course course = wall_at(0.2, 0.1, 0.0, 0.5, 0.03);
  for (const double along : {0.5, 0.8})
    course.terrain.obstacles.push_back(wall_at(along, 0.1).terrain.obstacles[0]);
  EXPECT_EQ(error_of(course),
            "course wall: block 2 cannot be climbed by robot tall: it is 100 mm high, the limit is "
            "40.2 mm; lower the block or, if the robot file is wrong, shape.com_height_m");
  course.terrain.obstacles = {wall_at(0.2, 0.1, 0.0, 0.5, 0.03).terrain.obstacles[0],
                              course::Ramp{place_at(0.5), 0.05, 0.3, 0.1, 0.4, 0.5},
                              course::Ramp{place_at(0.5), 0.05, 0.3, 0.1, 1.3, 0.5}};
  EXPECT_EQ(
      error_of(course),
      "course wall: ramp 2 cannot be climbed by robot tall: it is 74.5 deg steep, beyond 71.7 deg "
      "it falls over; make the ramp flatter");
}

}  // namespace
}  // namespace tp100::terrain
