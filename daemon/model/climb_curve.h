#pragma once
// The parts of a step climb that follow belt travel alone: the body leans on two points of the
// world and geometry fixes its angle. Angles here are nose-up positive, as in the formulas.

#include "model/climb_geometry.h"

namespace tp100::model {

/// How belt travel turns into angle while the front belt rolls up the riser. `kBeltHolds`: the belt
/// holds on the riser, L_a sin phi + r phi = s. `kPaper`: eq 6 to the letter, phi = asin(s / L_a).
enum class RiserForm { kBeltHolds, kPaper };

/// Point or vector in the vertical plane of the climb: x ahead of the near edge, z above ground.
struct PlaneVector {
  double x = 0.0;
  double z = 0.0;
};

/// The body on its curve at some belt travel.
struct Lean {
  double angle_rad = 0.0;        ///< nose-up positive
  double rate_radpm = 0.0;       ///< change of the angle per metre of belt travel
  PlaneVector rear_axle{};       ///< [m]
  PlaneVector held_point{};      ///< point that belt motion moves: the contact that does not slip
  PlaneVector belt_direction{};  ///< unit vector in which the body moves at that point
};

/// Belt travel at which the parts meet, from first touch of the riser. [m]
struct ClimbMarks {
  double riser_end;   ///< s1: the front axle is level with the edge; 0 if h <= r
  double wrap_end;    ///< s2: the edge reaches the flat of the belt
  double cross_end;   ///< the centre of mass passes the near edge
  double flat_begin;  ///< flat on the block with the centre of mass over the near edge
  double flat_end;    ///< the same over the far edge
  double nose_begin;  ///< leaning on far edge and nose with the centre of mass over that edge
  double nose_end;    ///< the rear end of the flat of the belt reaches the far edge
  double slide_end;   ///< flat behind the block
};

/// Pure functions of belt travel. No allocation after construction; safe in the real-time thread.
class ClimbCurve {
 public:
  /// Throws SetupError as check_climb does.
  ClimbCurve(const ClimbGeometry& geometry, const Block& block, RiserForm form);

  const ClimbGeometry& geometry() const { return geometry_; }
  const Block& block() const { return block_; }
  const ClimbMarks& marks() const { return marks_; }

  Lean approach(double travel_m) const;  ///< flat in front of the block, travel <= 0
  Lean riser(double travel_m) const;     ///< phase 1
  Lean wrap(double travel_m) const;      ///< phase 2
  Lean cross(double travel_m) const;     ///< phase 3: near edge and rear contact
  Lean nose(double travel_m) const;      ///< far edge and front contact; the far edge holds
  Lean slide(double travel_m) const;     ///< rear end on the far edge; the front contact holds
  Lean down(double travel_m) const;      ///< flat behind the block

  /// How the rate of `cross` changes with travel. [rad/m^2]
  double cross_bend(double travel_m) const;

  /// Body turned by `angle_rad` about the near (phases 4 and 5) or the far edge. Rate 0.
  Lean about_near_edge(double travel_m, double angle_rad) const;
  Lean about_far_edge(double travel_m, double angle_rad) const;

  /// Edge to centre of mass along the belt's flat, positive once it is past the edge. [m]
  double past_near_edge_m(double travel_m) const { return travel_m - marks_.flat_begin; }
  double past_far_edge_m(double travel_m) const { return travel_m - marks_.flat_end; }

 private:
  struct Roll {
    double angle, elevation;
  };
  double edge_angle(double flat_m) const;
  Lean about_edge(double edge_x, double flat_m, double angle_rad) const;
  double angle_at_elevation(double elevation) const;
  double slide_travel(const Roll& roll) const;
  Roll roll_at(double travel_m) const;

  ClimbGeometry geometry_;
  Block block_;
  RiserForm form_;
  double first_elevation_;  ///< of the axle seen from the edge, at first touch
  double last_elevation_;   ///< the same where the flat of the belt begins
  ClimbMarks marks_{};
};

}  // namespace tp100::model
