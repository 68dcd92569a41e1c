#pragma once
// Pure pursuit: the circle through the robot that meets the path at a point ahead has the curvature
// 2 y / Ld^2 (Coulter 1992). Regulated: Ld grows with the speed, the tracker's speed falls in
// curves. It cuts corners by about curvature Ld^2 / 8, so Ld is a length for small arenas.

#include "control/law.h"

namespace tp100::control {

class PurePursuit final : public Law {
 public:
  PurePursuit(const Parameters& parameters, const BeltLimits& limits)
      : parameters_(parameters), yaw_kp_(limits.yaw_kp) {}

  double look_ahead_m(double speed_mps) const override;
  Steering steer(const PathErrors& errors) const override;

 private:
  Parameters parameters_;
  double yaw_kp_;
};

}  // namespace tp100::control
