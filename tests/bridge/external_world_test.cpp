#include "bridge/external_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bridge/step.h"
#include "bridge/terrain_contacts.h"
#include "core/arithmetic.h"
#include "core/error.h"

namespace tp100::bridge {
namespace {

constexpr HostNs kPeriod = 5 * kNsPerMs;

WorldParameters external(bool owns_pose = false) {
  return {.kind = WorldKind::kUdp, .owns_pose = owns_pose, .timeout_s = 0.1};
}

WorldSample answer(HostNs step, double pitch_rad = 0.0) {
  WorldSample received;
  received.session = 1;
  received.answered_ns = step;
  received.has_ground = true;
  received.pitch_rad = pitch_rad;
  return received;
}

TEST(ExternalWorld, WithoutOneAllIsWell) {
  ExternalWorld world(WorldParameters{}, Setup::kFlat);
  EXPECT_TRUE(world.fresh(kNsPerS));
  EXPECT_FALSE(world.lost(kNsPerS));
  EXPECT_FALSE(world.ground());
}

TEST(ExternalWorld, IsFreshWhileItAnswersYoungPoses) {
  ExternalWorld world(external(), Setup::kFlat);
  EXPECT_FALSE(world.fresh(0));
  world.take(answer(kNsPerS));
  world.restart(kNsPerS);
  EXPECT_FALSE(world.lost(kNsPerS + 100 * kNsPerMs));
  EXPECT_TRUE(world.lost(kNsPerS + 101 * kNsPerMs));
  // The world answers, but for an old pose.
  world.take(answer(kNsPerS));
  EXPECT_TRUE(world.lost(kNsPerS + 101 * kNsPerMs));
}

TEST(ExternalWorld, AnotherSessionIsAnotherWorld) {
  ExternalWorld world(external(), Setup::kFlat);
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

TEST(ExternalWorld, WhoOwnsThePoseMustSayIt) {
  ExternalWorld world(external(true), Setup::kFlat);
  world.take(answer(kNsPerS));
  EXPECT_FALSE(world.fresh(kNsPerS));
}

TEST(ExternalWorld, APoseBelongsToTheStepThatItAnswers) {
  ExternalWorld world(external(true), Setup::kFlat);
  world.restart(0);
  for (int i = 0; i < 100; ++i) world.remember(i * kPeriod, {.x_m = 0.01 * i});
  WorldSample received = answer(40 * kPeriod);
  received.has_pose = true;
  received.pose = {.x_m = 0.35, .y_m = 0.1};
  world.take(received);
  ASSERT_TRUE(world.transform());
  EXPECT_NEAR(world.transform()->x_m, -0.05, 1e-12);
  EXPECT_NEAR(world.transform()->y_m, 0.1, 1e-12);
  world.restart(100 * kPeriod);
  world.take(received);
  EXPECT_FALSE(world.transform()) << "the sample answers the previous run";
}

TEST(ExternalWorld, FilesMustShowTheRobotAtTheStartBeforeTheyAreAccepted) {
  WorldParameters files = external(true);
  files.kind = WorldKind::kFiles;
  ExternalWorld world(files, Setup::kFlat);
  const auto says = [&](HostNs now, const Pose& pose) {
    world.remember(now, {.x_m = 1.0});
    WorldSample received = answer(now);
    received.has_pose = true;
    received.pose = pose;
    world.take(received);
  };
  // Before a run the robot may be anywhere in the world.
  says(kNsPerS, {.x_m = 5.0});
  EXPECT_TRUE(world.fresh(kNsPerS));
  const HostNs began = kNsPerS + 50 * kNsPerMs;
  world.restart(began);
  // The world does not yet show that a run has begun.
  says(began + kPeriod, {.x_m = 5.0});
  says(began + 2 * kPeriod, {.x_m = 1.0, .yaw_rad = 1.0});
  EXPECT_FALSE(world.transform());
  EXPECT_TRUE(world.lost(began + 100 * kNsPerMs)) << "the world never showed the start";
  says(began + 3 * kPeriod, {.x_m = 1.02, .yaw_rad = 0.01});
  EXPECT_TRUE(world.transform());
  EXPECT_FALSE(world.lost(began + 100 * kNsPerMs));
  // From now on the world owns the pose.
  says(began + 4 * kPeriod, {.x_m = 1.3});
  EXPECT_NEAR(world.transform()->x_m, 0.3, 1e-12);
}

TEST(ExternalWorld, OnRealTerrainItsGroundIsNotUsed) {
  ExternalWorld world(external(), Setup::kTerrain);
  world.take(answer(kNsPerS, -0.3));
  EXPECT_FALSE(world.ground());
  EXPECT_TRUE(world.fresh(kNsPerS));
}

TEST(ExternalWorld, SlopeStepAndSurfaceAreTheVirtualRobots) {
  ExternalWorld world(external(), Setup::kStand);
  WorldSample received = answer(kNsPerS, -0.4);
  received.slip_offset = 0.1;
  world.take(received);
  EXPECT_EQ(world.ground()->obstacle, ObstacleClass::kRamp);
  EXPECT_DOUBLE_EQ(world.ground()->incline.slope_rad, 0.4);
  EXPECT_DOUBLE_EQ(world.ground()->incline.horizontal_fraction, std::cos(0.4));
  EXPECT_DOUBLE_EQ(world.ground()->incline.slip_offset, 0.1);
  received.step_height_m = 0.037;
  received.blocked = true;
  world.take(received);
  EXPECT_EQ(world.ground()->obstacle, ObstacleClass::kBlock);
  EXPECT_EQ(world.ground()->incline.horizontal_fraction, 0.0);
  for (int i = 0; i < 99; ++i) world.wait(0.005);
  EXPECT_FALSE(world.blocked());
  for (int i = 0; i < 9; ++i) world.wait(0.005);
  EXPECT_TRUE(world.blocked());
}

TEST(TerrainContacts, AnExternalWorldSaysHowTheVirtualRobotStands) {
  Parameters parameters;
  parameters.world = external();
  parameters.model.slip_left = parameters.model.slip_right = 0.1;
  TerrainContacts terrain_contacts(parameters, nullptr);
  ExternalWorld world(parameters.world, parameters.setup);
  WorldSample received = answer(0, -20 * kRadPerDeg);
  received.height_m = 0.05;
  world.take(received);
  terrain_contacts.set_external_terrain({world.ground(), world.transform()});
  Pose pose{};
  for (int i = 0; i < 200; ++i) {
    terrain_contacts.advance(
        {.estimates = {{Estimate{pose}, {pose}, {pose}}}, .tracks = {0.1, 0.1}, .dt_s = 0.005});
    pose.x_m += 0.09 * 0.005;
  }
  const Pose there = terrain_contacts.world(pose);
  EXPECT_EQ(there.z_m, 0.05);
  EXPECT_EQ(there.pitch_rad, -20 * kRadPerDeg);
  EXPECT_EQ(terrain_contacts.terrain_contact().pitch_source, PitchSource::kExternal);
  // The robot drives nine centimetres on the floor; uphill 6 % are lost to the projection and about
  // 5 % to slip.
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
    parameters_.setup = Setup::kStand;  // on a stand a start needs no gyro bias
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
    if (answers_) received_.assign(1, answer(now_ - kPeriod));
    for (WorldSample& received : received_) received.stop = stop_;
    const Outputs& out = step()({.samples = std::span(&sample, 1),
                                 .requests = requests,
                                 .world = received_,
                                 .session = SessionState::kReady,
                                 .clock = clock,
                                 .session_number = 1,
                                 .answer = answer_to_request_},
                                now_);
    received_.clear();
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
  std::vector<WorldSample> received_;
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
  EXPECT_EQ(request_, RobotRequest::kNone) << "the stop is requested once";
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
