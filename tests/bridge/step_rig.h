#pragma once
// A step on a short course, and an ideal robot.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "bridge/step.h"

namespace tp100::bridge {

inline constexpr HostNs kStepPeriod = 5 * kNsPerMs;

/// A robot that obeys commands at once and slips exactly as the parameters say.
class KinematicRobot {
 public:
  explicit KinematicRobot(const Parameters& parameters) : parameters_(parameters) {}

  Sample sample(HostNs now) {
    Sample sample;
    sample.sequence = static_cast<std::uint16_t>(now / kStepPeriod);
    sample.last_command = sample.sequence;
    sample.device_us = now / kNsPerUs;
    sample.measured_ns = now;
    sample.left_counts = std::llround(left_m_ * parameters_.drive.counts_per_metre);
    sample.right_counts = std::llround(right_m_ * parameters_.drive.counts_per_metre);
    sample.gyro_radps[2] = rate_radps_ + 0.01;
    sample.accel_mps2[2] = upside_down ? -9.81 : 9.81;
    sample.battery_v = 7.6;
    sample.state = armed ? RobotState::kRunning : RobotState::kDisarmed;
    sample.faults = faults;
    sample.imu_age = imu_age;
    return sample;
  }

  double rate_radps() const { return rate_radps_; }
  void obey(const Outputs& out) {
    if (out.request == RobotRequest::kArm) armed = true;
    if (out.request == RobotRequest::kDisarm || out.request == RobotRequest::kStop) armed = false;
    if (out.request == RobotRequest::kArm || out.request == RobotRequest::kDisarm)
      answer = RequestAnswer::kAcknowledged;
    double speed = 0.0;
    rate_radps_ = 0.0;
    if (armed && out.command_valid) {
      speed = out.command.speed_mps;
      rate_radps_ =
          std::clamp(out.command.yaw_rate_radps +
                         4.0 * wrap_angle(out.command.desired_yaw_rad - out.command.pose.yaw_rad),
                     -1.2, 1.2);
    }
    const double half = rate_radps_ * parameters_.model.wheelbase_m / 2.0;
    left_m_ += (speed - half) / (1.0 - parameters_.model.slip_left) * to_s(kStepPeriod);
    right_m_ += (speed + half) / (1.0 - parameters_.model.slip_right) * to_s(kStepPeriod);
    x_m += speed * std::cos(yaw_rad) * to_s(kStepPeriod);
    y_m += speed * std::sin(yaw_rad) * to_s(kStepPeriod);
    yaw_rad += rate_radps_ * to_s(kStepPeriod);
  }

  bool armed = false;
  bool upside_down = false;
  std::uint8_t imu_age = 0;
  RequestAnswer answer = RequestAnswer::kNone;  // for the next step
  FaultMask faults = 0;
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;

 private:
  Parameters parameters_;
  double left_m_ = 0.0, right_m_ = 0.0, rate_radps_ = 0.0;
};

class StepTest : public testing::Test {
 protected:
  StepTest() {
    auto course = std::make_shared<course::Course>();
    course->name = "test";
    course->path = {course::Line{0.3}, course::Arc{0.3, kPi / 2}, course::Pivot{-kPi / 2},
                    course::Line{0.2}};
    course->fence = {-5, 5, -5, 5};
    course_ = course;
    parameters_.model.slip_angle_straight_rad = 0.0;
  }

  /// One step at `now_` with these samples, and with what the members hold for the next step.
  const Outputs& step_with(Step& step, std::span<const Sample> samples,
                           const std::vector<OperatorRequest>& requests = {},
                           RequestAnswer answer = RequestAnswer::kNone) {
    ClockState clock;
    clock.valid = true;
    const Outputs& out = step({.restart = restart_,
                               .samples = connected_ ? samples : std::span<const Sample>(),
                               .requests = requests,
                               .camera = camera_,
                               .world = world_,
                               .changes = changes_,
                               .velocities = velocities_,
                               .session = connected_ ? SessionState::kReady : SessionState::kClosed,
                               .clock = clock,
                               .session_number = session_,
                               .answer = answer},
                              now_);
    restart_.clear();
    changes_.clear();
    camera_.clear();
    velocities_.clear();
    world_.clear();
    return out;
  }
  /// Runs one period: sample, step, robot.
  const Outputs& tick(Step& step, KinematicRobot& robot,
                      const std::vector<OperatorRequest>& requests = {}) {
    now_ += kStepPeriod;
    const Sample sample = robot.sample(now_);
    const Outputs& out = step_with(step, std::span(&sample, 1), requests,
                                   std::exchange(robot.answer, RequestAnswer::kNone));
    robot.obey(out);
    return out;
  }
  /// Starts the robot and drives for two seconds.
  void begin(Step& step, KinematicRobot& robot) {
    start(step, robot);
    ASSERT_EQ(run(step, robot, 2.0), RunState::kRunning);
  }
  RunState run(Step& step, KinematicRobot& robot, double duration_s) {
    RunState state = RunState::kIdle;
    for (double t = 0; t < duration_s; t += to_s(kStepPeriod)) {
      state = tick(step, robot).snapshot.run_state;
      if (state == RunState::kFinished || state == RunState::kAborted) break;
    }
    return state;
  }
  void start(Step& step, KinematicRobot& robot) { tick(step, robot, {OperatorRequest::kStart}); }

  Parameters parameters_{};
  std::shared_ptr<const course::Course> course_;
  // For the next step.
  BoundedList<CarriedState, 1> restart_{};
  std::vector<ParameterChange> changes_;
  std::vector<CameraSample> camera_;
  std::vector<VelocityInput> velocities_;
  std::vector<WorldSample> world_;
  HostNs now_ = 0;
  bool connected_ = true;
  std::uint32_t session_ = 1;
};

}  // namespace tp100::bridge
