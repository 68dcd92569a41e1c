#include "bridge/outer_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bridge/grounds.h"
#include "bridge/step.h"
#include "core/angle.h"
#include "core/error.h"

namespace tp100::bridge {
namespace {

constexpr HostNs kPeriod = 5 * kNsPerMs;

WorldParameters external(bool owns_pose = false) {
  return {.kind = WorldKind::kUdp, .owns_pose = owns_pose, .timeout_s = 0.1};
}

WorldSample answer(HostNs step, double pitch_rad = 0.0) {
  WorldSample said;
  said.session = 1;
  said.answered_ns = step;
  said.has_ground = true;
  said.pitch_rad = pitch_rad;
  return said;
}

TEST(Shift, TakesOnePoseToTheOtherAndAllThatMoveWithIt) {
  const Pose from{.x_m = 1.0, .y_m = 2.0, .yaw_rad = 0.5};
  const Pose to{.x_m = -0.3, .y_m = 0.4, .yaw_rad = 0.5 + kPi / 2 + 2 * kPi};
  const Shift shift = Shift::between(from, to);
  const Pose there = shift.of(from);
  EXPECT_NEAR(there.x_m, to.x_m, 1e-12);
  EXPECT_NEAR(there.y_m, to.y_m, 1e-12);
  EXPECT_NEAR(shift.turn_rad, kPi / 2, 1e-12) << "the branch of the robot's own yaw stays";
  const Pose ahead = shift.of({.x_m = 1.1, .y_m = 2.0, .yaw_rad = 0.5});
  EXPECT_NEAR(ahead.x_m, to.x_m, 1e-12);
  EXPECT_NEAR(ahead.y_m, to.y_m + 0.1, 1e-12);
}

TEST(OuterWorld, WithoutOneAllIsWell) {
  OuterWorld world(WorldParameters{}, Setup::kFlat);
  EXPECT_TRUE(world.fresh(kNsPerS));
  EXPECT_FALSE(world.lost(kNsPerS));
  EXPECT_FALSE(world.ground());
}

TEST(OuterWorld, IsFreshWhileItAnswersYoungPoses) {
  OuterWorld world(external(), Setup::kFlat);
  EXPECT_FALSE(world.fresh(0));
  world.take(answer(kNsPerS));
  world.restart(kNsPerS);
  EXPECT_FALSE(world.lost(kNsPerS + 100 * kNsPerMs));
  EXPECT_TRUE(world.lost(kNsPerS + 101 * kNsPerMs));
  // It talks, but about an old pose.
  world.take(answer(kNsPerS));
  EXPECT_TRUE(world.lost(kNsPerS + 101 * kNsPerMs));
}

TEST(OuterWorld, AnotherSessionIsAnotherWorld) {
  OuterWorld world(external(), Setup::kFlat);
  world.take(answer(kNsPerS));
  world.restart(kNsPerS);
  WorldSample anew = answer(kNsPerS + kPeriod);
  anew.session = 2;
  world.take(anew);
  EXPECT_TRUE(world.fresh(kNsPerS + kPeriod));
  EXPECT_TRUE(world.lost(kNsPerS + kPeriod));
  world.restart(kNsPerS + kPeriod);
  EXPECT_FALSE(world.lost(kNsPerS + kPeriod));
}

TEST(OuterWorld, WhoOwnsThePoseMustSayIt) {
  OuterWorld world(external(true), Setup::kFlat);
  world.take(answer(kNsPerS));
  EXPECT_FALSE(world.fresh(kNsPerS));
}

TEST(OuterWorld, APoseBelongsToTheStepThatItAnswers) {
  OuterWorld world(external(true), Setup::kFlat);
  world.restart(0);
  for (int i = 0; i < 100; ++i) world.remember(i * kPeriod, {.x_m = 0.01 * i});
  WorldSample said = answer(40 * kPeriod);
  said.has_pose = true;
  said.pose = {.x_m = 0.35, .y_m = 0.1};
  world.take(said);
  ASSERT_TRUE(world.shift());
  EXPECT_NEAR(world.shift()->x_m, -0.05, 1e-12);
  EXPECT_NEAR(world.shift()->y_m, 0.1, 1e-12);
  world.restart(100 * kPeriod);
  world.take(said);
  EXPECT_FALSE(world.shift()) << "it answers the run before";
}

TEST(OuterWorld, FilesMustShowTheRobotAtTheStartBeforeTheyAreBelieved) {
  WorldParameters files = external(true);
  files.kind = WorldKind::kFiles;
  OuterWorld world(files, Setup::kFlat);
  const auto says = [&](HostNs now, const Pose& pose) {
    world.remember(now, {.x_m = 1.0});
    WorldSample said = answer(now);
    said.has_pose = true;
    said.pose = pose;
    world.take(said);
  };
  // Before a run it may be anywhere.
  says(kNsPerS, {.x_m = 5.0});
  EXPECT_TRUE(world.fresh(kNsPerS));
  const HostNs began = kNsPerS + 50 * kNsPerMs;
  world.restart(began);
  // It has not seen yet that a run began.
  says(began + kPeriod, {.x_m = 5.0});
  says(began + 2 * kPeriod, {.x_m = 1.0, .yaw_rad = 1.0});
  EXPECT_FALSE(world.shift());
  EXPECT_TRUE(world.lost(began + 100 * kNsPerMs)) << "if it never sees it";
  says(began + 3 * kPeriod, {.x_m = 1.02, .yaw_rad = 0.01});
  EXPECT_TRUE(world.shift());
  EXPECT_FALSE(world.lost(began + 100 * kNsPerMs));
  // From now on it owns the pose.
  says(began + 4 * kPeriod, {.x_m = 1.3});
  EXPECT_NEAR(world.shift()->x_m, 0.3, 1e-12);
}

TEST(OuterWorld, OnRealTerrainItsGroundIsNotUsed) {
  OuterWorld world(external(), Setup::kTerrain);
  world.take(answer(kNsPerS, -0.3));
  EXPECT_FALSE(world.ground());
  EXPECT_TRUE(world.fresh(kNsPerS));
}

TEST(OuterWorld, SlopeStepAndSurfaceAreTheVirtualRobots) {
  OuterWorld world(external(), Setup::kBench);
  WorldSample said = answer(kNsPerS, -0.4);
  said.slip_offset = 0.1;
  world.take(said);
  EXPECT_EQ(world.ground()->obstacle, Obstacle::kRamp);
  EXPECT_DOUBLE_EQ(world.ground()->incline.slope_rad, 0.4);
  EXPECT_DOUBLE_EQ(world.ground()->incline.planar, std::cos(0.4));
  EXPECT_DOUBLE_EQ(world.ground()->incline.slip_offset, 0.1);
  said.step_height_m = 0.037;
  said.blocked = true;
  world.take(said);
  EXPECT_EQ(world.ground()->obstacle, Obstacle::kBlock);
  EXPECT_EQ(world.ground()->incline.planar, 0.0);
  for (int i = 0; i < 99; ++i) world.wait(0.005);
  EXPECT_FALSE(world.blocked());
  for (int i = 0; i < 9; ++i) world.wait(0.005);
  EXPECT_TRUE(world.blocked());
}

TEST(Grounds, AnExternalWorldSaysHowTheVirtualRobotStands) {
  Parameters parameters;
  parameters.world = external();
  parameters.model.slip_left = parameters.model.slip_right = 0.1;
  Grounds grounds(parameters, nullptr);
  OuterWorld world(parameters.world, parameters.setup);
  WorldSample said = answer(0, -20 * kRadPerDeg);
  said.height_m = 0.05;
  world.take(said);
  grounds.tell({world.ground(), world.shift()});
  Pose pose{};
  for (int i = 0; i < 200; ++i) {
    grounds.advance({.model = pose,
                     .odometry = pose,
                     .fused = pose,
                     .steering = pose,
                     .belts = {0.1, 0.1},
                     .dt_s = 0.005});
    pose.x_m += 0.09 * 0.005;
  }
  const Pose there = grounds.world(pose);
  EXPECT_EQ(there.z_m, 0.05);
  EXPECT_EQ(there.pitch_rad, -20 * kRadPerDeg);
  EXPECT_EQ(grounds.underfoot().pitch_source, PitchSource::kExternal);
  // Nine centimetres on the floor; uphill 6 % are lost to the projection and some 5 % to slip.
  EXPECT_NEAR(there.x_m, pose.x_m * 0.89, 0.002);
}

/// A step with an external world, and a robot that arms but never moves.
class WorldStep : public testing::Test {
 protected:
  WorldStep() {
    auto course = std::make_shared<course::Course>();
    course->name = "test";
    course->path = {course::Line{1.0}};
    course->fence = {-5, 5, -5, 5};
    course_ = course;
    parameters_.setup = Setup::kBench;  // no bias to wait for
    parameters_.world = external();
  }

  const Snapshot& tick(std::vector<OperatorRequest> requests = {}) {
    now_ += kPeriod;
    Sample sample;
    sample.sequence = static_cast<std::uint16_t>(now_ / kPeriod);
    sample.last_command = sample.sequence;
    sample.device_us = now_ / kNsPerUs;
    sample.measured_ns = now_;
    sample.accel_mps2[2] = 9.81;
    sample.battery_v = 7.6;
    sample.state = armed_ ? RobotState::kRunning : RobotState::kDisarmed;
    ClockState clock;
    clock.valid = true;
    if (answers_) said_.assign(1, answer(now_ - kPeriod));
    for (WorldSample& said : said_) said.stop = stop_;
    const Outputs& out = step()({.samples = std::span(&sample, 1),
                                 .requests = requests,
                                 .world = said_,
                                 .session = SessionState::kReady,
                                 .clock = clock,
                                 .session_number = 1,
                                 .answer = answer_to_request_},
                                now_);
    said_.clear();
    request_ = out.request;
    answer_to_request_ =
        request_ == RobotRequest::kNone ? RequestAnswer::kNone : RequestAnswer::kAcknowledged;
    if (request_ == RobotRequest::kArm) armed_ = true;
    if (request_ == RobotRequest::kDisarm || request_ == RobotRequest::kStop) armed_ = false;
    return out.snapshot;
  }
  RunState ticks(int count) {
    for (int i = 1; i < count; ++i) tick();
    return tick().run_state;
  }
  Step& step() {
    if (!step_) step_.emplace(parameters_, course_);
    return *step_;
  }

  Parameters parameters_{};
  std::shared_ptr<const course::Course> course_;
  std::optional<Step> step_;
  std::vector<WorldSample> said_;
  HostNs now_ = 0;
  bool armed_ = false, answers_ = true, stop_ = false;
  RobotRequest request_ = RobotRequest::kNone;
  RequestAnswer answer_to_request_ = RequestAnswer::kNone;
};

TEST_F(WorldStep, NothingBeginsBeforeTheWorldAnswers) {
  answers_ = false;
  tick({OperatorRequest::kStart});
  EXPECT_EQ(ticks(200), RunState::kArming);
  EXPECT_FALSE(armed_);
  answers_ = true;
  EXPECT_EQ(ticks(20), RunState::kRunning);
}

TEST_F(WorldStep, AWorldThatComesAfter3SBeginsNothing) {
  answers_ = false;
  EXPECT_EQ(tick().start_refusal, StartRefusal::kNoWorld);
  tick({OperatorRequest::kStart});
  EXPECT_EQ(ticks(610), RunState::kIdle);
  answers_ = true;
  EXPECT_EQ(ticks(1000), RunState::kIdle);
  EXPECT_FALSE(armed_);
}

TEST_F(WorldStep, ASilentWorldEndsTheRunWithItsCause) {
  tick({OperatorRequest::kStart});
  ASSERT_EQ(ticks(30), RunState::kRunning);
  answers_ = false;
  EXPECT_EQ(ticks(19), RunState::kRunning);
  EXPECT_EQ(ticks(3), RunState::kAborted);
  EXPECT_FALSE(armed_);
  EXPECT_EQ(tick().faults, fault_bit(Fault::world_lost));
  answers_ = true;
  EXPECT_EQ(ticks(20), RunState::kAborted) << "nothing moves before the next start";
  tick({OperatorRequest::kStart});
  EXPECT_EQ(ticks(30), RunState::kRunning);
}

TEST_F(WorldStep, ItsStopIsTheOperatorsAndHoldsWhileItSaysSo) {
  tick({OperatorRequest::kStart});
  ASSERT_EQ(ticks(30), RunState::kRunning);
  stop_ = true;
  EXPECT_EQ(tick().run_state, RunState::kAborted);
  EXPECT_EQ(request_, RobotRequest::kStop);
  EXPECT_EQ(tick().faults, fault_bit(Fault::stop_requested));
  EXPECT_EQ(request_, RobotRequest::kNone) << "once";
  EXPECT_EQ(tick({OperatorRequest::kStart}).run_state, RunState::kAborted);
  EXPECT_EQ(ticks(30), RunState::kAborted);
  stop_ = false;
  EXPECT_EQ(ticks(30), RunState::kAborted);
  tick({OperatorRequest::kStart});
  EXPECT_EQ(ticks(30), RunState::kRunning);
}

TEST_F(WorldStep, ThePoseCannotBeTheWorldsOnRealTerrain) {
  parameters_.world.owns_pose = true;
  parameters_.setup = Setup::kTerrain;
  EXPECT_THROW(step(), SetupError);
}

}  // namespace
}  // namespace tp100::bridge
