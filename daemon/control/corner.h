#pragma once
// A turn on the spot of a robot that turns about another point than its reference point.

#include "core/pose.h"
#include "course/path.h"

namespace tp100::control {

/// Where the turning centre lies `x_icr_m` ahead, turning by an angle moves the reference point
/// sideways: at a right angle it ends 1.41 |x_icr_m| beside the corner. The turning centre itself
/// moves as a wheel does, only where the robot looks. So it is led around the corner: on an arc
/// from the first line towards the second one and on the spot where it meets that; if it lies
/// behind the reference point, the same backwards. Of all such ways this is the one on which the
/// reference point stays nearest to the path: within 0.22 |x_icr_m| at a right angle.
///
/// What carries the robot off meanwhile, as a belt that slips, is set right as far as belts can,
/// which is along where the robot looks: it is to end the turn on the next line.
///
/// SI units. Nothing but the constructor, which searches, takes time; no allocation.
class Corner {
 public:
  /// A turn without an arc: the robot turns on the spot.
  Corner() = default;
  /// `turn` is a piece of kind pivot; `room_m` what there is of line before it, and as much after
  /// it. Without an arc where there is too little room or nothing to gain.
  Corner(const course::Piece& turn, double x_icr_m, double room_m);

  /// Of the turning centre's arc; 0: no arc. [m]
  double radius_m() const { return radius_m_; }
  /// The reference point stops this much before the corner. Not negative.
  double stop_before_m() const;
  /// The turn begins and ends not farther than this from the corner.
  double reach_m() const { return arc_end_m_ + spot_m_; }
  /// Speed along the robot while it turns with `rate_radps`: the arc's, and a little to be as far
  /// from the next line as a robot with this yaw should be.
  double speed_mps(const Pose& pose, double rate_radps) const;
  /// The greatest distance of the reference point from both lines, if all goes as it should.
  double worst_m() const { return worst_m_; }

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
  double arc_rad_ = 0.0;    ///< how much of the turn is the arc
  double arc_end_m_ = 0.0;  ///< from the corner to where the arc touches its line, ...
  double spot_m_ = 0.0;     ///< ... and to where it meets the other one
  double worst_m_ = 0.0;
};

}  // namespace tp100::control
