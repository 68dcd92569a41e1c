// Tests the law that daemon/control/EXTENDING.md shows: its code comes from the page, is a law of
// this tree, and steers a robot onto its path.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "../control/lagging_robot.h"
#include "docs/proportional.h"

namespace tp100::control {
namespace {

/// Pose of a robot that started `left_m` beside a straight path once it has driven 0.7 m along it.
Pose driven(const Law& law, double left_m) {
  LaggingRobot robot;
  robot.pose.y_m = left_m;
  while (robot.pose.x_m < 0.7) {
    const LawOutput steering = law.steer({.cross_track_m = robot.pose.y_m,
                                          .heading_rad = robot.pose.yaw_rad,
                                          .yaw_rate_radps = robot.twist.yaw_rate_radps,
                                          .speed_mps = 0.1});
    Target target;
    target.desired_yaw_rad = steering.yaw_rad;
    target.yaw_rate_radps = steering.yaw_rate_radps;
    target.speed_mps = 0.1;
    robot.obey(target);
  }
  return robot.pose;
}

TEST(ExtendingPage, ShowsALawThatSteersOntoThePath) {
  const std::unique_ptr<Law> law = std::make_unique<Proportional>(Parameters{});
  for (const double left_m : {-0.08, 0.08}) {
    const Pose end = driven(*law, left_m);
    EXPECT_NEAR(end.y_m, 0.0, 0.003);  // as law_test asks of every law
  }
}

TEST(ExtendingPage, ShowsALawThatStaysBounded) {
  const Parameters parameters;
  const Proportional law(parameters);
  for (const double left_m : {-1e6, -0.3, 5.0})
    EXPECT_LE(std::abs(law.steer({.cross_track_m = left_m, .speed_mps = 0.1}).yaw_rad),
              parameters.max_approach_rad);
}

}  // namespace
}  // namespace tp100::control
