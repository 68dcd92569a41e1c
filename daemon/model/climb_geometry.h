#pragma once
// The robot and the block as a step climb sees them, and the static test that comes first.

#include <optional>

namespace tp100::model {

/// Robot in the plane of the step. The belt is a stadium around two axles. [m]
struct ClimbGeometry {
  double axle_spacing_m = 0.133;  ///< L_a
  double belt_radius_m = 0.026;   ///< r, outer radius of the belt at both axles
  double com_forward_m = 0.0665;  ///< l_c, centre of mass ahead of the rear axle; 0..L_a
  double com_height_m = 0.022;    ///< z_c, above the belts' underside; > 0
  double body_length_m = 0.185;   ///< l, for the moment of inertia
  double body_height_m = 0.060;   ///< H, for the moment of inertia
};

/// Block across the robot's way. An infinite depth is a step up onto a plateau.
struct Block {
  double height_m = 0.037;  ///< h
  double depth_m = 0.100;   ///< along the way
};

/// Highest step that the centre of mass still passes, quasi-static and with enough grip:
/// max over phi of r (1 - cos phi) + l_c sin phi - z_c sin^2 phi / cos phi. [m] Pure.
double climb_limit_m(const ClimbGeometry& geometry);

/// Nose-up angle at which the centre of mass passes the edge of a step of `height_m`; none if the
/// step cannot be climbed. [rad] Pure.
std::optional<double> tip_angle_rad(const ClimbGeometry& geometry, double height_m);

/// Square of the body's radius of gyration about its lateral axis, (l^2 + H^2) / 12. [m^2]
double gyration_squared_m2(const ClimbGeometry& geometry);

/// Throws SetupError if a length is not positive and finite, the centre of mass lies outside the
/// axles, the block is higher than climb_limit_m, or the nose cannot reach the ground behind it.
void check_climb(const ClimbGeometry& geometry, const Block& block);

}  // namespace tp100::model
