// A step that gets samples of the overhead camera.
#include <gtest/gtest.h>

#include <deque>

#include "step_rig.h"

namespace tp100::bridge {
namespace {

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

// The real-time thread must not wait for the heap, with or without a camera.
TEST_F(CameraStepTest, TheFusedPoseFollowsTheCameraAndAllocatesNothing) {
  parameters_.steering = PoseSource::kFused;
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  const Snapshot& snapshot = tick_seen(step, robot, 0.0, {OperatorRequest::kStart});
  while (now_ < 60 * kNsPerS && snapshot.run_state != RunState::kFinished)
    tick_seen(step, robot, 0.0);
  EXPECT_EQ(snapshot.run_state, RunState::kFinished);
  EXPECT_EQ(heap_calls_, 0u);
  EXPECT_NEAR(snapshot.estimates[PoseSource::kFused].pose.x_m, robot.x_m, 0.002);
  EXPECT_NEAR(snapshot.estimates[PoseSource::kFused].pose.y_m, robot.y_m, 0.002);
  EXPECT_GT(snapshot.filter.camera_used, 300u);
  EXPECT_EQ(snapshot.filter.camera_rejected, 0u);
  EXPECT_LT(snapshot.filter.camera_age_us, 120'000);
  EXPECT_LT(snapshot.estimates[PoseSource::kFused].covariance.xx, 4e-6);
  if (!test::counting()) return;
  const test::AllocCount count;
  const auto block = std::make_unique<std::vector<int>>(100);
  EXPECT_GE(count.calls(), 2u) << "calls are counted";
}

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
