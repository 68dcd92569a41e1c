#pragma once
// Limits of the tracks. Beyond them the speed is reduced, never the turn rate; see
// shared/skid_steer.h.

#include "shared/skid_steer.h"

namespace tp100::control {

/// Limits of one robot. SI units.
struct TrackLimits {
  double wheelbase_m = 0.2742;  ///< equivalent, eq 5
  double slip_left = 0.0;
  double slip_right = 0.0;
  double max_track_mps = 0.2;
  double yaw_kp = 4.0;  ///< of the robot's yaw loop [1/s]
  double max_yaw_radps = 1.2;
};

/// The turn rate that the robot's yaw loop will request. [rad/s]
double turn_asked(double yaw_error_rad, double feed_forward_radps, const TrackLimits& limits);

/// Limits the tracks as the robot does.
inline shared::SkidSteer<double> skid_steer(const TrackLimits& limits) {
  return {limits.wheelbase_m, limits.slip_left, limits.slip_right, limits.max_track_mps};
}

/// The greatest ground speed up to `speed_mps` at which the tracks can follow the robot's yaw loop,
/// with a feed-forward proportional to speed: a curve at half the speed needs half the turn rate.
/// Not negative; 0 if the yaw error alone is too much.
double speed_along(double speed_mps, double yaw_error_rad, double curvature_1pm,
                   const TrackLimits& limits);

}  // namespace tp100::control
