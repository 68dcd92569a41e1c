#include "estimation/motion.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "estimation/kalman.h"
#include "estimation/track_trust.h"
#include "shared/skid_steer.h"

namespace tp100::estimation {
namespace {

// Without a gyro the tracks' error counts as constant for this long.
constexpr double kTrackErrorS = 0.1;
// Standard deviation of the tracks' difference over a window, in edges: each track begins and ends
// the window between two edges.
const double kEdgeSd = std::sqrt(4.0 / 12.0);
constexpr double kMovingMps = 0.002;
// A body that tips over an edge moves sideways to its tracks. Slower rates are noise of the pitch.
constexpr double kTiltSdMRtrad = 0.01;
constexpr double kTippingRadps = 0.1;
constexpr double kLevelGroundRad = 1.0 * kRadPerDeg;

/// Shares of the expected distance that the tracks cover.
struct Shares {
  double left, right;
};
Shares shares(const StateVector& mean) {
  return {1.0 - mean[kCommonSlip] - mean[kSlipDifference],
          1.0 - mean[kCommonSlip] + mean[kSlipDifference]};
}

/// Adds to the uncertainty of the pose, without correlation with bias and slip.
void forget_place(FilterState& state, double sd_m, double sd_rad) {
  constexpr Eigen::Index kPose = kYaw + 1;
  StateMatrix& p = state.covariance;
  p.topRows<kPose>().rightCols<kStates - kPose>().setZero();
  p.bottomRows<kStates - kPose>().leftCols<kPose>().setZero();
  add_pose_variance(p, sd_m, sd_rad);
}

double both_mps(const Motion& motion) {
  return std::abs(motion.tracks.left_mps) + std::abs(motion.tracks.right_mps);
}
bool tracks_move(const Motion& motion) { return both_mps(motion) > 2.0 * kMovingMps; }

using PoseRows = Eigen::Matrix<double, kYaw + 1, kStates>;

/// F P F^T. `pose` are the first rows of F; of the others the bias follows the temperature, a part
/// of the common slip is `kept`, and the rest stays as it is: a product of 8 x 8 matrices would
/// cost ten times as much.
StateMatrix propagated(const StateMatrix& p, const PoseRows& pose, double warming_degc,
                       double kept) {
  StateMatrix rows = p;
  rows.topRows<PoseRows::RowsAtCompileTime>() = pose * p;
  rows.row(kBias) += warming_degc * p.row(kBiasPerDegc);
  rows.row(kCommonSlip) *= kept;
  StateMatrix moved = rows;
  moved.leftCols<PoseRows::RowsAtCompileTime>() = rows * pose.transpose();
  moved.col(kBias) += warming_degc * rows.col(kBiasPerDegc);
  moved.col(kCommonSlip) *= kept;
  return 0.5 * (moved + moved.transpose());
}

}  // namespace

double kept_slip(const FilterParameters& noise, const Motion& motion) {
  return motion.ground.hold_slip || !tracks_move(motion) ? 1.0
                                                         : std::exp(-motion.dt_s / noise.slip_s);
}

bool shows_slip(const Ground& ground) {
  return !ground.hold_slip && std::abs(ground.pitch_rad) < kLevelGroundRad &&
         std::abs(ground.roll_rad) < kLevelGroundRad;
}

ShiftVariance shift_variance(const FilterParameters& noise, double distance_m, double turn_rad,
                             const Motion& motion) {
  const double by_turning = square(noise.turn_sd_m_rtrad) * std::abs(turn_rad);
  const double along_sd = motion.ground.hold_slip ? noise.obstacle_sd_m_rtm : noise.along_sd_m_rtm;
  const double by_tilting =
      square(kTiltSdMRtrad) * std::max(motion.ground.tilt_radps - kTippingRadps, 0.0) * motion.dt_s;
  return {motion.shift_scale * (square(along_sd) * std::abs(distance_m) + by_turning + by_tilting),
          motion.shift_scale * (square(noise.across_sd_m_rtm) * std::abs(distance_m) + by_turning)};
}

FilterState MotionModel::prior() const {
  FilterState state;
  StateMatrix& p = state.covariance;
  add_pose_variance(p, noise_.start_sd_m, noise_.start_sd_rad);
  p(kBias, kBias) = square(noise_.bias_sd_radps);
  p(kCommonSlip, kCommonSlip) = square(noise_.slip_sd);
  p(kSlipDifference, kSlipDifference) = 1.0 / TrackTrust().slip_information();
  p(kTurnGain, kTurnGain) = 1.0 / TrackTrust().gain_information();
  p(kBiasPerDegc, kBiasPerDegc) = square(noise_.bias_per_degc_sd);
  return state;
}

model::Turn MotionModel::turn_of(const Motion& motion) const {
  return model::turn_of(tracks_, model::Mode::kExtended, motion.shape);
}

TrackSpeeds MotionModel::over_ground(const StateVector& mean, const Motion& motion) const {
  const TrackSpeeds expected = model::over_ground(motion.tracks, motion.ground.slip);
  const Shares covered = shares(mean);
  return {expected.left_mps * covered.left, expected.right_mps * covered.right};
}

model::Slip MotionModel::slip(const StateVector& mean, const Motion& motion) const {
  const Shares covered = shares(mean);
  return {1.0 - (1.0 - motion.ground.slip.left) * covered.left,
          1.0 - (1.0 - motion.ground.slip.right) * covered.right};
}

Twist MotionModel::twist(const StateVector& mean, const Motion& motion) const {
  const auto [left, right] = over_ground(mean, motion);
  const model::Turn turn = turn_of(motion);
  Twist twist;
  twist.vx_mps = (right + left) / 2.0 * (1.0 - turn.slip);
  twist.yaw_rate_radps = motion.gyro ? motion.gyro_z_radps - mean[kBias]
                                     : shared::turn_of<double>({left, right}, turn.wheelbase_m) *
                                           (1.0 + mean[kTurnGain]);
  twist.vy_mps =
      twist.vx_mps * std::tan(model::slip_angle_rad(tracks_, turn, twist.yaw_rate_radps)) -
      turn.x_icr_m * twist.yaw_rate_radps;
  return twist;
}

PlanarCovariance MotionModel::twist_covariance(const FilterState& state,
                                               const Motion& motion) const {
  const double dt = motion.dt_s;
  const Twist twist = this->twist(state.mean, motion);
  const model::Turn turn = turn_of(motion);
  const auto [left, right] = model::over_ground(motion.tracks, motion.ground.slip);

  // Derivatives of forward speed and yaw rate by the state, as in twist().
  Eigen::Matrix<double, 2, kStates> by_state = Eigen::Matrix<double, 2, kStates>::Zero();
  by_state(0, kCommonSlip) = -(right + left) / 2.0 * (1.0 - turn.slip);
  by_state(0, kSlipDifference) = (right - left) / 2.0 * (1.0 - turn.slip);
  // An interval of a track begins and ends between two edges.
  const double edges_mps2 = square(noise_.edge_m / dt) / 6.0;
  const double rate = std::abs(twist.yaw_rate_radps);
  double rate_variance = 0.0;
  if (motion.gyro) {
    by_state(1, kBias) = -1.0;
    rate_variance = square(noise_.gyro_sd_rad_rts) / dt + square(noise_.gyro_scale_sd * rate);
  } else {
    const double gain = (1.0 + state.mean[kTurnGain]) / turn.wheelbase_m;
    const TrackSpeeds ground = over_ground(state.mean, motion);
    by_state(1, kCommonSlip) = -(right - left) * gain;
    by_state(1, kSlipDifference) = (right + left) * gain;
    by_state(1, kTurnGain) = (ground.right_mps - ground.left_mps) / turn.wheelbase_m;
    rate_variance = square(noise_.track_error_radps + noise_.track_error_share * rate) +
                    2.0 * edges_mps2 * square(gain);
  }
  Eigen::Matrix2d by = by_state * state.covariance * by_state.transpose();
  by(0, 0) += edges_mps2 / 2.0;
  by(1, 1) += rate_variance;

  // Derivatives of the sideways speed by these two, as in twist().
  const double of_speed = std::tan(model::slip_angle_rad(tracks_, turn, twist.yaw_rate_radps));
  const double of_rate = -turn.x_icr_m;
  const auto [along, across] =
      shift_variance(noise_, twist.vx_mps * dt, twist.yaw_rate_radps * dt, motion);
  return {.xx = by(0, 0) + along / square(dt),
          .xy = of_speed * by(0, 0) + of_rate * by(0, 1),
          .x_yaw = by(0, 1),
          .yy = square(of_speed) * by(0, 0) + 2.0 * of_speed * of_rate * by(0, 1) +
                square(of_rate) * by(1, 1) + across / square(dt),
          .y_yaw = of_speed * by(0, 1) + of_rate * by(1, 1),
          .yaw_yaw = by(1, 1)};
}

double MotionModel::innovation_radps(const StateVector& mean, const Residual& residual) const {
  const Shares covered = shares(mean);
  const double left = residual.left_radps * covered.left;
  const double right = residual.right_radps * covered.right;
  return residual.gyro_z_radps - (right - left) * (1.0 + mean[kTurnGain]) - mean[kBias];
}

double MotionModel::residual_sd_radps(const Motion& motion) const {
  const double edge_radps =
      noise_.edge_m / (turn_of(motion).wheelbase_m * noise_.residual_window_s);
  return magnitude(noise_.residual_sd_radps, kEdgeSd * edge_radps);
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

  // Derivatives of the position by speed and by yaw rate.
  const model::Turn shape = turn_of(motion);
  const double horizontal_fraction = motion.ground.horizontal_fraction;
  const double sideways = std::tan(model::slip_angle_rad(tracks_, shape, twist.yaw_rate_radps));
  const double x_by_speed = dt * (1.0 - shape.slip) * (horizontal_fraction * c - sideways * s);
  const double y_by_speed = dt * (1.0 - shape.slip) * (horizontal_fraction * s + sideways * c);
  const double x_by_rate = dt * (-dy / 2.0 + shape.x_icr_m * s);
  const double y_by_rate = dt * (dx / 2.0 - shape.x_icr_m * c);

  const bool moves = tracks_move(motion);
  const double kept = kept_slip(noise_, motion);

  // Rows of the pose in the Jacobian.
  PoseRows f = PoseRows::Identity();
  f(kX, kYaw) = -dy;
  f(kY, kYaw) = dx;
  const auto by_rate = [&](Eigen::Index of, double rate) {
    f(kX, of) += x_by_rate * rate;
    f(kY, of) += y_by_rate * rate;
    f(kYaw, of) += dt * rate;
  };
  const auto by_slip = [&](Eigen::Index of, double speed_mps, double difference_mps) {
    f(kX, of) = x_by_speed * speed_mps;
    f(kY, of) = y_by_speed * speed_mps;
    if (!motion.gyro)
      by_rate(of, difference_mps / shape.wheelbase_m * (1.0 + state.mean[kTurnGain]));
  };
  if (motion.gyro) by_rate(kBias, -1.0);
  const auto [left, right] = model::over_ground(motion.tracks, motion.ground.slip);
  by_slip(kCommonSlip, -(right + left) / 2.0, -(right - left));
  by_slip(kSlipDifference, (right - left) / 2.0, right + left);
  if (!motion.gyro) {
    const TrackSpeeds ground = over_ground(state.mean, motion);
    by_rate(kTurnGain, (ground.right_mps - ground.left_mps) / shape.wheelbase_m);
  }

  const double rate = std::abs(twist.yaw_rate_radps);
  const double yaw =
      motion.gyro ? (square(noise_.gyro_sd_rad_rts) +
                     square(noise_.gyro_scale_sd * rate) * noise_.gyro_scale_s) *
                        dt
                  : (moves ? square(noise_.track_error_radps + noise_.track_error_share * rate) *
                                 kTrackErrorS * dt
                           : 0.0);

  state.mean[kX] = pose.x_m;
  state.mean[kY] = pose.y_m;
  state.mean[kYaw] = pose.yaw_rad;
  state.mean[kBias] += state.mean[kBiasPerDegc] * motion.warming_degc;
  state.mean[kCommonSlip] *= kept;

  StateMatrix& p = state.covariance;
  p = propagated(p, f, motion.warming_degc, kept);
  add_shift(p, shift_variance(noise_, twist.vx_mps * dt, turn, motion), c, s);
  p(kYaw, kYaw) += yaw;
  p(kBias, kBias) += square(noise_.bias_walk_radps_rts) * dt;
  p(kCommonSlip, kCommonSlip) += motion.shift_scale * square(noise_.slip_sd) * (1.0 - kept * kept);
}

void MotionModel::measure(FilterState& state, const Motion& motion) const {
  if (motion.rest.sd_radps > 0.0) {
    Measurement<1> rest;
    rest.innovation << motion.rest.radps - state.mean[kBias];
    rest.jacobian.setZero();
    rest.jacobian(0, kBias) = 1.0;
    rest.noise << square(motion.rest.sd_radps);
    update(state, rest);
  }
  // The gyro measured the turn, so the yaw stays almost as certain.
  if (motion.disturbed) forget_place(state, noise_.disturbance_sd_m, noise_.disturbance_sd_rad);
  const Residual& seen = motion.residual;
  if (seen.variance <= 0.0) return;
  // The position is not corrected: a small correction of the direction over the whole distance
  // driven would move it by millimetres with every encoder edge, and the controller would follow.
  const auto near_zero = [&](Eigen::Index of, double information) {
    if (information == 0.0) return;
    Measurement<1> none;
    none.innovation << -state.mean[of];
    none.jacobian.setZero();
    none.jacobian(0, of) = 1.0;
    none.noise << 1.0 / information;
    update(state, none, kYaw);
  };
  near_zero(kSlipDifference, seen.slip_information);
  near_zero(kTurnGain, seen.gain_information);
  update(state, measured(state.mean, seen), kYaw);
}

Measurement<1> MotionModel::measured(const StateVector& mean, const Residual& seen) const {
  Measurement<1> residual;
  residual.innovation << innovation_radps(mean, seen);
  const Shares covered = shares(mean);
  // The derivative by the common slip is left 0: an error of the turn gain would change the
  // distance.
  residual.jacobian.setZero();
  residual.jacobian(0, kBias) = 1.0;
  residual.jacobian(0, kSlipDifference) =
      (seen.left_radps + seen.right_radps) * (1.0 + mean[kTurnGain]);
  residual.jacobian(0, kTurnGain) =
      seen.right_radps * covered.right - seen.left_radps * covered.left;
  residual.noise << seen.variance;
  return residual;
}

void MotionModel::disturb(FilterState& state) const {
  forget_place(state, noise_.disturbed_sd_m, noise_.disturbed_sd_rad);
}

}  // namespace tp100::estimation
