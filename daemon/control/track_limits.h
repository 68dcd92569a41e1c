#pragma once
// Limits of the tracks. Beyond them the speed is reduced, never the turn rate. The same arithmetic
// as the firmware's (firmware/tp100/src/yaw_loop.h), so that the daemon commands nothing that the
// robot would have to limit.

#include "core/pose.h"

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

/// The ground speed nearest to `speed_mps` at which both tracks stay within their limit while the
/// robot turns. A turn rate that is too great even on the spot counts as the greatest possible one.
double speed_within(double speed_mps, double turn_radps, const TrackLimits& limits);

/// The greatest ground speed up to `speed_mps` at which the tracks can follow the robot's yaw loop,
/// with a feed-forward proportional to speed: a curve at half the speed needs half the turn rate.
/// Not negative; 0 if the yaw error alone is too much.
double speed_along(double speed_mps, double yaw_error_rad, double curvature_1pm,
                   const TrackLimits& limits);

/// Track speeds for a ground speed and a turn rate, within the limit; the turn has priority.
TrackSpeeds tracks_for(double speed_mps, double turn_radps, const TrackLimits& limits);

}  // namespace tp100::control
