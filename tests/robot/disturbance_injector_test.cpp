#include <gtest/gtest.h>

#include "sim/robot/emulated_robot.h"

namespace tp100::sim {
namespace {

TEST(DisturbanceInjector, WaitsForARobotThatStands) {
  EmulatedRobot robot({});
  robot.reset(PowerUp::kPowerOn);
  DisturbanceInjector disturbance_injector(
      {{.at_m = 0.01, .sideways_m = 0.04, .yaw_rad = 0.2, .duration_s = 0.1}});
  for (int i = 0; i < 2000; ++i) {
    robot.advance();
    ASSERT_EQ(disturbance_injector.update(robot), nullptr);
  }
}

TEST(DisturbanceInjector, PushesAtTheStartIfTheCourseSaysSoAndOnlyOnce) {
  EmulatedRobot robot({});
  robot.reset(PowerUp::kPowerOn);
  DisturbanceInjector disturbance_injector(
      {{.at_m = 0.0, .sideways_m = 0.04, .yaw_rad = 0.0, .duration_s = 0.1}});
  int pushes = 0;
  for (int i = 0; i < 500; ++i) {
    robot.advance();
    pushes += disturbance_injector.update(robot) != nullptr ? 1 : 0;
  }
  EXPECT_EQ(pushes, 1);
  EXPECT_NEAR(robot.truth().pose.y_m, 0.04, 1e-3);
}

}  // namespace
}  // namespace tp100::sim
