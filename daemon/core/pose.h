#pragma once
// Pose and twist of the reference point, the centre of the tracks' footprint, and track speeds.
// Right-handed, x forward, y left, z up (REP-103); nose-up is negative pitch; yaw is unwrapped.
// Their planar transforms, and their orientation as a quaternion.

#include <cmath>

#include "core/arithmetic.h"
#include "core/fields.h"

namespace tp100 {

/// Position [m] and orientation [rad] in the world frame; z-y-x (yaw, pitch, roll) Euler angles.
struct Pose {
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;
};

/// Planar velocity in the body frame.
struct Twist {
  double vx_mps = 0.0;
  double vy_mps = 0.0;
  double yaw_rate_radps = 0.0;
};

TP100_FIELDS(Pose, x_m, y_m, z_m, roll_rad, pitch_rad, yaw_rad)
TP100_FIELDS(Twist, vx_mps, vy_mps, yaw_rate_radps)

/// Speeds of the tracks, forward positive.
struct TrackSpeeds {
  double left_mps = 0.0;
  double right_mps = 0.0;
};

/// A rotation about the origin, then a translation.
struct Transform2d {
  double x_m = 0.0;
  double y_m = 0.0;
  double turn_rad = 0.0;
  /// `pose` after the transform; height, pitch and roll stay.
  Pose of(const Pose& pose) const;
  /// The transform that takes `from` to `to`; its rotation is the shorter one.
  static Transform2d between(const Pose& from, const Pose& to);
};

inline Pose Transform2d::of(const Pose& pose) const {
  Pose out = pose;
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  // Without a rotation, nothing is rounded.
  out.x_m = (turn_rad == 0.0 ? pose.x_m : c * pose.x_m - s * pose.y_m) + x_m;
  out.y_m = (turn_rad == 0.0 ? pose.y_m : s * pose.x_m + c * pose.y_m) + y_m;
  out.yaw_rad = pose.yaw_rad + turn_rad;
  return out;
}

inline Transform2d Transform2d::between(const Pose& from, const Pose& to) {
  Transform2d transform;
  transform.turn_rad = wrap_angle(to.yaw_rad - from.yaw_rad);
  const Pose turned = transform.of(from);
  transform.x_m = to.x_m - turned.x_m;
  transform.y_m = to.y_m - turned.y_m;
  return transform;
}

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
