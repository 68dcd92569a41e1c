#include "estimation/motion.h"

#include <algorithm>
#include <cmath>

#include "estimation/kalman.h"

namespace tp100::estimation {
namespace {

// A yaw rate of the tracks that is off by more than this many standard deviations is ignored.
constexpr double kResidualGate = 10.8;
// Without a gyro the tracks' error counts as constant for this long.
constexpr double kTrackErrorS = 0.1;
constexpr double kMovingMps = 0.002;
// A body that tips over an edge moves sideways to its tracks. Slower rates are noise of the pitch.
constexpr double kTiltSdMRtrad = 0.01;
constexpr double kTippingRadps = 0.1;

}  // namespace

model::Turn MotionModel::turn_of(const Motion& motion) const {
  return model::turn_of(tracks_, model::Mode::kExtended, motion.shape);
}

Twist MotionModel::twist(const StateVector& mean, const Motion& motion) const {
  const double left = motion.tracks.left_mps * (1.0 - mean[kSlipLeft]);
  const double right = motion.tracks.right_mps * (1.0 - mean[kSlipRight]);
  const model::Turn turn = turn_of(motion);
  Twist twist;
  twist.vx_mps = (right + left) / 2.0 * (1.0 - turn.slip);
  twist.yaw_rate_radps =
      motion.gyro ? motion.gyro_z_radps - mean[kBias] : (right - left) / turn.wheelbase_m;
  twist.vy_mps =
      twist.vx_mps * std::tan(model::slip_angle_rad(tracks_, turn, twist.yaw_rate_radps)) -
      turn.x_icr_m * twist.yaw_rate_radps;
  return twist;
}

void MotionModel::predict(FilterState& state, const Motion& motion) const {
  const double dt = motion.dt_s;
  const Twist twist = this->twist(state.mean, motion);
  Pose pose{.x_m = state.mean[kX], .y_m = state.mean[kY], .yaw_rad = state.mean[kYaw]};
  model::advance(pose, twist, dt, {.horizontal_fraction = motion.ground.horizontal_fraction});
  const double dx = pose.x_m - state.mean[kX];
  const double dy = pose.y_m - state.mean[kY];
  const double turn = twist.yaw_rate_radps * dt;
  const double middle = state.mean[kYaw] + turn / 2.0;
  const double c = std::cos(middle), s = std::sin(middle);

  // Effect of a change of speed and of yaw rate on the position.
  const model::Turn shape = turn_of(motion);
  const double horizontal_fraction = motion.ground.horizontal_fraction;
  const double sideways = std::tan(model::slip_angle_rad(tracks_, shape, twist.yaw_rate_radps));
  const double x_by_speed = dt * (1.0 - shape.slip) * (horizontal_fraction * c - sideways * s);
  const double y_by_speed = dt * (1.0 - shape.slip) * (horizontal_fraction * s + sideways * c);
  const double x_by_rate = dt * (-dy / 2.0 + shape.x_icr_m * s);
  const double y_by_rate = dt * (dx / 2.0 - shape.x_icr_m * c);

  const bool moves = std::abs(motion.tracks.left_mps) > kMovingMps ||
                     std::abs(motion.tracks.right_mps) > kMovingMps;
  const bool held = motion.ground.hold_slip || !moves;
  const double kept = held ? 1.0 : std::exp(-dt / noise_.slip_s);

  StateMatrix f = StateMatrix::Identity();
  f(kX, kYaw) = -dy;
  f(kY, kYaw) = dx;
  const auto by_rate = [&](Eigen::Index of, double rate) {
    f(kX, of) += x_by_rate * rate;
    f(kY, of) += y_by_rate * rate;
    f(kYaw, of) += dt * rate;
  };
  const auto by_slip = [&](Eigen::Index of, double track_mps, double rate) {
    f(kX, of) = -x_by_speed * track_mps / 2.0;
    f(kY, of) = -y_by_speed * track_mps / 2.0;
    f(of, of) = kept;
    if (!motion.gyro) by_rate(of, rate);
  };
  if (motion.gyro) by_rate(kBias, -1.0);
  by_slip(kSlipLeft, motion.tracks.left_mps, motion.tracks.left_mps / shape.wheelbase_m);
  by_slip(kSlipRight, motion.tracks.right_mps, -motion.tracks.right_mps / shape.wheelbase_m);

  const double way = std::abs(twist.vx_mps) * dt;
  const double by_turning = square(noise_.turn_sd_m_rtrad) * std::abs(turn);
  const double along =
      square(motion.ground.hold_slip ? noise_.obstacle_sd_m_rtm : noise_.along_sd_m_rtm) * way +
      by_turning +
      square(kTiltSdMRtrad) * std::max(motion.ground.tilt_radps - kTippingRadps, 0.0) * dt;
  const double across = square(noise_.across_sd_m_rtm) * way + by_turning;
  const double rate = std::abs(twist.yaw_rate_radps);
  const double yaw =
      motion.gyro ? (square(noise_.gyro_sd_rad_rts) +
                     square(noise_.gyro_scale_sd * rate) * noise_.gyro_scale_s) *
                        dt
                  : (moves ? square(noise_.residual_sd_radps + noise_.residual_share * rate) *
                                 kTrackErrorS * dt
                           : 0.0);

  state.mean[kX] = pose.x_m;
  state.mean[kY] = pose.y_m;
  state.mean[kYaw] = pose.yaw_rad;
  const model::Slip& slip = motion.ground.slip;
  state.mean[kSlipLeft] = slip.left + (state.mean[kSlipLeft] - slip.left) * kept;
  state.mean[kSlipRight] = slip.right + (state.mean[kSlipRight] - slip.right) * kept;

  const StateMatrix moved = f * state.covariance * f.transpose();
  StateMatrix& p = state.covariance;
  p = (moved + moved.transpose()) / 2.0;
  p(kX, kX) += along * c * c + across * s * s;
  p(kY, kY) += along * s * s + across * c * c;
  p(kX, kY) += (along - across) * c * s;
  p(kY, kX) += (along - across) * c * s;
  p(kYaw, kYaw) += yaw;
  p(kBias, kBias) += square(noise_.bias_walk_radps_rts) * dt;
  p(kSlipLeft, kSlipLeft) += square(noise_.slip_sd) * (1.0 - kept * kept);
  p(kSlipRight, kSlipRight) += square(noise_.slip_sd) * (1.0 - kept * kept);
}

void MotionModel::measure(FilterState& state, const Motion& motion) const {
  if (motion.standstill_sd_radps > 0.0) {
    Measurement<1> rest;
    rest.innovation << motion.standstill_radps - state.mean[kBias];
    rest.jacobian.setZero();
    rest.jacobian(0, kBias) = 1.0;
    rest.noise << square(motion.standstill_sd_radps);
    update(state, rest);
  }
  if (!motion.has_residual || motion.ground.hold_slip) return;
  const Residual& seen = motion.residual;
  const double left = seen.tracks.left_mps, right = seen.tracks.right_mps;
  const double base = turn_of(motion).wheelbase_m;
  const double by_tracks =
      (right * (1.0 - state.mean[kSlipRight]) - left * (1.0 - state.mean[kSlipLeft])) / base;
  Measurement<1> residual;
  residual.innovation << seen.gyro_z_radps - by_tracks - state.mean[kBias];
  if (std::abs(residual.innovation[0]) > noise_.disturbance_radps) {
    disturb(state);
    return;
  }
  residual.jacobian.setZero();
  residual.jacobian(0, kBias) = 1.0;
  residual.jacobian(0, kSlipLeft) = left / base;
  residual.jacobian(0, kSlipRight) = -right / base;
  const double rate = std::abs(seen.gyro_z_radps - state.mean[kBias]);
  residual.noise << square(noise_.residual_sd_radps + noise_.residual_share * rate);
  if (normalized_innovation(state, residual) < kResidualGate) update(state, residual);
}

void MotionModel::disturb(FilterState& state) const {
  constexpr Eigen::Index kPose = kYaw + 1;
  StateMatrix& p = state.covariance;
  p.topRows<kPose>().rightCols<kStates - kPose>().setZero();
  p.bottomRows<kStates - kPose>().leftCols<kPose>().setZero();
  p(kX, kX) += square(noise_.disturbed_sd_m);
  p(kY, kY) += square(noise_.disturbed_sd_m);
  p(kYaw, kYaw) += square(noise_.disturbed_sd_rad);
}

}  // namespace tp100::estimation
