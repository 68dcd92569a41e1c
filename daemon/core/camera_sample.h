#pragma once
// What an overhead camera saw of the robot's marker: one detection.

#include <cstdint>

#include "core/time.h"

namespace tp100 {

/// Place and direction of the marker in the world frame, found through a plane homography at the
/// marker's height over a flat floor. Where the robot climbs or tilts, the marker leaves that
/// plane: the sample shows the shift, whoever uses it takes it out. Arrives late; `measured_ns` is
/// when the picture was taken.
struct CameraSample {
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;  ///< any branch
  HostNs measured_ns = 0;
  std::uint32_t sequence = 0;  ///< of the frame; grows
};

}  // namespace tp100
