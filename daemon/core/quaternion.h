#pragma once
// Orientations as quaternions, for whoever outside does not count in angles.

#include <cmath>

#include "core/pose.h"

namespace tp100 {

/// A rotation, w last. Of length 1.
struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};

/// Of z-y-x Euler angles: first roll, then pitch, then yaw.
inline Quaternion quaternion(const Pose& pose) {
  const double cr = std::cos(pose.roll_rad / 2.0), sr = std::sin(pose.roll_rad / 2.0);
  const double cp = std::cos(pose.pitch_rad / 2.0), sp = std::sin(pose.pitch_rad / 2.0);
  const double cy = std::cos(pose.yaw_rad / 2.0), sy = std::sin(pose.yaw_rad / 2.0);
  return {.x = sr * cp * cy - cr * sp * sy,
          .y = cr * sp * cy + sr * cp * sy,
          .z = cr * cp * sy - sr * sp * cy,
          .w = cr * cp * cy + sr * sp * sy};
}

}  // namespace tp100
