#include "core/pose.h"

#include <gtest/gtest.h>

#include "core/arithmetic.h"

namespace tp100 {
namespace {

TEST(Transform2d, TakesOnePoseToTheOtherAndAllThatMoveWithIt) {
  const Pose from{.x_m = 1.0, .y_m = 2.0, .yaw_rad = 0.5};
  const Pose to{.x_m = -0.3, .y_m = 0.4, .yaw_rad = 0.5 + kPi / 2 + 2 * kPi};
  const Transform2d transform = Transform2d::between(from, to);
  const Pose there = transform.of(from);
  EXPECT_NEAR(there.x_m, to.x_m, 1e-12);
  EXPECT_NEAR(there.y_m, to.y_m, 1e-12);
  EXPECT_NEAR(transform.turn_rad, kPi / 2, 1e-12) << "the branch of the robot's own yaw stays";
  const Pose ahead = transform.of({.x_m = 1.1, .y_m = 2.0, .yaw_rad = 0.5});
  EXPECT_NEAR(ahead.x_m, to.x_m, 1e-12);
  EXPECT_NEAR(ahead.y_m, to.y_m + 0.1, 1e-12);
}

}  // namespace
}  // namespace tp100
