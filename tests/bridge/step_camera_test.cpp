// A step that gets samples of the overhead camera.
#include <gtest/gtest.h>

#include <vector>

#include "step_rig.h"
#include "support/alloc_count.h"

namespace tp100::bridge {
namespace {

class CameraStepTest : public StepTest {
 protected:
  /// Runs one period with a camera that sees the robot shifted by `aside_m`, 60 ms late, in every
  /// sixth step. Returns the number of heap calls of the step.
  std::uint64_t tick_seen(Step& step, KinematicRobot& robot, double aside_m,
                          std::span<const OperatorRequest> requests = {},
                          std::span<const VelocityInput> velocities = {}) {
    now_ += kStepPeriod;
    samples_[0] = robot.sample(now_);
    if (++ticks_ % 6 == 0) {
      under_way_.push_back({robot.x_m, robot.y_m + aside_m, robot.yaw_rad, now_,
                            static_cast<std::uint32_t>(ticks_)});
    }
    arrived_.clear();
    if (!under_way_.empty() && now_ - under_way_.front().measured_ns >= 60 * kNsPerMs) {
      arrived_.push_back(under_way_.front());
      under_way_.erase(under_way_.begin());
    }
    ClockState clock;
    clock.valid = true;
    const test::AllocCount count;
    out_ = &step({.samples = samples_,
                  .requests = requests,
                  .camera = arrived_,
                  .velocities = velocities,
                  .session = SessionState::kReady,
                  .clock = clock,
                  .session_number = 1,
                  .answer = std::exchange(robot.answer, RequestAnswer::kNone)},
                 now_);
    const std::uint64_t calls = count.calls();
    robot.obey(*out_);
    return calls;
  }
  const Snapshot& snapshot() const { return out_->snapshot; }

  std::vector<CameraSample> under_way_, arrived_;
  int ticks_ = 0;
  const Outputs* out_ = nullptr;
};

TEST_F(CameraStepTest, TheFusedPoseFollowsTheCameraAndAllocatesNothing) {
  parameters_.steering = PoseSource::kFused;
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  const OperatorRequest request = OperatorRequest::kStart;
  std::uint64_t calls = tick_seen(step, robot, 0.0, std::span(&request, 1));
  while (now_ < 60 * kNsPerS && snapshot().run_state != RunState::kFinished) {
    calls += tick_seen(step, robot, 0.0);
  }
  EXPECT_EQ(snapshot().run_state, RunState::kFinished);
  EXPECT_EQ(calls, 0u);
  EXPECT_NEAR(snapshot().estimates[PoseSource::kFused].pose.x_m, robot.x_m, 0.002);
  EXPECT_NEAR(snapshot().estimates[PoseSource::kFused].pose.y_m, robot.y_m, 0.002);
  EXPECT_GT(snapshot().filter.camera_used, 300u);
  EXPECT_EQ(snapshot().filter.camera_rejected, 0u);
  EXPECT_LT(snapshot().filter.camera_age_us, 120'000);
  EXPECT_LT(snapshot().estimates[PoseSource::kFused].covariance.xx, 4e-6);
}

TEST_F(CameraStepTest, WhoIsMovedIsFoundByTheCameraAndByNobodyElse) {
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  for (int i = 0; i < 300; ++i) tick_seen(step, robot, 0.0);
  for (int i = 0; i < 60; ++i) tick_seen(step, robot, 0.04);
  EXPECT_NEAR(snapshot().estimates[PoseSource::kFused].pose.y_m, 0.04, 0.003);
  EXPECT_EQ(snapshot().estimates[PoseSource::kOdometry].pose.y_m, 0.0);
  EXPECT_EQ(snapshot().estimates[PoseSource::kModel].pose.y_m, 0.0);
  EXPECT_EQ(snapshot().filter.recoveries, 1u);
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
    const OperatorRequest request = OperatorRequest::kDrive;
    tick_seen(step, robot, 0.0, std::span(&request, 1));
    for (int i = 0; i < 2400; ++i) {
      const VelocityInput ahead{.at_ns = now_, .speed_mps = 0.1};
      tick_seen(step, robot, 0.0, {}, std::span(&ahead, 1));
    }
    EXPECT_TRUE(snapshot().at_fence) << to_string(source);
    under_way_.clear();
    return course->fence.max_x_m - snapshot().world.x_m;
  };
  const double fused_m = left_to_fence_m(PoseSource::kFused);
  EXPECT_GT(fused_m, 0.01);
  EXPECT_GT(left_to_fence_m(PoseSource::kOdometry), fused_m + 0.01);
  EXPECT_GT(left_to_fence_m(PoseSource::kModel), fused_m + 0.01);
}

TEST_F(CameraStepTest, OnAStandTheCameraIsNotLookedAt) {
  parameters_.setup = Setup::kStand;
  Step step(parameters_, course_);
  KinematicRobot robot(parameters_);
  for (int i = 0; i < 300; ++i) tick_seen(step, robot, 0.04);
  EXPECT_EQ(snapshot().filter.camera_age_us, -1);
  EXPECT_NEAR(snapshot().estimates[PoseSource::kFused].pose.y_m, 0.0, 1e-9);
}

}  // namespace
}  // namespace tp100::bridge
