#include "estimation/pose_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/angle.h"

namespace tp100::estimation {
namespace {

// A camera used this recently knows the start position better than the person who placed the robot.
constexpr HostNs kFreshNs = 500 * kNsPerMs;

/// The part of `motion` before `at_ns`; the rest keeps the measurements of the end.
Motion split(Motion& motion, HostNs begin_ns, HostNs at_ns) {
  const double share =
      static_cast<double>(at_ns - begin_ns) / static_cast<double>(motion.end_ns - begin_ns);
  Motion first = motion;
  first.end_ns = at_ns;
  first.dt_s = motion.dt_s * share;
  first.has_residual = false;
  first.standstill_sd_radps = 0.0;
  motion.dt_s -= first.dt_s;
  return first;
}

}  // namespace

PoseFilter::PoseFilter(const model::TrackParameters& tracks, const FilterParameters& noise,
                       const CameraParameters& camera, const CameraPlace& place)
    : motion_(tracks, noise),
      camera_(camera, place),
      noise_(noise),
      shared_sd_m_(camera.constant_sd_m),
      prior_{tracks.slip_left, tracks.slip_right} {
  StateVector sd;
  sd << noise.start_sd_m, noise.start_sd_m, noise.start_sd_rad, noise.bias_sd_radps, noise.slip_sd,
      noise.slip_sd;
  state_.mean << 0.0, 0.0, 0.0, 0.0, prior_.left, prior_.right;
  state_.covariance = sd.cwiseAbs2().asDiagonal();
}

void PoseFilter::restart_from(const FilterState& state) {
  state_ = state;
  past_.clear();
  window_ = Residual{};
  window_s_ = 0.0;
}

void PoseFilter::begin(const Pose& start, HostNs now) {
  nis_ = NisMean{};
  used_ = rejected_ = recoveries_ = 0;
  if (camera_known_ && now - camera_ns_ < kFreshNs) {
    branch_rad_ = std::round((start.yaw_rad - state_.mean[kYaw]) / (2.0 * kPi)) * 2.0 * kPi;
    return;
  }
  branch_rad_ = 0.0;
  FilterState state = state_;
  state.mean.head<3>() << start.x_m, start.y_m, start.yaw_rad;
  state.covariance.topRows<3>().setZero();
  state.covariance.leftCols<3>().setZero();
  state.covariance(kX, kX) = state.covariance(kY, kY) = square(noise_.start_sd_m);
  state.covariance(kYaw, kYaw) = square(noise_.start_sd_rad);
  restart_from(state);
}

void PoseFilter::interrupt() {
  FilterState state = state_;
  motion_.disturb(state);
  restart_from(state);
  waiting_count_ = 0;
  camera_known_ = false;
}

CarriedFilter PoseFilter::carried() const {
  CarriedFilter state{.branch_rad = branch_rad_,
                      .camera_ns = camera_ns_,
                      .last_seen_ns = last_seen_ns_,
                      .camera_known = camera_known_,
                      .nis = camera_.nis(),
                      .nis_sum = nis_.sum(),
                      .nis_count = nis_.count(),
                      .camera_used = used_,
                      .camera_rejected = rejected_,
                      .recoveries = recoveries_};
  Eigen::Map<StateVector>(state.mean.data()) = state_.mean;
  // It is symmetric: the order does not matter.
  Eigen::Map<StateMatrix>(state.covariance.data()) = state_.covariance;
  return state;
}

void PoseFilter::resume(const CarriedFilter& state) {
  restart_from({Eigen::Map<const StateVector>(state.mean.data()),
                Eigen::Map<const StateMatrix>(state.covariance.data())});
  twist_ = Twist{};
  ground_ = Ground{};
  turn_monitor_.restart();
  waiting_count_ = 0;
  branch_rad_ = state.branch_rad;
  camera_ns_ = state.camera_ns;
  last_seen_ns_ = state.last_seen_ns;
  camera_known_ = state.camera_known;
  camera_.resume(state.nis);
  nis_ = NisMean(state.nis_count, state.nis_sum);
  used_ = state.camera_used;
  rejected_ = state.camera_rejected;
  recoveries_ = state.recoveries;
}

void PoseFilter::add_to_window(Motion& motion) {
  if (!motion.gyro) {
    window_ = Residual{};
    window_s_ = 0.0;
    return;
  }
  window_.tracks.left_mps += motion.tracks.left_mps * motion.dt_s;
  window_.tracks.right_mps += motion.tracks.right_mps * motion.dt_s;
  window_.gyro_z_radps += motion.gyro_z_radps * motion.dt_s;
  window_s_ += motion.dt_s;
  if (window_s_ < noise_.residual_window_s) return;
  motion.has_residual = true;
  motion.residual = {
      .tracks = {window_.tracks.left_mps / window_s_, window_.tracks.right_mps / window_s_},
      .gyro_z_radps = window_.gyro_z_radps / window_s_};
  window_ = Residual{};
  window_s_ = 0.0;
}

void PoseFilter::advance(const FilterInput& in) {
  if (past_.empty()) {
    // Where the first interval begins: what a camera sample within it goes back to.
    RewindEntry base;
    base.motion.end_ns = in.end_ns - from_s(in.dt_s);
    base.after = state_;
    past_.push(base);
  }
  RewindEntry step;
  // The clock relation may jump back a little; a motion must still end after the one before.
  step.motion = {
      .end_ns = std::max(in.end_ns, past_.back().motion.end_ns + 1),
      .dt_s = in.dt_s,
      .tracks = in.tracks,
      .shape = turn_monitor_.update(in.tracks.left_mps * (1.0 - state_.mean[kSlipLeft]),
                                    in.tracks.right_mps * (1.0 - state_.mean[kSlipRight]), in.dt_s),
      .gyro_z_radps = in.gyro_z_radps,
      .gyro = in.gyro,
      .ground = in.ground};
  if (in.dt_s > 0.0)
    step.motion.ground.tilt_radps = std::abs(in.ground.pitch_rad - ground_.pitch_rad) / in.dt_s;
  add_to_window(step.motion);
  motion_.predict(state_, step.motion);
  motion_.measure(state_, step.motion);
  step.after = state_;
  past_.push(step);
  twist_ = motion_.twist(state_.mean, step.motion);
  ground_ = in.ground;
  apply_waiting();
}

void PoseFilter::standstill(double gyro_z_radps, double sd_radps) {
  if (past_.empty()) return;
  Motion& motion = past_.back().motion;
  motion.standstill_radps = gyro_z_radps;
  motion.standstill_sd_radps = sd_radps;
  Motion only_standstill = motion;
  only_standstill.has_residual = false;
  motion_.measure(state_, only_standstill);
  past_.back().after = state_;
}

void PoseFilter::camera(const CameraSample& seen) {
  if (!std::isfinite(seen.x_m) || !std::isfinite(seen.y_m) || !std::isfinite(seen.yaw_rad) ||
      seen.measured_ns <= last_seen_ns_ || waiting_count_ == kWaiting) {
    ++rejected_;
    return;
  }
  last_seen_ns_ = seen.measured_ns;
  waiting_[waiting_count_++] = seen;
  apply_waiting();
}

void PoseFilter::apply_waiting() {
  std::size_t done = 0;
  while (done < waiting_count_ && !past_.empty() &&
         waiting_[done].measured_ns <= past_.back().motion.end_ns) {
    if (!apply(waiting_[done])) ++rejected_;
    ++done;
  }
  for (std::size_t i = done; i < waiting_count_; ++i) waiting_[i - done] = waiting_[i];
  waiting_count_ -= done;
}

bool PoseFilter::apply(const CameraSample& seen) {
  std::size_t at = past_.find(seen.measured_ns);
  if (at == 0) return false;
  FilterState state = past_[at - 1].after;
  const HostNs begin_ns = past_[at - 1].motion.end_ns;
  Motion rest = past_[at].motion;
  const Motion before = split(rest, begin_ns, seen.measured_ns);
  motion_.predict(state, before);
  const Twist twist = motion_.twist(state.mean, before);
  const CameraVerdict verdict = camera_.apply(state, seen, before.ground, twist, motion_);
  // Omitting samples that the gate rejects would make every noise look smaller.
  if (camera_.nis() <= kNisTrigger) nis_.add(camera_.nis());
  if (verdict == CameraVerdict::kRejected) return false;
  if (verdict == CameraVerdict::kRecovered) ++recoveries_;
  ++used_;
  camera_ns_ = seen.measured_ns;
  camera_known_ = true;

  past_[at].motion = rest;
  at = past_.insert(at, {before, state});
  for (std::size_t i = at + 1; i < past_.size(); ++i) {
    motion_.predict(state, past_[i].motion);
    motion_.measure(state, past_[i].motion);
    past_[i].after = state;
  }
  state_ = state;
  twist_ = motion_.twist(state_.mean, past_.back().motion);
  return true;
}

Pose PoseFilter::pose() const {
  return {.x_m = state_.mean[kX],
          .y_m = state_.mean[kY],
          .z_m = ground_.z_m,
          .roll_rad = ground_.roll_rad,
          .pitch_rad = ground_.pitch_rad,
          .yaw_rad = state_.mean[kYaw] + branch_rad_};
}

double PoseFilter::camera_age_s(HostNs now) const {
  return camera_known_ ? to_s(now - camera_ns_) : std::numeric_limits<double>::infinity();
}

FilterFigures PoseFilter::figures(HostNs now) const {
  const double shared_m2 = camera_known_ ? square(shared_sd_m_) : 0.0;
  return {.variance_x_m2 = state_.covariance(kX, kX) + shared_m2,
          .variance_y_m2 = state_.covariance(kY, kY) + shared_m2,
          .variance_yaw_rad2 = state_.covariance(kYaw, kYaw),
          .slip_left = state_.mean[kSlipLeft],
          .slip_right = state_.mean[kSlipRight],
          .gyro_bias_radps = state_.mean[kBias],
          .nis = camera_.nis(),
          .nis_mean = nis_.mean(),
          .nis_count = nis_.count(),
          .camera_age_us = camera_known_ ? (now - camera_ns_) / kNsPerUs : -1,
          .camera_used = used_,
          .camera_rejected = rejected_,
          .recoveries = recoveries_};
}

}  // namespace tp100::estimation
