#include "estimation/odometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/arithmetic.h"

namespace tp100::estimation {
namespace {

constexpr double kKept = 0.97;  // share of the likelihoods kept from window to window

// No chip warms up faster than this from sample to sample: the sensor was reset or is faulty.
constexpr double kWarmingDegc = 1.0;
// Two windows belong to the same turn within this: the error of the wheelbase is the same in both.
constexpr double kSameTurnRadps = 0.05;
// Least sum of the tracks' speeds over the wheelbase of a robot that drives: some mm/s each.
constexpr double kDrivesRadps = 0.05;

static_assert(std::tuple_size_v<decltype(CarriedEstimate::mean)> == kStates &&
              std::tuple_size_v<decltype(CarriedEstimate::covariance)> == kStates * kStates);

}  // namespace

SlipWalk::SlipWalk(const LogLikelihoods& logs) : logs_(logs) { weigh(); }

void SlipWalk::add(double change, double noise_sd, double distance_m) {
  for (std::size_t i = 0; i < kCandidates; ++i) {
    // The means of a random walk over two adjacent windows differ by 2/3 of its step over one.
    const double variance = square(noise_sd) + square(kStepsRtm[i]) * distance_m * 2.0 / 3.0;
    logs_[i] = logs_[i] * kKept - (std::log(variance) + square(change) / variance) / 2.0;
  }
  const double highest = *std::max_element(logs_.begin(), logs_.end());
  for (double& log : logs_) log -= highest;
  weigh();
}

void SlipWalk::weigh() {
  double weights = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < kCandidates; ++i) {
    const double weight = std::exp(logs_[i]);
    weights += weight;
    squares += weight * square(kStepsRtm[i]);
  }
  step_rtm_ = std::sqrt(squares / weights);
}

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
  last_residual_ = Residual{};
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
  carried.slip_walk = slip_walk_.log_likelihoods();
  return carried;
}

CarriedEstimate Odometry::carried() const { return carry(state_); }

CarriedEstimate Odometry::carried_from(const Pose& start) const { return carry(state_at(start)); }

void Odometry::resume(const CarriedEstimate& carried) {
  restart_from({Eigen::Map<const StateVector>(carried.mean.data()),
                Eigen::Map<const StateMatrix>(carried.covariance.data())});
  slip_walk_ = SlipWalk(carried.slip_walk);
  motion_ = Motion{};
  twist_ = Twist{};
  turn_shape_filter_.restart();
}

void Odometry::compare_tracks_with_gyro() {
  if (!motion_.gyro || !shows_slip(motion_.ground)) {
    residual_window_ = disturbance_window_ = Window{};
    last_residual_ = Residual{};
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
    last_residual_ = Residual{};
  } else if (residual_window_.length_s() >= noise.residual_window_s) {
    take_residual(residual_window_.take());
  }
}

// Not for a robot that stands, which may be carried, or turns on the spot, which hides the slip.
void Odometry::take_residual(const Residual& now) {
  const auto yaw_radps = [](const Residual& of) {
    return of.gyro_z_radps - (of.right_radps - of.left_radps);
  };
  const auto both_radps = [](const Residual& of) { return of.right_radps + of.left_radps; };
  const Residual before = std::exchange(last_residual_, now);
  if (std::abs(both_radps(now)) < kDrivesRadps) return;
  motion_.has_residual = true;
  motion_.residual = now;
  motion_.turn_change =
      model_.turn_ratio(state_.mean, now) - model_.turn_ratio(state_.mean, before);

  const double both = std::abs(both_radps(now) + both_radps(before)) / 2.0;
  const double faster = std::abs(both_radps(now) - both_radps(before));
  const double turned = std::abs(now.gyro_z_radps - before.gyro_z_radps);
  if (faster > 0.2 * both || turned > kSameTurnRadps) return;
  const FilterParameters& noise = model_.noise();
  const double noise_radps =
      std::sqrt(2.0) * model_.residual_sd_radps(motion_) + noise.residual_share * turned;
  slip_walk_.add((yaw_radps(now) - yaw_radps(before)) / both, noise_radps / both,
                 both / 2.0 * model_.turn_of(motion_).wheelbase_m * noise.residual_window_s);
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
             .slip_walk_rtm = slip_walk_.step_rtm()};
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
  only_standstill.has_residual = only_standstill.disturbed = false;
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
