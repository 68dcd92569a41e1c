#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/arithmetic.h"
#include "core/error.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"

namespace tp100::sim {
namespace {

LockstepSettings course_3(bridge::Setup setup) {
  const Loaded loaded = load({});
  LockstepSettings settings;
  settings.course = load_course("3");
  settings.robot = loaded.robot;
  settings.configuration = loaded.configuration;
  settings.setup = setup;
  return settings;
}

double largest_nose_up_deg(const report::RunResult& result) {
  double largest = 0.0;
  for (const report::TrajectoryPoint& point : result.points)
    largest = std::max(largest, -point.truth.pitch_rad / kRadPerDeg);
  return largest;
}

TEST(Terrain, OnTerrainTheBodyClimbsStepAndRamp) {
  const report::RunResult result = run_lockstep(course_3(bridge::Setup::kTerrain));
  EXPECT_TRUE(result.completed) << result.cause;
  EXPECT_NEAR(largest_nose_up_deg(result), 42.0, 2.0);
}

TEST(Terrain, OnAFlatFloorTheObstaclesExistInTheDaemonsWorldOnly) {
  const report::RunResult result = run_lockstep(course_3(bridge::Setup::kFlat));
  EXPECT_TRUE(result.completed) << result.cause;
  EXPECT_LT(largest_nose_up_deg(result), 0.1);
}

TEST(Terrain, OnAStandTheCourseIsCompletedToo) {
  const report::RunResult result = run_lockstep(course_3(bridge::Setup::kStand));
  EXPECT_TRUE(result.completed) << result.cause;
}

TEST(Terrain, AStepThatThisRobotCannotClimbIsRefusedInEverySetUp) {
  for (const bridge::Setup setup :
       {bridge::Setup::kStand, bridge::Setup::kFlat, bridge::Setup::kTerrain}) {
    LockstepSettings settings = course_3(setup);
    settings.robot.shape.com_height_m = 0.030;
    try {
      run_lockstep(settings);
      FAIL() << "the step must be refused";
    } catch (const SetupError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("limit is 33.4 mm"));
    }
  }
}

TEST(Terrain, WithTooLittleFrictionTheRobotIsImmobilisedAndTheRunStops) {
  LockstepSettings settings = course_3(bridge::Setup::kTerrain);
  settings.robot.emulated.body.friction = 0.6;
  // The robot slides around before it is detected as immobilised. The firmware, which has no
  // terrain data, may take this for an encoder that loses counts.
  const auto stopped = testing::AnyOf("immobilised", "stalled_left", "stalled_right");
  const report::RunResult result = run_lockstep(settings);
  EXPECT_FALSE(result.completed);
  EXPECT_THAT(result.cause, stopped);
  EXPECT_LT(largest_nose_up_deg(result), 5.0);

  settings.camera = course::EmulatedCamera{};
  settings.configuration.parameters.steering = PoseSource::kFused;
  EXPECT_THAT(run_lockstep(settings).cause, stopped);
}

TEST(Terrain, ThreeSecondsWithoutACameraOverTheStepLeaveThePoseWithinThreeCentimetres) {
  LockstepSettings settings = course_3(bridge::Setup::kTerrain);
  settings.camera = course::EmulatedCamera{};
  settings.camera->blind_from_s = 29.5;
  settings.camera->blind_s = 3.0;
  const report::RunResult result = run_lockstep(settings);
  ASSERT_TRUE(result.completed) << result.cause;
  double largest_m = 0.0;
  for (const report::TrajectoryPoint& point : result.points)
    largest_m =
        std::max(largest_m, std::hypot(point.estimates[PoseSource::kFused].x_m - point.truth.x_m,
                                       point.estimates[PoseSource::kFused].y_m - point.truth.y_m));
  EXPECT_LT(largest_m, 0.03);
}

class OtherRobots : public testing::TestWithParam<const char*> {};

TEST_P(OtherRobots, DriveCurvesAndSharpTurns) {
  Options options;
  options.robot = GetParam();
  const Loaded loaded = load(options);
  for (const char* course : {"1-curve", "1-sharp"}) {
    SCOPED_TRACE(course);
    LockstepSettings settings;
    settings.course = load_course(course);
    settings.robot = loaded.robot;
    settings.configuration = loaded.configuration;
    const report::RunResult result = run_lockstep(settings);
    EXPECT_TRUE(result.completed) << result.cause;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, OtherRobots, testing::Values("front-heavy", "slippery", "large"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(OtherRobotsOnTerrain, TheClimbersCrossStepAndRampAndTheOthersAreRefused) {
  for (const char* name : {"uniform", "front-heavy", "large"}) {
    Options options;
    options.robot = name;
    LockstepSettings settings = course_3(bridge::Setup::kTerrain);
    settings.robot = load(options).robot;
    const report::RunResult result = run_lockstep(settings);
    EXPECT_TRUE(result.completed) << name << ": " << result.cause;
  }
  Options options;
  options.robot = "slippery";
  LockstepSettings settings = course_3(bridge::Setup::kTerrain);
  settings.robot = load(options).robot;
  EXPECT_THROW(run_lockstep(settings), SetupError);
}

}  // namespace
}  // namespace tp100::sim
