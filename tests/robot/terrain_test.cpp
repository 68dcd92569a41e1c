// Course 3, with the paper's step and ramp: really there, in the daemon's world only, or too much
// for a robot.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "runs.h"
#include "support/refusal.h"

namespace tp100::sim {
namespace {

LockstepSettings course_3(bridge::Setup setup, const std::string& robot = "end-loaded") {
  LockstepSettings run = run_of("3", robot);
  run.setup = setup;
  return run;
}

double largest_nose_up_deg(const report::RunResult& result) {
  double largest = 0.0;
  for (const report::TrajectoryPoint& point : result.points)
    largest = std::max(largest, -point.truth.pitch_rad / kRadPerDeg);
  return largest;
}

TEST(Terrain, TheBodyClimbsObstaclesThatAreThereAndNoOthers) {
  const report::RunResult climbed = run_lockstep(course_3(bridge::Setup::kTerrain));
  EXPECT_TRUE(climbed.completed) << climbed.cause;
  EXPECT_NEAR(largest_nose_up_deg(climbed), 42.0, 2.0);
  // On a flat floor they exist in the daemon's world only.
  const report::RunResult flat = run_lockstep(course_3(bridge::Setup::kFlat));
  EXPECT_TRUE(flat.completed) << flat.cause;
  EXPECT_LT(largest_nose_up_deg(flat), 0.1);
}

TEST(Terrain, AStepThatThisRobotCannotClimbIsRefusedInEverySetUp) {
  for (const bridge::Setup setup :
       {bridge::Setup::kStand, bridge::Setup::kFlat, bridge::Setup::kTerrain}) {
    LockstepSettings run = course_3(setup);
    run.robot.shape.com_height_m = 0.030;
    EXPECT_THAT(test::refusal([&] { run_lockstep(run); }), testing::HasSubstr("limit is 33.4 mm"));
  }
}

TEST(Terrain, WithTooLittleFrictionTheRobotIsImmobilisedAndTheRunStops) {
  LockstepSettings run = course_3(bridge::Setup::kTerrain);
  run.robot.emulated.body.friction = 0.6;
  // The robot slides around before it is detected as immobilised. The firmware, which has no
  // terrain data, may take this for an encoder that loses counts.
  const auto stopped = testing::AnyOf("immobilised", "stalled_left", "stalled_right");
  const report::RunResult result = run_lockstep(run);
  EXPECT_THAT(result.cause, stopped);
  EXPECT_LT(largest_nose_up_deg(result), 5.0);

  run.camera = course::EmulatedCamera{};
  run.configuration.parameters.steering = PoseSource::kFused;
  EXPECT_THAT(run_lockstep(run).cause, stopped);
}

TEST(Terrain, ThreeSecondsWithoutACameraOverTheStepLeaveThePoseWithinThreeCentimetres) {
  LockstepSettings run = course_3(bridge::Setup::kTerrain);
  run.camera = course::EmulatedCamera{};
  run.camera->blind_from_s = 29.5;
  run.camera->blind_s = 3.0;
  const report::RunResult result = run_lockstep(run);
  ASSERT_TRUE(result.completed) << result.cause;
  EXPECT_LT(max_position_error_m(result, run.course, PoseSource::kFused), 0.03);
}

}  // namespace
}  // namespace tp100::sim
