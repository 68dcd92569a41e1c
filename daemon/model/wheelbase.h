#pragma once
// Equivalent wheelbase of a tracked robot, eq 7.

namespace tp100::model {

/// Geometry that eq 7 takes; the paper's table prints all but gamma.
struct WheelbaseGeometry {
  double length_m = 0.133;       ///< a, axle spacing
  double width_m = 0.160;        ///< b, distance between the belts
  double offset_x_m = 0.00174;   ///< centre of mass ahead of the middle
  double offset_y_m = -0.00137;  ///< centre of mass left of the middle
  double gamma = 8.049;          ///< ours: the value that gives the printed 0.2742 m
};

/// L = 2 ((b/2 - gamma dy)^2 + (a/2 - dx)^2) / (b/2 - gamma dy). [m]
double equivalent_wheelbase_m(const WheelbaseGeometry& geometry);

}  // namespace tp100::model
