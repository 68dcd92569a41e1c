#include "bridge/step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "step_rig.h"

namespace tp100::bridge {
namespace {

TEST_F(StepTest, AChangedGainCountsFromTheNextStepAndAnotherSteeringPoseAtRestOnly) {
  const ParameterChange model{LiveParameter::kSteering, 0.0};
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  run(step, robot, 2.0);
  start(step, robot);
  while (tick(step, robot).snapshot.run_state != RunState::kRunning) {
  }
  changes_ = {{LiveParameter::kAcceleration, 0.01}, model};
  for (int i = 0; i < 99; ++i) tick(step, robot);
  EXPECT_NEAR(tick(step, robot).command.speed_mps, 0.005, 1e-3) << "after half a second";
  EXPECT_EQ(tick(step, robot).snapshot.steering, PoseSource::kOdometry);
  EXPECT_EQ(run(step, robot, 90.0), RunState::kFinished);
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
    tick(*step, robot, {OperatorRequest::kContinue});
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

TEST_F(StepTest, GoesOnNowhereBesideThePathOrAtItsEnd) {
  const auto stays = [&](Step& step, KinematicRobot& robot, RunState state) {
    EXPECT_EQ(tick(step, robot, {OperatorRequest::kContinue}).refused, StartRefusal::kOffPath);
    for (int i = 0; i < 400; ++i) {
      EXPECT_EQ(tick(step, robot).snapshot.run_state, state);
      EXPECT_FALSE(robot.armed);
    }
  };
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  run(step, robot, 1.0);
  restart_.push(step.restart_state(Pose{.x_m = -1.0}, now_));
  tick(step, robot);
  stays(step, robot, RunState::kIdle);
  tick(step, robot, {OperatorRequest::kStartPlaced});
  ASSERT_EQ(run(step, robot, 60.0), RunState::kFinished);
  for (int i = 0; i < 100; ++i) tick(step, robot);
  stays(step, robot, RunState::kFinished);
  tick(step, robot, {OperatorRequest::kStop});
  EXPECT_EQ(tick(step, robot).snapshot.faults, fault_bit(Fault::stop_requested));
  stays(step, robot, RunState::kFinished);
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

class CameraStepTest : public StepTest {
 protected:
  /// Runs one period with a camera that sees the robot shifted by `aside_m`, 60 ms late, in every
  /// sixth step.
  const Snapshot& tick_seen(Step& step, KinematicRobot& robot, double aside_m,
                            const std::vector<OperatorRequest>& requests = {}) {
    const HostNs at = now_ + kStepPeriod;
    if (++ticks_ % 6 == 0) {
      under_way_.push_back(
          {robot.x_m, robot.y_m + aside_m, robot.yaw_rad, at, static_cast<std::uint32_t>(ticks_)});
    }
    if (!under_way_.empty() && at - under_way_.front().measured_ns >= 60 * kNsPerMs) {
      camera_.push_back(under_way_.front());
      under_way_.pop_front();
    }
    return tick(step, robot, requests).snapshot;
  }

  std::deque<CameraSample> under_way_;
  int ticks_ = 0;
};

TEST_F(CameraStepTest, WhoIsMovedIsFoundByTheCameraAndByNobodyElse) {
  for (const bool stand : {false, true}) {
    parameters_.setup = stand ? Setup::kStand : Setup::kFlat;
    Step step(parameters_, course_);
    KinematicRobot robot(parameters_);
    under_way_.clear();
    for (int i = 0; i < 300; ++i) tick_seen(step, robot, 0.0);
    for (int i = 0; i < 60; ++i) tick_seen(step, robot, 0.04);
    const Snapshot& snapshot = tick_seen(step, robot, 0.04);
    EXPECT_NEAR(snapshot.estimates[PoseSource::kFused].pose.y_m, stand ? 0.0 : 0.04, 0.003);
    EXPECT_EQ(snapshot.estimates[PoseSource::kOdometry].pose.y_m, 0.0);
    EXPECT_EQ(snapshot.estimates[PoseSource::kModel].pose.y_m, 0.0);
    EXPECT_EQ(snapshot.filter.recoveries, stand ? 0u : 1u);
    EXPECT_EQ(snapshot.filter.camera_age_us < 0, stand) << "on a stand it is not looked at";
  }
}

// Odometry is off by centimetres where the camera knows the fused pose to millimetres.
TEST_F(CameraStepTest, TheFenceAllowsForTheUncertaintyOfThePoseThatSteers) {
  auto course = std::make_shared<course::Course>(*course_);
  course->fence = {-1.0, 0.6, -1.0, 1.0};
  const auto left_to_fence_m = [&](PoseSource source) {
    parameters_.steering = source;
    Step step(parameters_, course);
    KinematicRobot robot(parameters_);
    for (int i = 0; i < 300; ++i) tick_seen(step, robot, 0.0);
    const Snapshot& snapshot = tick_seen(step, robot, 0.0, {OperatorRequest::kDrive});
    for (int i = 0; i < 2400; ++i) {
      velocities_.push_back({.at_ns = now_ + kStepPeriod, .speed_mps = 0.1});
      tick_seen(step, robot, 0.0);
    }
    EXPECT_TRUE(snapshot.at_fence) << to_string(source);
    under_way_.clear();
    return course->fence.max_x_m - snapshot.world.x_m;
  };
  const double fused_m = left_to_fence_m(PoseSource::kFused);
  EXPECT_GT(fused_m, 0.01);
  EXPECT_GT(left_to_fence_m(PoseSource::kOdometry), fused_m + 0.01);
  EXPECT_GT(left_to_fence_m(PoseSource::kModel), fused_m + 0.01);
}

}  // namespace
}  // namespace tp100::bridge
