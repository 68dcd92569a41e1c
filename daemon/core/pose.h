#pragma once
// Pose and twist of the reference point: the centre of the belts' footprint.
// Right-handed, x forward, y left, z up (REP-103); nose-up is negative pitch; yaw is unwrapped.

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

}  // namespace tp100
