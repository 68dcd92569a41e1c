#pragma once
// What the control tests drive: a robot that follows yaw and speed with first-order lags and within
// its belts' limits, as the firmware's loops do. Nothing of the code under test but its types.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "control/tracker.h"
#include "core/angle.h"

namespace tp100::control {

inline constexpr double kDt = 0.005;

inline course::Course make_course(std::vector<course::Segment> path) {
  course::Course course;
  course.name = "test";
  course.path = std::move(path);
  return course;
}

struct LaggingRobot {
  BeltLimits limits{};
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
    pose.yaw_rad += twist.yaw_rate_radps * kDt;
    pose.x_m += twist.vx_mps * std::cos(pose.yaw_rad) * kDt;
    pose.y_m += twist.vx_mps * std::sin(pose.yaw_rad) * kDt;
  }
};

}  // namespace tp100::control
