#pragma once
// A turn on the spot of a robot whose turning centre is not its reference point.

#include "control/parameters.h"
#include "core/arithmetic.h"
#include "core/pose.h"
#include "course/path.h"

namespace tp100::control {

// A turn on the spot: yaw as a trapezoid in time.

/// The desired yaw of one turn. No allocation; safe in the real-time thread.
class PivotProfile {
 public:
  /// Never faster than `max_radps`.
  void begin(const course::PathSegment& segment, double max_radps);
  /// After begin(): the robot has turned to `yaw_rad` already.
  void begin_at(double yaw_rad) { yaw_rad_ += wrap_angle(yaw_rad - yaw_rad_); }
  /// The robot stands at `yaw_rad` before the turn is over; the next update() begins from rest.
  void halt_at(double yaw_rad) {
    begin_at(yaw_rad);
    rate_radps_ = 0.0;
  }
  /// One step; the rate always allows a stop at the end.
  void update(const Parameters& parameters, double dt_s);

  double yaw_rad() const { return yaw_rad_; }
  double rate_radps() const { return rate_radps_; }
  bool arrived() const { return arrived_; }

 private:
  double end_rad_ = 0.0;
  double max_radps_ = 0.0;
  double yaw_rad_ = 0.0;
  double rate_radps_ = 0.0;
  bool arrived_ = false;
};

/// If the turning centre lies `x_icr_m` ahead, a rotation moves the reference point sideways: at a
/// right angle it ends 1.41 |x_icr_m| beside the corner. The turning centre itself moves like a
/// wheel, only along the heading. It is therefore guided around the corner: on an arc from the
/// first line towards the second one, with a turn on the spot where it meets that line; if it lies
/// behind the reference point, the same in reverse order. Of all such trajectories this one keeps
/// the reference point nearest to the path: within 0.22 |x_icr_m| at a right angle.
/// Disturbances of the turn, such as a slipping track, are corrected as far as tracks can, which is
/// along the heading: the robot is to end the turn on the next line.
/// SI units. No allocation. Only the constructor takes long, because it searches.
class Corner {
 public:
  /// A turn without an arc: the robot turns on the spot.
  Corner() = default;
  /// `turn` is a segment of kind pivot; `room_m` is the length of line available before it and
  /// after it. There is no arc if the room is too small or nothing is gained.
  Corner(const course::PathSegment& turn, double x_icr_m, double room_m);

  /// Radius of the turning centre's arc; 0: no arc. [m]
  double radius_m() const { return radius_m_; }
  /// Distance before the corner at which the reference point stops. Not negative.
  double stop_before_m() const;
  /// Greatest distance from the corner at which the turn begins and ends.
  double reach_m() const { return arc_end_m_ + spot_m_; }
  /// Speed along the robot while it turns at `rate_radps`: the arc's, plus a small correction of
  /// its distance to the next line.
  double speed_mps(const Pose& pose, double rate_radps) const;

 private:
  struct Spot {
    double x_m = 0.0, y_m = 0.0;
  };
  bool on_arc(double turned_rad) const;
  Spot reference(double turned_rad) const;
  double distance_m(const Spot& spot) const;
  double worst_of_turn_m() const;

  course::PathPoint corner_{};
  double side_ = 1.0;  ///< 1: turns left, -1: right
  double angle_rad_ = 0.0;
  double x_icr_m_ = 0.0;
  double radius_m_ = 0.0;
  double arc_rad_ = 0.0;    ///< part of the turn that is on the arc
  double arc_end_m_ = 0.0;  ///< from the corner to where the arc touches its line, ...
  double spot_m_ = 0.0;     ///< ... and to where it meets the other one
};

}  // namespace tp100::control
