#include "control/stanley.h"

#include <algorithm>
#include <cmath>

namespace tp100::control {

double Stanley::look_ahead_m(double speed_mps) const { return speed_mps * parameters_.preview_s; }

Steering Stanley::steer(const PathErrors& errors) const {
  const double gain =
      parameters_.cross_track_gain_1ps / (errors.speed_mps + parameters_.soft_speed_mps);
  const double wish = std::atan(gain * errors.cross_track_m);
  const double approach =
      std::clamp(wish, -parameters_.max_approach_rad, parameters_.max_approach_rad);
  Steering steering;
  steering.yaw_rad = errors.ahead.yaw_rad - approach - errors.crab_rad;
  steering.yaw_rate_radps = errors.ahead.curvature_1pm * errors.speed_mps;
  // The desired yaw turns as the robot comes nearer; without this it would lag and overshoot.
  if (wish == approach) {
    const double closing_mps = errors.speed_mps * std::sin(errors.heading_rad + errors.crab_rad);
    const double steepness =
        gain / (1.0 + gain * gain * errors.cross_track_m * errors.cross_track_m);
    steering.yaw_rate_radps -= steepness * closing_mps;
  }
  return steering;
}

}  // namespace tp100::control
