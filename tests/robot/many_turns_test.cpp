// A robot that turns on and on, in lockstep: its yaw is never wrapped.
#include <gtest/gtest.h>

#include <memory>

#include "hand_driven.h"
#include "sim/robot/lockstep.h"

namespace tp100::sim {
namespace {

constexpr std::uint32_t kTurner = 1;

/// Drives by hand for so long, turning at `rate_radps`; returns how far the robot has turned.
double turn(HandDriven& drive, double rate_radps, double duration_s) {
  EXPECT_TRUE(drive.wait_until_ready());
  const std::string token = drive.take(kTurner);
  EXPECT_EQ(drive.state(), RunState::kDriving) << token;
  const double from_rad = drive.robot().truth().pose.yaw_rad;
  const HostNs end = drive.now() + from_s(duration_s);
  drive.before_step = [&](HostNs) { drive.drive(kTurner, token, 0.0, rate_radps); };
  drive.step_until([&] { return drive.state() != RunState::kDriving || drive.now() > end; },
                   duration_s + 1.0);
  EXPECT_EQ(drive.state(), RunState::kDriving) << "after " << to_s(drive.now()) << " s";
  drive.before_step = {};
  drive.call(kTurner, "drive_release", {{"token", token}});
  drive.step_for(0.5);
  return drive.robot().truth().pose.yaw_rad - from_rad;
}

// Nav2 turns a robot for hours; it would stop for ever after 159 turns one way.
TEST(Turns, ARobotThatHasTurnedOftenIsDrivenAsEver) {
  auto course = std::make_shared<course::Course>(load_course("1-straight"));
  for (const double yaw_rad : {0.0, 98.0, 998.0, 5e4}) {
    for (const double sign : {-1.0, 1.0}) {
      course->start.yaw_rad = sign * yaw_rad;
      HandDriven drive({.loaded = load({}), .course = course});
      EXPECT_NEAR(turn(drive, sign * 0.8, 6.0), sign * 4.5, 0.5) << sign * yaw_rad;
    }
  }
}

TEST(ManyTurns, TwoHundredByHand) {
  HandDriven drive({.loaded = load({})});
  double turned_rad = 0.0;
  while (turned_rad < 2.0 * kPi * 200.0) turned_rad += turn(drive, 1.0, 300.0);
  EXPECT_EQ(drive.record().snapshot.faults, 0U);
}

TEST(ManyTurns, ACourseOfSixteenTimesTen) {
  LockstepSettings run{.course = load_course("1-straight")};
  const Loaded loaded = load({});
  run.robot = loaded.robot;
  run.configuration = loaded.configuration;
  run.course.path.assign(16, course::Pivot{20.0 * kPi});
  run.course.terrain = {};
  run.course.fence = {-1.0, 1.0, -1.0, 1.0};
  const report::RunResult result = run_lockstep(run);
  EXPECT_TRUE(result.completed) << result.cause;
}

}  // namespace
}  // namespace tp100::sim
