#include "bridge/step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "step_rig.h"
#include "support/alloc_count.h"

namespace tp100::bridge {
namespace {

TEST_F(StepTest, DrivesACourseToItsEndAndDisarms) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  start(step, robot);
  EXPECT_EQ(run(step, robot, 60.0), RunState::kFinished);
  EXPECT_FALSE(robot.armed);
  EXPECT_NEAR(robot.x_m, 0.8, 0.02);
  EXPECT_NEAR(robot.y_m, 0.3, 0.02);
}

TEST_F(StepTest, CommandedTrackSpeedsAreThoseThatTheRobotMakesOfTheCommand) {
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
  EXPECT_GT(moving, 500);
  EXPECT_EQ(limited, 0) << "the tracker commands more than the tracks can do";
}

TEST_F(StepTest, AChangedGainCountsFromTheNextStep) {
  const ParameterChange slow{LiveParameter::kAcceleration, 0.01};
  // Speed half a second into the run.
  const auto speed = [&](std::span<const ParameterChange> changes) {
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
  EXPECT_NEAR(speed({&slow, 1}), 0.005, 1e-3);
}

TEST_F(StepTest, TheSteeringPoseChangesOnlyAtRest) {
  const ParameterChange model{LiveParameter::kSteering, 0.0};
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  run(step, robot, 2.0);
  start(step, robot);
  while (tick(step, robot).snapshot.run_state != RunState::kRunning) {
  }
  changes_ = {&model, 1};
  EXPECT_EQ(tick(step, robot).snapshot.steering, PoseSource::kOdometry);
  EXPECT_EQ(run(step, robot, 60.0), RunState::kFinished);
  changes_ = {&model, 1};
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
  const OperatorRequest stop = OperatorRequest::kStop, go_on = OperatorRequest::kGoOn;
  int turning = 0;
  for (double share = 0.2; share < 0.95; share += 0.05) {
    auto step = std::make_unique<Step>(parameters_, course_);
    KinematicRobot robot(parameters_);
    start(*step, robot);
    ASSERT_EQ(run(*step, robot, share * took_s), RunState::kRunning);
    tick(*step, robot, std::span(&stop, 1));
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
    tick(*step, robot, std::span(&go_on, 1));
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
  const OperatorRequest go_on = OperatorRequest::kGoOn;
  const auto stays = [&](Step& step, KinematicRobot& robot, RunState state) {
    tick(step, robot, std::span(&go_on, 1));
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
  const OperatorRequest stop = OperatorRequest::kStop;
  tick(step, robot, std::span(&stop, 1));
  EXPECT_EQ(tick(step, robot).snapshot.faults, fault_bit(Fault::stop_requested));
  stays(step, robot, RunState::kFinished);
}

TEST_F(StepTest, ALostLinkEndsTheRunAndNothingMovesUntilTheNextStart) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  start(step, robot);
  ASSERT_EQ(run(step, robot, 2.0), RunState::kRunning);
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

TEST_F(StepTest, LateSamplesAreNotSteeredBy) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  tick(step, robot);
  ASSERT_TRUE(tick(step, robot).command_valid);
  ClockState clock;
  clock.valid = true;
  now_ += 100 * kNsPerMs;
  EXPECT_FALSE(step({.session = SessionState::kReady, .clock = clock, .session_number = 1}, now_)
                   .command_valid);
}

TEST_F(StepTest, SamplesThatComeTooLateOrNotAtAllEndTheRunAfter200Ms) {
  ClockState clock;
  clock.valid = true;
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
      samples_.assign(1, late);
      faults =
          step({.samples = silent ? std::span<const Sample>() : std::span<const Sample>(samples_),
                .session = SessionState::kReady,
                .clock = clock,
                .session_number = 1},
               now_)
              .snapshot.faults;
    }
    EXPECT_EQ(faults, fault_bit(silent ? Fault::link_lost : Fault::samples_stale));
    EXPECT_EQ((now_ - begun) / kNsPerMs, 205);
    const double x_m = robot.x_m;
    EXPECT_EQ(run(step, robot, 2.0), RunState::kAborted)
        << "the run continued when samples returned";
    robot.armed = false;
    EXPECT_LT(std::abs(robot.x_m - x_m), 0.01);
  }
}

TEST_F(StepTest, AHostThatPausedDoesNotBlameTheTracks) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  start(step, robot);
  ASSERT_EQ(run(step, robot, 2.0), RunState::kRunning);
  // Both tracks are at standstill for one sample, then the host pauses for longer than stall_s.
  ClockState clock;
  clock.valid = true;
  Sample sample = robot.sample(now_);
  for (const HostNs gap : {60 * kNsPerMs, 60 * kNsPerMs, 3 * kNsPerS}) {
    now_ += gap;
    ++sample.sequence;
    sample.measured_ns = now_;
    sample.device_us = now_ / kNsPerUs;
    samples_.assign(1, sample);
    EXPECT_EQ(step({.samples = samples_,
                    .session = SessionState::kReady,
                    .clock = clock,
                    .session_number = 1},
                   now_)
                  .snapshot.faults,
              0u);
  }
}

TEST_F(StepTest, TheSameInputsGiveTheSameBits) {
  const auto drive = [&] {
    now_ = 0;
    Step step(parameters_, course_);
    KinematicRobot robot(parameters_);
    start(step, robot);
    std::vector<double> poses;
    for (int i = 0; i < 2000; ++i) {
      const Snapshot& s = tick(step, robot).snapshot;
      poses.insert(poses.end(), {s.estimates[PoseSource::kModel].pose.x_m,
                                 s.estimates[PoseSource::kModel].pose.y_m,
                                 s.estimates[PoseSource::kOdometry].pose.x_m,
                                 s.estimates[PoseSource::kOdometry].pose.yaw_rad,
                                 s.command.desired_yaw_rad, s.command.speed_mps});
    }
    return poses;
  };
  const std::vector<double> a = drive(), b = drive();
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0);
}

TEST_F(StepTest, AllocatesNothing) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  start(step, robot);
  std::uint64_t calls = 0;
  bool finished = false;
  for (int i = 0; i < 6000 && !finished; ++i) {
    now_ += kStepPeriod;
    samples_[0] = robot.sample(now_);
    ClockState clock;
    clock.valid = true;
    const test::AllocCount count;
    const Outputs& out = step({.samples = samples_,
                               .session = SessionState::kReady,
                               .clock = clock,
                               .session_number = 1,
                               .answer = std::exchange(robot.answer, RequestAnswer::kNone)},
                              now_);
    calls += count.calls();
    robot.obey(out);
    finished = out.snapshot.run_state == RunState::kFinished;
  }
  EXPECT_TRUE(finished);
  EXPECT_EQ(calls, 0u);
}

TEST_F(StepTest, TheImuTellsTheSlopeOfTheRealBody) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  ClockState clock;
  clock.valid = true;
  const Snapshot* snapshot = nullptr;
  for (int i = 0; i < 600; ++i) {
    now_ += kStepPeriod;
    samples_[0] = robot.sample(now_);
    if (i >= 200) {
      const double nose_up = std::min(i - 200, 280) * 0.1 * kRadPerDeg;
      samples_[0].accel_mps2 = {9.81 * std::sin(nose_up), 0.0, 9.81 * std::cos(nose_up)};
      samples_[0].gyro_radps[1] = i < 480 ? -20.0 * kRadPerDeg : 0.0;
    }
    snapshot = &step({.samples = samples_,
                      .session = SessionState::kReady,
                      .clock = clock,
                      .session_number = 1},
                     now_)
                    .snapshot;
    if (i == 199) {
      EXPECT_EQ(snapshot->imu_slope, Slope::kFlat);
      EXPECT_NEAR(snapshot->imu_pitch_rad, 0.0, 1e-6);
    }
  }
  EXPECT_EQ(snapshot->imu_slope, Slope::kUp);
  EXPECT_NEAR(snapshot->imu_pitch_rad, -28.0 * kRadPerDeg, 1.5 * kRadPerDeg);
}

TEST_F(StepTest, TheCounterOfTheTestAboveCounts) {
  if (!test::counting()) return;
  const test::AllocCount count;
  const auto block = std::make_unique<std::vector<int>>(100);
  EXPECT_GE(count.calls(), 2u);
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
