#pragma once
// What the belts can do, and who gives way when it is not enough: the speed, never the turn. The
// same arithmetic as the firmware's (firmware/tp100/src/belts.h), so that the daemon commands
// nothing that the robot would have to cut.

namespace tp100::control {

/// Of one robot. SI units.
struct BeltLimits {
  double wheelbase_m = 0.2742;  ///< equivalent, eq 5
  double slip_left = 0.0;
  double slip_right = 0.0;
  double max_track_mps = 0.2;
  double yaw_kp = 4.0;  ///< of the robot's yaw loop [1/s]
  double max_yaw_radps = 1.2;
};

/// Belt speeds, forward positive. [m/s]
struct Belts {
  double left_mps = 0.0;
  double right_mps = 0.0;
};

/// The turn that the robot's yaw loop will ask for. [rad/s]
double turn_asked(double yaw_error_rad, double feed_forward_radps, const BeltLimits& limits);

/// The ground speed nearest to `speed_mps` at which both belts stay within their limit while the
/// robot turns. A turn that is too much even on the spot counts as the greatest possible one.
double speed_within(double speed_mps, double turn_radps, const BeltLimits& limits);

/// The greatest ground speed up to `speed_mps` at which the belts can do what the robot's yaw loop
/// will ask for, if the feed-forward belongs to the way: a curve driven at half the speed needs
/// half the turn rate. Not negative; 0 if the yaw error alone is too much.
double speed_along(double speed_mps, double yaw_error_rad, double curvature_1pm,
                   const BeltLimits& limits);

/// Belt speeds for a ground speed and a turn rate, within the limit; the turn has priority.
Belts belts_for(double speed_mps, double turn_radps, const BeltLimits& limits);

}  // namespace tp100::control
