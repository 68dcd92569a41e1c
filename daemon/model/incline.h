#pragma once
// What the ground does to the way that the belts make.

#include <cmath>

namespace tp100::model {

/// The ground under one interval. The defaults are a level plane of the robot's own surface.
struct Incline {
  double slope_rad = 0.0;    ///< climb angle along the robot; shifts the slip ratios
  double slip_offset = 0.0;  ///< of the surface, added to both slip ratios
  double planar = 1.0;       ///< planar way per way along the ground: cos(slope) on a ramp; while
                             ///< the body turns about an edge anything
};

/// A plane at a climb angle.
inline Incline inclined(double slope_rad) {
  return {.slope_rad = slope_rad, .planar = std::cos(slope_rad)};
}

}  // namespace tp100::model
