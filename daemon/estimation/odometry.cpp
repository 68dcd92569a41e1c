#include "estimation/odometry.h"

#include <cmath>

namespace tp100::estimation {

model::TurnShape Odometry::shape(const BeltSpeeds& belts, double dt_s) {
  return turn_watch_.update(belts.left_mps * (1.0 - parameters_.slip_left),
                            belts.right_mps * (1.0 - parameters_.slip_right), dt_s);
}

const Twist& Odometry::advance(const BeltSpeeds& belts, double yaw_rate_radps, double dt_s,
                               const model::Incline& incline) {
  const model::TurnShape shape = this->shape(belts, dt_s);
  twist_ = model::body_twist(parameters_, model::Mode::kExtended, belts.left_mps, belts.right_mps,
                             incline, shape);
  twist_.yaw_rate_radps = yaw_rate_radps;
  const bool turning = std::abs(yaw_rate_radps) > parameters_.turning_threshold_radps;
  const double slip_angle =
      turning ? parameters_.slip_angle_turning_rad : parameters_.slip_angle_straight_rad;
  const model::Turn turn = model::turn_of(parameters_, model::Mode::kExtended, shape);
  twist_.vy_mps = twist_.vx_mps * std::tan(slip_angle) - turn.x_icr_m * yaw_rate_radps;
  model::advance(pose_, twist_, dt_s, incline);
  return twist_;
}

const Twist& Odometry::advance_without_gyro(const BeltSpeeds& belts, double dt_s,
                                            const model::Incline& incline) {
  twist_ = model::body_twist(parameters_, model::Mode::kExtended, belts.left_mps, belts.right_mps,
                             incline, shape(belts, dt_s));
  model::advance(pose_, twist_, dt_s, incline);
  return twist_;
}

}  // namespace tp100::estimation
