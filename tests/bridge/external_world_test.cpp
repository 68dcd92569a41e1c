#include "bridge/external_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "core/error.h"
#include "step_rig.h"

namespace tp100::bridge {
namespace {

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

TEST(ExternalWorld, IsLostOnceItsLastAnswerIsToAPoseOlderThan100Ms) {
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
  WorldSample anew = answer(kNsPerS + kStepPeriod);
  anew.session = 2;
  world.take(anew);
  EXPECT_TRUE(world.fresh(kNsPerS + kStepPeriod));
  EXPECT_TRUE(world.lost(kNsPerS + kStepPeriod));
  world.restart(kNsPerS + kStepPeriod);
  EXPECT_FALSE(world.lost(kNsPerS + kStepPeriod));
}

TEST(ExternalWorld, WhoOwnsThePoseMustSayIt) {
  ExternalWorld world(external(true), Setup::kFlat);
  world.take(answer(kNsPerS));
  EXPECT_FALSE(world.fresh(kNsPerS));
}

TEST(ExternalWorld, APoseBelongsToTheStepThatItAnswers) {
  ExternalWorld world(external(true), Setup::kFlat);
  world.restart(0);
  for (int i = 0; i < 100; ++i) world.remember(i * kStepPeriod, {.x_m = 0.01 * i});
  WorldSample received = answer(40 * kStepPeriod);
  received.has_pose = true;
  received.has_ground = false;
  received.pose = {.x_m = 0.35, .y_m = 0.1, .pitch_rad = -0.2};
  world.take(received);
  EXPECT_EQ(world.ground()->pitch_rad, -0.2) << "it may leave the ground out";
  ASSERT_TRUE(world.transform());
  EXPECT_NEAR(world.transform()->x_m, -0.05, 1e-12);
  EXPECT_NEAR(world.transform()->y_m, 0.1, 1e-12);
  world.restart(100 * kStepPeriod);
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
  says(began + kStepPeriod, {.x_m = 5.0});
  says(began + 2 * kStepPeriod, {.x_m = 1.0, .yaw_rad = 1.0});
  EXPECT_FALSE(world.transform());
  EXPECT_TRUE(world.lost(began + 100 * kNsPerMs)) << "the world never showed the start";
  says(began + 3 * kStepPeriod, {.x_m = 1.02, .yaw_rad = 0.01});
  EXPECT_TRUE(world.transform());
  EXPECT_FALSE(world.lost(began + 100 * kNsPerMs));
  // From now on the world owns the pose.
  says(began + 4 * kStepPeriod, {.x_m = 1.3});
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

/// A step with an external world, and a robot.
class WorldStep : public StepTest {
 protected:
  WorldStep() {
    parameters_.setup = Setup::kStand;  // on a stand a start needs no gyro bias
    parameters_.world = external();
  }

  const Snapshot& tick(const std::vector<OperatorRequest>& requests = {}) {
    if (!step_) step_.emplace(parameters_, course_);
    if (answers_) {
      world_.push_back(answer(now_));
      world_.back().stop = stop_;
    }
    const Outputs& out = StepTest::tick(*step_, robot_, requests);
    request_ = out.request;
    return out.snapshot;
  }
  RunState ticks(int count) {
    for (int i = 1; i < count; ++i) tick();
    return tick().run_state;
  }

  std::optional<Step> step_;
  KinematicRobot robot_{parameters_};
  bool answers_ = true, stop_ = false;
  RobotRequest request_ = RobotRequest::kNone;
};

TEST_F(WorldStep, NothingBeginsBeforeTheWorldAnswersAndNothingAfter3S) {
  answers_ = false;
  EXPECT_EQ(tick().start_refusal, StartRefusal::kNoWorld);
  tick({OperatorRequest::kStart});
  EXPECT_EQ(ticks(200), RunState::kArming);
  EXPECT_FALSE(robot_.armed);
  EXPECT_EQ(ticks(410), RunState::kIdle);
  answers_ = true;
  EXPECT_EQ(ticks(1000), RunState::kIdle) << "whoever started may have gone";
  answers_ = false;
  ticks(30);
  tick({OperatorRequest::kStart});
  EXPECT_EQ(ticks(200), RunState::kArming);
  answers_ = true;
  EXPECT_EQ(ticks(20), RunState::kRunning);
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
  EXPECT_THROW(tick(), UserError);
}

}  // namespace
}  // namespace tp100::bridge
