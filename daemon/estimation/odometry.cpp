#include "estimation/odometry.h"

#include <cmath>

namespace tp100::estimation {

model::TurnShape Odometry::shape(const TrackSpeeds& tracks, double dt_s) {
  return turn_monitor_.update(tracks.left_mps * (1.0 - parameters_.slip_left),
                              tracks.right_mps * (1.0 - parameters_.slip_right), dt_s);
}

const Twist& Odometry::advance(const TrackSpeeds& tracks, double yaw_rate_radps, double dt_s,
                               const model::Incline& incline) {
  const model::TurnShape shape = this->shape(tracks, dt_s);
  twist_ = model::body_twist(parameters_, model::Mode::kExtended, tracks.left_mps, tracks.right_mps,
                             incline, shape);
  twist_.yaw_rate_radps = yaw_rate_radps;
  const model::Turn turn = model::turn_of(parameters_, model::Mode::kExtended, shape);
  const double slip_angle = model::slip_angle_rad(parameters_, turn, yaw_rate_radps);
  twist_.vy_mps = twist_.vx_mps * std::tan(slip_angle) - turn.x_icr_m * yaw_rate_radps;
  model::advance(pose_, twist_, dt_s, incline);
  return twist_;
}

const Twist& Odometry::advance_without_gyro(const TrackSpeeds& tracks, double dt_s,
                                            const model::Incline& incline) {
  twist_ = model::body_twist(parameters_, model::Mode::kExtended, tracks.left_mps, tracks.right_mps,
                             incline, shape(tracks, dt_s));
  model::advance(pose_, twist_, dt_s, incline);
  return twist_;
}

}  // namespace tp100::estimation
