#pragma once
// The desired-yaw law: the tangent a little ahead, less atan(k_e e / (v + v_s)) (Hoffmann and
// others, Autonomous automobile trajectory tracking for off-road driving, 2007), less the slip
// angle. Looks ahead only by the robot's lag: it cuts no corner.

#include "control/law.h"

namespace tp100::control {

class Stanley final : public Law {
 public:
  explicit Stanley(const Parameters& parameters) : parameters_(parameters) {}

  double look_ahead_m(double speed_mps) const override;
  Steering steer(const PathErrors& errors) const override;

 private:
  Parameters parameters_;
};

}  // namespace tp100::control
