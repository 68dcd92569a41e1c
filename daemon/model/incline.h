#pragma once
// Effect of the ground on the distance that the tracks drive.

#include <cmath>

namespace tp100::model {

/// The ground under one interval. The defaults are a level plane of the robot's own surface.
struct Incline {
  double slope_rad = 0.0;    ///< climb angle along the robot; shifts the slip ratios
  double slip_offset = 0.0;  ///< of the surface, added to both slip ratios
  /// Horizontal distance per distance along the slope, cos(slope) on a ramp; any value while the
  /// body rotates about an edge.
  double horizontal_fraction = 1.0;
};

/// A plane at a climb angle.
inline Incline inclined(double slope_rad) {
  return {.slope_rad = slope_rad, .horizontal_fraction = std::cos(slope_rad)};
}

}  // namespace tp100::model
