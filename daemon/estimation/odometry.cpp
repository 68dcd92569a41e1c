#include "estimation/odometry.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/arithmetic.h"

namespace tp100::estimation {
namespace {

// No chip warms up faster than this from sample to sample: the sensor was reset or is faulty.
constexpr double kWarmingDegc = 1.0;
// Least sum of the tracks' speeds over the wheelbase of a robot that drives: some mm/s each.
constexpr double kDrivesRadps = 0.05;

static_assert(std::tuple_size_v<decltype(CarriedEstimate::mean)> == kStates &&
              std::tuple_size_v<decltype(CarriedEstimate::covariance)> == kStates * kStates);

}  // namespace

void Odometry::Window::add(const Residual& rates, double dt_s) {
  sum_.left_radps += rates.left_radps * dt_s;
  sum_.right_radps += rates.right_radps * dt_s;
  sum_.gyro_z_radps += rates.gyro_z_radps * dt_s;
  length_s_ += dt_s;
}

Residual Odometry::Window::take() {
  const Residual mean{.left_radps = sum_.left_radps / length_s_,
                      .right_radps = sum_.right_radps / length_s_,
                      .gyro_z_radps = sum_.gyro_z_radps / length_s_};
  *this = Window{};
  return mean;
}

void Odometry::restart_from(const FilterState& state) {
  state_ = state;
  motion_.end_ns = 0;
  residual_window_ = disturbance_window_ = Window{};
}

FilterState Odometry::state_at(const Pose& start) const {
  FilterState state = state_;
  state.mean.head<3>() << start.x_m, start.y_m, start.yaw_rad;
  state.covariance.topRows<3>().setZero();
  state.covariance.leftCols<3>().setZero();
  const FilterParameters& noise = model_.noise();
  add_pose_variance(state.covariance, noise.start_sd_m, noise.start_sd_rad);
  return state;
}

void Odometry::begin(const Pose& start) { restart_from(state_at(start)); }

void Odometry::interrupt() {
  FilterState state = state_;
  model_.disturb(state);
  restart_from(state);
}

CarriedEstimate Odometry::carry(const FilterState& state) const {
  CarriedEstimate carried;
  Eigen::Map<StateVector>(carried.mean.data()) = state.mean;
  // It is symmetric: the order does not matter.
  Eigen::Map<StateMatrix>(carried.covariance.data()) = state.covariance;
  carried.track_trust = track_trust_.log_likelihoods();
  return carried;
}

CarriedEstimate Odometry::carried() const { return carry(state_); }

CarriedEstimate Odometry::carried_from(const Pose& start) const { return carry(state_at(start)); }

void Odometry::resume(const CarriedEstimate& carried) {
  restart_from({Eigen::Map<const StateVector>(carried.mean.data()),
                Eigen::Map<const StateMatrix>(carried.covariance.data())});
  track_trust_ = TrackTrust(carried.track_trust);
  motion_ = Motion{};
  twist_ = Twist{};
  turn_shape_filter_.restart();
}

void Odometry::compare_tracks_with_gyro() {
  if (!motion_.gyro || !shows_slip(motion_.ground)) {
    residual_window_ = disturbance_window_ = Window{};
    return;
  }
  const FilterParameters& noise = model_.noise();
  const double base_m = model_.turn_of(motion_).wheelbase_m;
  const TrackSpeeds expected = model::over_ground(motion_.tracks, motion_.ground.slip);
  const Residual rates{.left_radps = expected.left_mps / base_m,
                       .right_radps = expected.right_mps / base_m,
                       .gyro_z_radps = motion_.gyro_z_radps};
  residual_window_.add(rates, motion_.dt_s);
  disturbance_window_.add(rates, motion_.dt_s);
  if (disturbance_window_.length_s() >= noise.disturbance_window_s) {
    const double innovation = model_.innovation_radps(state_.mean, disturbance_window_.take());
    motion_.disturbed = std::abs(innovation) > noise.disturbance_radps;
  }
  if (motion_.disturbed) {
    residual_window_ = Window{};
  } else if (residual_window_.length_s() >= noise.residual_window_s) {
    take_residual(residual_window_.take());
  }
}

// Not for a robot that stands, which may be carried.
void Odometry::take_residual(const Residual& now) {
  if (std::abs(now.left_radps) + std::abs(now.right_radps) < kDrivesRadps) return;
  motion_.residual = now;
  Residual& residual = motion_.residual;
  residual.variance = square(model_.residual_sd_radps(motion_));
  const Measurement<1> seen = model_.measured(state_.mean, residual);
  const double slip = track_trust_.slip_information(), gain = track_trust_.gain_information();
  residual.variance += track_trust_.add(
      {.innovation = seen.innovation(0),
       .variance = innovation_covariance(covariance_with(state_.covariance, seen), seen)(0),
       .by_slip = seen.jacobian(0, kSlipDifference),
       .by_gain = seen.jacobian(0, kTurnGain)});
  residual.slip_information = track_trust_.slip_information() - slip;
  residual.gain_information = track_trust_.gain_information() - gain;
}

const Motion& Odometry::advance(const FilterInput& in) {
  // There is no pitch before the first interval.
  const double pitch_before_rad =
      motion_.dt_s > 0.0 ? motion_.ground.pitch_rad : in.ground.pitch_rad;
  // The clock relation may jump back a little; a motion must still end after the one before.
  motion_ = {.end_ns = std::max(in.end_ns, motion_.end_ns + 1),
             .dt_s = in.dt_s,
             .tracks = in.tracks,
             .gyro_z_radps = in.gyro_z_radps,
             .gyro = in.gyro,
             .warming_degc = std::abs(in.warming_degc) < kWarmingDegc ? in.warming_degc : 0.0,
             .ground = in.ground,
             .shift_scale = in.shift_scale};
  const TrackSpeeds over_ground = model_.over_ground(state_.mean, motion_);
  motion_.shape = turn_shape_filter_.update(over_ground.left_mps, over_ground.right_mps, in.dt_s);
  if (in.dt_s > 0.0)
    motion_.ground.tilt_radps = std::abs(in.ground.pitch_rad - pitch_before_rad) / in.dt_s;
  compare_tracks_with_gyro();
  model_.predict(state_, motion_);
  model_.measure(state_, motion_);
  twist_ = model_.twist(state_.mean, motion_);
  return motion_;
}

void Odometry::standstill(const RestRate& rest) {
  motion_.rest = rest;
  Motion only_standstill = motion_;
  only_standstill.residual = {};
  only_standstill.disturbed = false;
  model_.measure(state_, only_standstill);
}

void Odometry::correct(const FilterState& state) {
  state_ = state;
  twist_ = model_.twist(state_.mean, motion_);
}

Pose Odometry::pose() const {
  const Ground& ground = motion_.ground;
  return {.x_m = state_.mean[kX],
          .y_m = state_.mean[kY],
          .z_m = ground.z_m,
          .roll_rad = ground.roll_rad,
          .pitch_rad = ground.pitch_rad,
          .yaw_rad = state_.mean[kYaw]};
}

PlanarCovariance Odometry::pose_covariance() const { return pose_part(state_.covariance); }

PlanarCovariance Odometry::twist_covariance() const {
  if (motion_.dt_s > 0.0) return model_.twist_covariance(state_, motion_);
  return {.xx = kUnknownVariance, .yy = kUnknownVariance, .yaw_yaw = kUnknownVariance};
}

}  // namespace tp100::estimation
