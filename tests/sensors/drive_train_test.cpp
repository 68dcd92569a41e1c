// Motors, battery and body together: the robot's response to the firmware's duties.

#include "sim/sensors/drive_train.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/body/ode_body.h"

namespace tp100::sim {
namespace {

struct DriveTrain {
  explicit DriveTrain(const course::EmulatedMotor& motor = {})
      : left(motor, 1.0), right(motor, 1.0) {}

  void run(double left_duty, double right_duty, int steps) {
    for (int i = 0; i < steps; ++i) {
      left.step(left_duty, battery.volts(), body.state().left_load_n);
      right.step(right_duty, battery.volts(), body.state().right_load_n);
      battery.step(std::abs(left.force_n()) + std::abs(right.force_n()));
      body.step(left.track_mps(), right.track_mps());
    }
  }

  OdeBody body{{}, {}, false};
  Battery battery{{}};
  Motor left, right;
};

TEST(DriveTrain, TopTrackSpeedIsThatOfTheRealKind) {
  DriveTrain robot;
  robot.run(1.0, 1.0, 1500);
  EXPECT_GT(robot.left.track_mps(), 0.14);
  EXPECT_LT(robot.left.track_mps(), 0.30);
  EXPECT_NEAR(robot.body.state().velocity_mps[0], 0.84 * robot.left.track_mps(), 1e-3);
}

TEST(DriveTrain, ASpinTakesBothMotorsAndSagsTheBattery) {
  DriveTrain robot;
  robot.run(0.0, 0.0, 1);
  const double rested_v = robot.battery.volts();
  robot.run(-1.0, 1.0, 1500);
  EXPECT_GT(robot.right.track_mps(), 0.15);
  EXPECT_GT(robot.right.force_n(), 3.0);
  EXPECT_LT(robot.battery.volts(), rested_v - 0.05);
}

TEST(DriveTrain, BelowTheDeadBandNothingMoves) {
  DriveTrain robot;
  robot.run(0.06, -0.06, 1000);
  EXPECT_EQ(robot.left.track_mps(), 0.0);
  EXPECT_NEAR(robot.body.state().pose.yaw_rad, 0.0, 1e-6);
}

TEST(DriveTrain, AQuickMotorDoesNotFightTheBody) {
  course::EmulatedMotor quick;
  quick.lag_s = 0.005;
  DriveTrain robot(quick);
  robot.run(-0.6, 0.6, 1000);
  const double settled = robot.right.track_mps();
  for (int i = 0; i < 200; ++i) {
    robot.run(-0.6, 0.6, 1);
    ASSERT_NEAR(robot.right.track_mps(), settled, 1e-4);
  }
}

}  // namespace
}  // namespace tp100::sim
