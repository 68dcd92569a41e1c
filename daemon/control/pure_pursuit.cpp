#include "control/pure_pursuit.h"

#include <algorithm>
#include <cmath>

namespace tp100::control {

double PurePursuit::look_ahead_m(double speed_mps) const {
  return std::clamp(speed_mps * parameters_.pursuit_s, parameters_.pursuit_min_m,
                    std::max(parameters_.pursuit_min_m, parameters_.pursuit_max_m));
}

Steering PurePursuit::steer(const PathErrors& errors) const {
  // The robot moves where it looks plus the slip angle: that is the direction of the circle.
  const double course_rad = errors.heading_rad + errors.crab_rad;
  const double c = std::cos(course_rad), s = std::sin(course_rad);
  const double left_m = errors.ahead.left_m - errors.cross_track_m;
  const double forward = c * errors.ahead.along_m + s * left_m;
  const double sideways = -s * errors.ahead.along_m + c * left_m;
  const double distance = std::max(std::hypot(forward, sideways), parameters_.pursuit_min_m);
  // A point behind is turned to as if it lay abeam.
  const double y =
      forward < 0.0 ? std::copysign(distance, sideways) : std::clamp(sideways, -distance, distance);
  const double curvature = 2.0 * y / (distance * distance);

  Steering steering;
  steering.yaw_rate_radps = errors.curvature_1pm * errors.speed_mps;
  const double rest_radps = curvature * errors.speed_mps - steering.yaw_rate_radps;
  const double lean = course_rad - errors.ahead.yaw_rad + rest_radps / yaw_kp_;
  steering.yaw_rad = errors.ahead.yaw_rad - errors.crab_rad +
                     std::clamp(lean, -parameters_.max_approach_rad, parameters_.max_approach_rad);
  return steering;
}

}  // namespace tp100::control
