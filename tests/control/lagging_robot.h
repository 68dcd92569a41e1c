#pragma once
// The robot of the control tests: it follows yaw and speed with first-order lags and within its
// tracks' limits, as the firmware's loops do. It shares only types with the code under test.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "control/tracker.h"
#include "core/arithmetic.h"

namespace tp100::control {

inline constexpr double kDt = 0.005;

inline course::Course make_course(std::vector<course::Segment> path) {
  course::Course course;
  course.name = "test";
  course.path = std::move(path);
  return course;
}

struct LaggingRobot {
  TrackLimits limits{};
  double x_icr_m = 0.0;  ///< distance ahead of the point about which the robot turns
  Pose pose{};
  Twist twist{};

  void obey(const Target& target) {
    const double rate = std::clamp(
        target.yaw_rate_radps + limits.yaw_kp * wrap_angle(target.desired_yaw_rad - pose.yaw_rad),
        -limits.max_yaw_radps, limits.max_yaw_radps);
    const double room =
        std::max(0.0, limits.max_track_mps - std::abs(rate) * limits.wheelbase_m / 2.0);
    twist.yaw_rate_radps += (rate - twist.yaw_rate_radps) * kDt / 0.08;
    twist.vx_mps += (std::clamp(target.speed_mps, -room, room) - twist.vx_mps) * kDt / 0.08;
    twist.vy_mps = -x_icr_m * twist.yaw_rate_radps;
    pose.yaw_rad += twist.yaw_rate_radps * kDt;
    const double c = std::cos(pose.yaw_rad), s = std::sin(pose.yaw_rad);
    pose.x_m += (c * twist.vx_mps - s * twist.vy_mps) * kDt;
    pose.y_m += (s * twist.vx_mps + c * twist.vy_mps) * kDt;
  }
};

}  // namespace tp100::control
