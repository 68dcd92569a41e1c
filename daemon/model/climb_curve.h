#pragma once
// The parts of a step climb that depend on track travel alone: the body is supported at two points
// and geometry determines its angle. Angles here are nose-up positive, as in the formulas.

#include <optional>

namespace tp100::model {

// Geometry of robot and block in a step climb, and the static test that precedes it.

/// The robot in the plane of the step. The track is a stadium around two axles. [m]
struct ClimbGeometry {
  double axle_spacing_m = 0.133;  ///< L_a
  double wheel_radius_m = 0.026;  ///< r, outer radius of the track at both axles
  double com_forward_m = 0.0665;  ///< l_c, centre of mass ahead of the rear axle; 0..L_a
  double com_height_m = 0.022;    ///< z_c, above the tracks' underside; > 0
  double body_length_m = 0.185;   ///< l, for the moment of inertia
  double body_height_m = 0.060;   ///< H, for the moment of inertia
};

/// A block across the robot's path. An infinite depth is a step up onto a plateau.
struct BlockShape {
  double height_m = 0.037;  ///< h
  double depth_m = 0.100;   ///< in the driving direction
};

/// Highest step that the centre of mass still passes, quasi-static and with enough
/// traction: max over phi of r (1 - cos phi) + l_c sin phi - z_c sin^2 phi / cos phi. [m]
/// Pure.
double climb_limit_m(const ClimbGeometry& geometry);

/// Nose-up angle at which the centre of mass passes the edge of a step of `height_m`; none if the
/// step cannot be climbed. [rad] Pure.
std::optional<double> tip_angle_rad(const ClimbGeometry& geometry, double height_m);

/// Square of the body's radius of gyration about its lateral axis, (l^2 + H^2) / 12. [m^2]
double gyration_squared_m2(const ClimbGeometry& geometry);

/// Throws UserError if a length is not positive and finite, the centre of mass lies outside the
/// axles, the block is higher than climb_limit_m, or the nose cannot reach the ground behind it.
void check_climb(const ClimbGeometry& geometry, const BlockShape& block);

/// Point or vector in the vertical plane of the climb: x ahead of the near edge, z above ground.
struct PlaneVector {
  double x = 0.0;
  double z = 0.0;
};

/// The body on its curve at a given track travel.
struct Lean {
  double angle_rad = 0.0;  ///< nose-up positive
  /// Change of the angle per metre of track travel, of cross and nose: a fall begins with it.
  double rate_radpm = 0.0;
  PlaneVector rear_axle{};  ///< [m]
};

/// Track travel at the boundaries of the phases, from first touch of the riser. [m]
struct ClimbMarks {
  double riser_end;   ///< s1: the front axle is level with the edge; 0 if h <= r
  double wrap_end;    ///< s2: the edge reaches the flat of the track
  double cross_end;   ///< the centre of mass passes the near edge
  double flat_begin;  ///< flat on the block with the centre of mass over the near edge
  double flat_end;    ///< the same over the far edge
  double nose_begin;  ///< leaning on far edge and nose with the centre of mass over that edge
  double nose_end;    ///< the rear end of the flat of the track reaches the far edge
  double slide_end;   ///< flat behind the block
};

/// Pure functions of track travel. No allocation after construction; safe in the real-time thread.
class ClimbCurve {
 public:
  /// Throws UserError as check_climb does.
  ClimbCurve(const ClimbGeometry& geometry, const BlockShape& block);

  const ClimbGeometry& geometry() const { return geometry_; }
  const BlockShape& block() const { return block_; }
  const ClimbMarks& marks() const { return marks_; }

  Lean approach(double travel_m) const;  ///< flat in front of the block, travel <= 0
  /// Phase 1: the track holds on the riser, L_a sin phi + r phi = s; eq 6 leaves r phi out.
  Lean riser(double travel_m) const;
  Lean wrap(double travel_m) const;   ///< phase 2
  Lean cross(double travel_m) const;  ///< phase 3: near edge and rear contact
  Lean nose(double travel_m) const;   ///< far edge and front contact; the far edge holds
  Lean slide(double travel_m) const;  ///< rear end on the far edge; the front contact holds
  Lean down(double travel_m) const;   ///< flat behind the block

  /// Change of the rate of `cross` with travel. [rad/m^2]
  double cross_bend(double travel_m) const;

  /// The body rotated by `angle_rad` about the near (phases 4 and 5) or the far edge. Rate 0.
  Lean about_near_edge(double travel_m, double angle_rad) const;
  Lean about_far_edge(double travel_m, double angle_rad) const;

  /// Distance from the edge to the centre of mass along the track's flat, positive past the edge.
  /// [m]
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
  BlockShape block_;
  double first_elevation_;  ///< elevation of the axle from the edge, at first touch
  double last_elevation_;   ///< the same where the flat of the track begins
  ClimbMarks marks_{};
};

}  // namespace tp100::model
