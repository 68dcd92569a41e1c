#include "estimation/odometry.h"

#include <cmath>

namespace tp100::estimation {

const Twist& Odometry::advance(const BeltSpeeds& belts, double yaw_rate_radps, double dt_s,
                               double slope_rad) {
  twist_ = model::body_twist(parameters_, model::Mode::kExtended, belts.left_mps, belts.right_mps,
                             slope_rad);
  twist_.yaw_rate_radps = yaw_rate_radps;
  const bool turning = std::abs(yaw_rate_radps) > parameters_.turning_threshold_radps;
  const double slip_angle =
      turning ? parameters_.slip_angle_turning_rad : parameters_.slip_angle_straight_rad;
  twist_.vy_mps = twist_.vx_mps * std::tan(slip_angle) - parameters_.x_icr_m * yaw_rate_radps;
  model::advance(pose_, twist_, dt_s, slope_rad);
  return twist_;
}

const Twist& Odometry::advance_without_gyro(const BeltSpeeds& belts, double dt_s,
                                            double slope_rad) {
  twist_ = model::body_twist(parameters_, model::Mode::kExtended, belts.left_mps, belts.right_mps,
                             slope_rad);
  model::advance(pose_, twist_, dt_s, slope_rad);
  return twist_;
}

}  // namespace tp100::estimation
