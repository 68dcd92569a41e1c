// Starts that a step refuses, and states of the robot that end a run.
#include <gtest/gtest.h>

#include <functional>

#include "core/error.h"
#include "step_rig.h"

namespace tp100::bridge {
namespace {

TEST_F(StepTest, NothingMovesWithoutAStartAndWhoIsArmedIsStopped) {
  for (const bool with_course : {true, false}) {
    Step step(parameters_, with_course ? course_ : nullptr);
    KinematicRobot robot(parameters_);
    robot.armed = true;
    EXPECT_EQ(run(step, robot, 0.2), RunState::kAborted);
    EXPECT_FALSE(robot.armed);
    EXPECT_EQ(tick(step, robot).snapshot.faults, fault_bit(Fault::moves_unasked));
    run(step, robot, 5.0);
    EXPECT_EQ(robot.x_m, 0.0);
    EXPECT_NEAR(robot.yaw_rad, 0.0, 1e-9);
  }
}

TEST_F(StepTest, SaysBeforehandWhyAStartWouldBeRefusedAndRefusesItForThat) {
  struct Case {
    StartRefusal why;
    std::function<void(KinematicRobot&)> oddity;
  };
  const Case cases[] = {
      {StartRefusal::kTilted, [](KinematicRobot& robot) { robot.upside_down = true; }},
      {StartRefusal::kNoImu, [](KinematicRobot& robot) { robot.imu_age = 255; }},
      {StartRefusal::kUnknownFault, [](KinematicRobot& robot) { robot.faults = 1U << 14; }},
      {StartRefusal::kNoSession, [this](KinematicRobot&) { connected_ = false; }},
  };
  for (const Case& each : cases) {
    SCOPED_TRACE(static_cast<int>(each.why));
    Step step(parameters_, course_);
    KinematicRobot robot(parameters_);
    run(step, robot, 1.0);
    EXPECT_EQ(tick(step, robot).snapshot.start_refusal, StartRefusal::kNone);
    each.oddity(robot);
    for (int i = 0; i < 20; ++i) tick(step, robot);
    EXPECT_EQ(tick(step, robot).snapshot.start_refusal, each.why);
    start(step, robot);
    StartRefusal refused = StartRefusal::kNone;
    for (int i = 0; i < 700; ++i) {
      const Outputs& out = tick(step, robot);
      ASSERT_EQ(out.request, RobotRequest::kNone);
      if (out.refused != StartRefusal::kNone) refused = out.refused;
    }
    EXPECT_EQ(refused, each.why);
    robot.upside_down = false;
    robot.imu_age = 0;
    robot.faults = 0;
    connected_ = true;
    EXPECT_EQ(run(step, robot, 5.0), RunState::kIdle)
        << "a refused start must not take effect later";
  }
}

// A start may arrive after the course was given up.
TEST_F(StepTest, AStartWithoutACourseIsRefusedAndMovesNothing) {
  Step step(parameters_, nullptr);
  KinematicRobot robot(parameters_);
  run(step, robot, 1.0);
  EXPECT_EQ(tick(step, robot).snapshot.start_refusal, StartRefusal::kNoCourse);
  EXPECT_EQ(tick(step, robot, {OperatorRequest::kContinue}).refused, StartRefusal::kNoCourse);
  EXPECT_EQ(tick(step, robot, {OperatorRequest::kStart}).refused, StartRefusal::kNoCourse);
  EXPECT_EQ(run(step, robot, 5.0), RunState::kIdle);
  EXPECT_FALSE(robot.armed);
  tick(step, robot, {OperatorRequest::kDrive});
  for (int i = 0; i < 40; ++i) tick(step, robot);
  EXPECT_EQ(tick(step, robot).snapshot.run_state, RunState::kDriving) << "by hand it drives";
}

TEST_F(StepTest, AnImuThatSaysItIsSilentEndsTheRunUnlessTheGyroDoesNotSteer) {
  for (const bool stand : {false, true}) {
    parameters_.setup = stand ? Setup::kStand : Setup::kFlat;
    Step step(parameters_, course_);
    KinematicRobot robot(parameters_);
    begin(step, robot);
    robot.imu_age = 255;
    EXPECT_EQ(run(step, robot, 0.1), stand ? RunState::kRunning : RunState::kAborted);
    EXPECT_EQ(tick(step, robot).snapshot.faults, stand ? 0u : fault_bit(Fault::imu_stale));
  }
}

TEST_F(StepTest, AFaultBitThatNobodyKnowsEndsTheRun) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  begin(step, robot);
  robot.faults = FaultMask{1} << 14;
  EXPECT_EQ(run(step, robot, 0.1), RunState::kAborted);
  EXPECT_FALSE(robot.armed);
}

TEST_F(StepTest, WaitsForTheGyroBiasBeforeItArms) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  EXPECT_EQ(tick(step, robot).snapshot.start_refusal, StartRefusal::kNotStill);
  start(step, robot);
  for (int i = 0; i < 80; ++i) ASSERT_EQ(tick(step, robot).request, RobotRequest::kNone);
  EXPECT_EQ(run(step, robot, 1.0), RunState::kRunning);
  EXPECT_EQ(tick(step, robot).snapshot.start_refusal, StartRefusal::kUnderWay);
}

TEST_F(StepTest, OnAStandTheGyroNeitherSteersNorHoldsUpTheStart) {
  parameters_.setup = Setup::kStand;
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  start(step, robot);
  EXPECT_EQ(run(step, robot, 60.0), RunState::kFinished);
  EXPECT_NEAR(robot.x_m, 0.8, 0.02);
}

TEST_F(StepTest, ACourseFasterThanTheRobotIsRefused) {
  auto fast = std::make_shared<course::Course>(*course_);
  fast->speed_mps = 0.25;
  EXPECT_THROW(Step(parameters_, fast), UserError);
}

}  // namespace
}  // namespace tp100::bridge
