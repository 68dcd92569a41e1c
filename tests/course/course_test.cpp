#include "course/course.h"

#include <gtest/gtest.h>

#include "core/arithmetic.h"
#include "course/path.h"

namespace tp100::course {
namespace {

TEST(Mirror, TurnsLeftIntoRightAndNothingElse) {
  Course course;
  course.name = "test";
  course.start.yaw_rad = 0.2;
  course.path = {Line{1.0}, Arc{0.4, kPi}, Pivot{0.5}, Line{0.3}};
  course.disturbances = {{0.5, 0.04, 0.1, 0.3}};
  course.terrain.ramps.push_back({{0.7, -0.8, 0.3}, 0.08, 0.4, 0.2, 0.5, 0.4});
  course.terrain.blocks.push_back({{1.2, -0.8, 0.3}, 0.037, 0.1, 0.4});
  course.terrain.surfaces.push_back({"felt", {0.1, 0.2, 0.3}, 1.0, 1.0, 1.0, 0.1});
  course.fence = {-1.0, 2.0, -0.5, 1.5, {}, {{{0.1, 0.2}, {0.3, 0.2}, {0.1, 0.4}}}};
  const Course other = mirrored(course);
  const Path path(course), mirror(other);
  for (double s = 0.0; s < path.length_m(); s += 0.05) {
    EXPECT_NEAR(mirror.at(s).x_m, path.at(s).x_m, 1e-12);
    EXPECT_NEAR(mirror.at(s).y_m, -path.at(s).y_m, 1e-12);
    EXPECT_NEAR(mirror.at(s).yaw_rad, -path.at(s).yaw_rad, 1e-12);
  }
  EXPECT_EQ(other.disturbances[0].sideways_m, -0.04);
  EXPECT_EQ(other.terrain.ramps[0].place.y_m, 0.8);
  EXPECT_EQ(other.terrain.ramps[0].up_rad, 0.4);
  EXPECT_EQ(other.terrain.blocks[0].place.heading_rad, -0.3);
  EXPECT_EQ(other.fence.min_y_m, -1.5);
  EXPECT_EQ(other.fence.max_y_m, 0.5);
  EXPECT_EQ(other.fence.keep_out.at(0).at(2).y_m, -0.4);
  const Course back = mirrored(other);
  EXPECT_EQ(back.terrain.surfaces[0].place.y_m, 0.2);
  EXPECT_EQ(back.start.yaw_rad, 0.2);
}

}  // namespace
}  // namespace tp100::course
