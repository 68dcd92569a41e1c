#pragma once
// A turn on the spot: yaw as a trapezoid in time, and what the reference point does meanwhile.

#include "control/parameters.h"
#include "core/pose.h"
#include "course/path.h"

namespace tp100::control {

/// The desired yaw of one turn. No allocation; safe in the real-time thread.
class Pivot {
 public:
  void begin(const course::Piece& piece);
  /// One step; never faster than what still stops at the end.
  void update(const Parameters& parameters, double dt_s);

  double yaw_rad() const { return yaw_rad_; }
  double rate_radps() const { return rate_radps_; }
  bool arrived() const { return arrived_; }

 private:
  double end_rad_ = 0.0;
  double yaw_rad_ = 0.0;
  double rate_radps_ = 0.0;
  bool arrived_ = false;
};

/// A robot that turns about a point `x_icr_m` ahead of its reference point cannot turn its
/// reference point on the spot: that moves sideways by -x_icr_m times the turn. But the turning
/// centre moves as a wheel does, only where the robot looks. So it is led around the corner on an
/// arc that touches both lines, with a radius of |x_icr_m|: at a right angle the reference point
/// then leaves the path by 0.41 |x_icr_m| instead of 1.41 |x_icr_m|. SI units; no allocation.
class RoundedCorner {
 public:
  /// A turn on the very spot, without correction.
  RoundedCorner() = default;
  /// `turn` is the piece.
  RoundedCorner(const course::Piece& turn, double x_icr_m);

  /// The reference point stops this much before the corner. Not negative.
  double stop_before_m() const { return stop_before_m_; }
  /// Speed along the robot while it turns with `rate_radps`, desired yaw `yaw_rad`: the arc's, and
  /// a little to where on it the robot should be.
  double speed_mps(const Pose& pose, double yaw_rad, double rate_radps) const;

 private:
  course::PathPoint corner_{};
  double side_ = 0.0;  ///< 1: turns left, -1: right, 0: not rounded
  double x_icr_m_ = 0.0;
  double radius_m_ = 0.0;
  double tangent_m_ = 0.0;  ///< from the corner to where the arc touches the lines
  double stop_before_m_ = 0.0;
};

}  // namespace tp100::control
