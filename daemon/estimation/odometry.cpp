#include "estimation/odometry.h"

#include <cmath>

namespace tp100::estimation {

const Twist& Odometry::advance(const BeltSpeeds& belts, double yaw_rate_radps, double dt_s,
                               const model::Incline& incline) {
  twist_ = model::body_twist(parameters_, model::Mode::kExtended, belts.left_mps, belts.right_mps,
                             incline);
  twist_.yaw_rate_radps = yaw_rate_radps;
  const bool turning = std::abs(yaw_rate_radps) > parameters_.turning_threshold_radps;
  const double slip_angle =
      turning ? parameters_.slip_angle_turning_rad : parameters_.slip_angle_straight_rad;
  twist_.vy_mps = twist_.vx_mps * std::tan(slip_angle) - parameters_.x_icr_m * yaw_rate_radps;
  model::advance(pose_, twist_, dt_s, incline);
  return twist_;
}

const Twist& Odometry::advance_without_gyro(const BeltSpeeds& belts, double dt_s,
                                            const model::Incline& incline) {
  twist_ = model::body_twist(parameters_, model::Mode::kExtended, belts.left_mps, belts.right_mps,
                             incline);
  model::advance(pose_, twist_, dt_s, incline);
  return twist_;
}

void Odometry::stand(double z_m, double roll_rad, double pitch_rad) {
  pose_.z_m = z_m;
  pose_.roll_rad = roll_rad;
  pose_.pitch_rad = pitch_rad;
}

}  // namespace tp100::estimation
