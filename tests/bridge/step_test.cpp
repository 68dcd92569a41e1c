#include "bridge/step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "step_rig.h"

namespace tp100::bridge {
namespace {

TEST_F(StepTest, DrivesACourseToItsEndWithTrackSpeedsThatTheRobotMakesOfItsCommands) {
  parameters_.drive.max_track_mps = 0.14;
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  start(step, robot);
  const model::TrackParameters& model = parameters_.model;
  int moving = 0, limited = 0;
  RunState state = RunState::kIdle;
  while (state != RunState::kFinished && state != RunState::kAborted) {
    const Outputs& out = tick(step, robot);
    state = out.snapshot.run_state;
    const double left_mps = out.snapshot.commanded_left_mps;
    const double right_mps = out.snapshot.commanded_right_mps;
    ASSERT_LE(std::max(std::abs(left_mps), std::abs(right_mps)), 0.14 + 1e-12);
    const double turn_radps =
        (right_mps * (1.0 - model.slip_right) - left_mps * (1.0 - model.slip_left)) /
        model.wheelbase_m;
    // The requested turn has priority over the speed.
    ASSERT_NEAR(turn_radps, robot.rate_radps(), 1e-9) << to_s(now_);
    const double speed_mps =
        (right_mps * (1.0 - model.slip_right) + left_mps * (1.0 - model.slip_left)) / 2.0;
    moving += speed_mps > 0.05 ? 1 : 0;
    limited += std::abs(speed_mps - out.command.speed_mps) > 1e-9 ? 1 : 0;
  }
  EXPECT_EQ(state, RunState::kFinished);
  EXPECT_FALSE(robot.armed);
  EXPECT_NEAR(robot.x_m, 0.8, 0.02);
  EXPECT_NEAR(robot.y_m, 0.3, 0.02);
  for (const PoseSource source : kPoseSources) {
    const PlanarCovariance& of = tick(step, robot).snapshot.estimates[source].covariance;
    EXPECT_GT(std::sqrt(of.xx), 0.012) << to_string(source) << ": the way makes it uncertain";
    EXPECT_LT(std::sqrt(of.xx), 0.2) << to_string(source);
  }
  EXPECT_GT(moving, 500);
  EXPECT_EQ(limited, 0) << "the tracker commands more than the tracks can do";
}

TEST_F(StepTest, AChangedGainCountsFromTheNextStep) {
  const ParameterChange slow{LiveParameter::kAcceleration, 0.01};
  // Speed half a second into the run.
  const auto speed = [&](const std::vector<ParameterChange>& changes) {
    Step step(parameters_, course_);
    KinematicRobot robot(parameters_);
    run(step, robot, 2.0);
    start(step, robot);
    while (tick(step, robot).snapshot.run_state != RunState::kRunning) {
    }
    changes_ = changes;
    double mps = 0.0;
    for (int i = 0; i < 100; ++i) mps = tick(step, robot).command.speed_mps;
    return mps;
  };
  EXPECT_GT(speed({}), 0.05);
  EXPECT_NEAR(speed({slow}), 0.005, 1e-3);
}

TEST_F(StepTest, TheSteeringPoseChangesOnlyAtRest) {
  const ParameterChange model{LiveParameter::kSteering, 0.0};
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  run(step, robot, 2.0);
  start(step, robot);
  while (tick(step, robot).snapshot.run_state != RunState::kRunning) {
  }
  changes_ = {model};
  EXPECT_EQ(tick(step, robot).snapshot.steering, PoseSource::kOdometry);
  EXPECT_EQ(run(step, robot, 60.0), RunState::kFinished);
  changes_ = {model};
  const Outputs& out = tick(step, robot);
  EXPECT_EQ(out.snapshot.steering, PoseSource::kModel);
  EXPECT_EQ(out.command.pose.x_m, out.snapshot.estimates[PoseSource::kModel].pose.x_m);
}

// On the first line, on the arc, in the middle of the turn on the spot and on the last line.
TEST_F(StepTest, GoesOnFromWhereARunWasStopped) {
  KinematicRobot whole(parameters_);
  Step undisturbed(parameters_, course_);
  start(undisturbed, whole);
  ASSERT_EQ(run(undisturbed, whole, 60.0), RunState::kFinished);
  const double took_s = to_s(now_);
  int turning = 0;
  for (double share = 0.2; share < 0.95; share += 0.05) {
    auto step = std::make_unique<Step>(parameters_, course_);
    KinematicRobot robot(parameters_);
    start(*step, robot);
    ASSERT_EQ(run(*step, robot, share * took_s), RunState::kRunning);
    tick(*step, robot, {OperatorRequest::kStop});
    run(*step, robot, 1.0);
    for (int i = 0; i < 100; ++i) tick(*step, robot);
    ASSERT_FALSE(robot.armed) << "nothing goes on by itself";
    const Snapshot stopped = tick(*step, robot).snapshot;
    ASSERT_EQ(stopped.run_state, RunState::kAborted);
    if (stopped.world.yaw_rad > 0.3 && stopped.world.yaw_rad < 1.2 && stopped.progress_m > 0.7)
      ++turning;
    if (share > 0.5) {
      // Like a restart of the step at rest, with only its carried state.
      const CarriedState carried = step->carried();
      step = std::make_unique<Step>(parameters_, course_);
      restart_.push(carried);
    }
    tick(*step, robot, {OperatorRequest::kGoOn});
    double least_m = 1e9;
    RunState state = RunState::kArming;
    while (state == RunState::kArming || state == RunState::kRunning) {
      const Snapshot& snapshot = tick(*step, robot).snapshot;
      state = snapshot.run_state;
      if (state == RunState::kRunning) least_m = std::min(least_m, snapshot.progress_m);
    }
    EXPECT_EQ(state, RunState::kFinished) << share << " " << stopped.progress_m;
    EXPECT_GE(least_m, stopped.progress_m - 1e-3) << share;
    EXPECT_NEAR(robot.x_m, whole.x_m, 0.02) << share;
    EXPECT_NEAR(robot.y_m, whole.y_m, 0.02) << share;
    EXPECT_NEAR(wrap_angle(robot.yaw_rad - whole.yaw_rad), 0.0, 0.05) << share;
  }
  EXPECT_GE(turning, 1);
}

TEST_F(StepTest, GoesOnFromNowhereElse) {
  const auto stays = [&](Step& step, KinematicRobot& robot, RunState state) {
    tick(step, robot, {OperatorRequest::kGoOn});
    for (int i = 0; i < 400; ++i) {
      EXPECT_EQ(tick(step, robot).snapshot.run_state, state);
      EXPECT_FALSE(robot.armed);
    }
  };
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  run(step, robot, 1.0);
  stays(step, robot, RunState::kIdle);
  start(step, robot);
  ASSERT_EQ(run(step, robot, 60.0), RunState::kFinished);
  for (int i = 0; i < 100; ++i) tick(step, robot);
  stays(step, robot, RunState::kFinished);
  tick(step, robot, {OperatorRequest::kStop});
  EXPECT_EQ(tick(step, robot).snapshot.faults, fault_bit(Fault::stop_requested));
  stays(step, robot, RunState::kFinished);
}

TEST_F(StepTest, ALostLinkEndsTheRunAndNothingMovesUntilTheNextStart) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  begin(step, robot);
  connected_ = false;
  EXPECT_FALSE(tick(step, robot).command_valid);
  EXPECT_EQ(tick(step, robot).snapshot.run_state, RunState::kAborted);
  connected_ = true;
  ++session_;
  const double x_m = robot.x_m;
  run(step, robot, 2.0);
  EXPECT_EQ(robot.x_m, x_m);
  start(step, robot);
  EXPECT_EQ(run(step, robot, 1.0), RunState::kRunning);
}

// After a reboot its counts begin at 0.
TEST_F(StepTest, CountsOfANewSessionAreNoMotion) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  begin(step, robot);
  tick(step, robot, {OperatorRequest::kStop});
  run(step, robot, 1.0);
  const double x_m = tick(step, robot).snapshot.estimates[PoseSource::kOdometry].pose.x_m;
  EXPECT_GT(x_m, 0.05);
  KinematicRobot rebooted(parameters_);
  ++session_;
  for (int i = 0; i < 20; ++i) tick(step, rebooted);
  const PerSource<Estimate>& estimates = tick(step, rebooted).snapshot.estimates;
  EXPECT_NEAR(estimates[PoseSource::kOdometry].pose.x_m, x_m, 1e-3);
  EXPECT_NEAR(estimates[PoseSource::kFused].pose.x_m, x_m, 1e-2);
}

// On a flat floor a virtual ramp holds the virtual robot back.
TEST_F(StepTest, ASecondStartForgetsWhatTheVirtualRobotWasBehind) {
  auto course = std::make_shared<course::Course>(*course_);
  course->path = {course::Line{1.2}};
  course->terrain.ramps.push_back(
      {{0.5, 0.0, 0.0}, 0.08, 28 * kRadPerDeg, 0.2, 28 * kRadPerDeg, 0.4});
  Step step(parameters_, course);
  KinematicRobot robot(parameters_);
  const auto behind_m = [](const Snapshot& snapshot) {
    return snapshot.estimates[PoseSource::kOdometry].pose.x_m - snapshot.world.x_m;
  };
  start(step, robot);
  ASSERT_EQ(run(step, robot, 60.0), RunState::kFinished);
  for (int i = 0; i < 100; ++i) tick(step, robot);
  EXPECT_GT(behind_m(tick(step, robot).snapshot), 0.03);
  start(step, robot);
  ASSERT_EQ(run(step, robot, 0.5), RunState::kRunning);
  const Snapshot& snapshot = tick(step, robot).snapshot;
  EXPECT_NEAR(behind_m(snapshot), 0.0, 1e-6);
  EXPECT_LT(snapshot.world.x_m, 0.2);
}

TEST_F(StepTest, SamplesThatComeTooLateOrNotAtAllEndTheRunAfter200Ms) {
  for (const bool silent : {true, false}) {
    Step step(parameters_, course_);
    KinematicRobot robot(parameters_);
    begin(step, robot);
    const Sample late = robot.sample(now_);
    const HostNs begun = now_;
    FaultMask faults = 0;
    while (faults == 0 && now_ - begun < kNsPerS) {
      now_ += kStepPeriod;
      // The same late sample arrives in every step.
      const Outputs& out = step_with(step, std::span(&late, silent ? 0 : 1));
      EXPECT_EQ(out.command_valid, now_ - begun <= from_s(parameters_.max_sample_age_s));
      faults = out.snapshot.faults;
    }
    EXPECT_EQ(faults, fault_bit(silent ? Fault::link_lost : Fault::samples_stale));
    EXPECT_EQ((now_ - begun) / kNsPerMs, 205);
    const double x_m = robot.x_m;
    EXPECT_EQ(run(step, robot, 2.0), RunState::kAborted)
        << "the run continued when samples returned";
    EXPECT_LT(std::abs(robot.x_m - x_m), 0.01);
  }
}

TEST_F(StepTest, AHostThatPausedDoesNotBlameTheTracks) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  begin(step, robot);
  // Both tracks are at standstill for one sample, then the host pauses for longer than stall_s.
  Sample sample = robot.sample(now_);
  for (const HostNs gap : {60 * kNsPerMs, 60 * kNsPerMs, 3 * kNsPerS}) {
    now_ += gap;
    ++sample.sequence;
    sample.measured_ns = now_;
    sample.device_us = now_ / kNsPerUs;
    EXPECT_EQ(step_with(step, std::span(&sample, 1)).snapshot.faults, 0u);
  }
}

TEST_F(StepTest, TheImuTellsTheSlopeOfTheRealBody) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  const Snapshot* snapshot = nullptr;
  for (int i = 0; i < 600; ++i) {
    now_ += kStepPeriod;
    Sample sample = robot.sample(now_);
    if (i >= 200) {
      const double nose_up = std::min(i - 200, 280) * 0.1 * kRadPerDeg;
      sample.accel_mps2 = {9.81 * std::sin(nose_up), 0.0, 9.81 * std::cos(nose_up)};
      sample.gyro_radps[1] = i < 480 ? -20.0 * kRadPerDeg : 0.0;
    }
    snapshot = &step_with(step, std::span(&sample, 1)).snapshot;
    if (i == 199) {
      EXPECT_EQ(snapshot->imu_slope, Slope::kFlat);
      EXPECT_NEAR(snapshot->imu_pitch_rad, 0.0, 1e-6);
    }
  }
  EXPECT_EQ(snapshot->imu_slope, Slope::kUp);
  EXPECT_NEAR(snapshot->imu_pitch_rad, -28.0 * kRadPerDeg, 1.5 * kRadPerDeg);
}

TEST_F(StepTest, PaperModeUsesThePrintedConstantsWhateverTheRobotSays) {
  parameters_.paper_model = true;
  parameters_.model.slip_left = parameters_.model.slip_right = 0.5;
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  const Snapshot& snapshot = tick(step, robot).snapshot;
  tick(step, robot);
  EXPECT_DOUBLE_EQ(snapshot.slip_left, 0.1);
  EXPECT_DOUBLE_EQ(snapshot.slip_right, 0.1188);
}

}  // namespace
}  // namespace tp100::bridge
