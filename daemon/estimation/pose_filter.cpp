#include "estimation/pose_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arithmetic.h"

namespace tp100::estimation {
namespace {

// Two outliers in a row hardly agree; two images of a robot that was moved do.
constexpr double kSameStoryM = 0.03;
constexpr double kSameStoryRad = 10.0 * kRadPerDeg;
// So many rejections in a row are no coincidence if the last one is not far away.
constexpr int kRejectionsInARow = 10;
// Farther from the estimate than this the robot was moved. Worn tracks slide up to 12 mm while they
// turn on the spot, and the smallest disturbance that the controller has to answer is 20 mm.
constexpr double kMovedM = 0.015;
constexpr double kMovedRad = 3.0 * kRadPerDeg;
// Error of the pitch while climbing a block and falling off it; the raised marker moves with it.
constexpr double kClimbingSdRad = 3.0 * kRadPerDeg;
// The attitude of a ground is that at one end of its interval.
constexpr double kAttitudeLateS = 0.005;

// A camera used this recently gives a better start position than placing by hand.
constexpr HostNs kFreshNs = 500 * kNsPerMs;
// The noise of the motion follows the camera's innovations: by this share for each sample, and so
// far at most.
constexpr double kScaleShare = 0.05, kMaxScale = 100.0;

/// The part of `motion` before `at_ns`; the rest keeps the measurements of the end.
Motion split(Motion& motion, HostNs begin_ns, HostNs at_ns) {
  const double share =
      static_cast<double>(at_ns - begin_ns) / static_cast<double>(motion.end_ns - begin_ns);
  Motion first = motion;
  first.end_ns = at_ns;
  first.dt_s = motion.dt_s * share;
  first.residual = {};
  first.disturbed = false;
  first.rest = RestRate{};
  motion.dt_s -= first.dt_s;
  return first;
}

}  // namespace

Eigen::Vector3d expected_marker(const Eigen::Vector3d& pose, const Ground& ground,
                                const CameraParameters& camera, const CameraPlace& place) {
  const double c = std::cos(pose[2]), s = std::sin(pose[2]);
  const double forward =
      camera.marker_height_m * std::cos(ground.roll_rad) * std::sin(ground.pitch_rad);
  const double left = -camera.marker_height_m * std::sin(ground.roll_rad);
  const double z =
      ground.z_m + camera.marker_height_m * std::cos(ground.roll_rad) * std::cos(ground.pitch_rad);
  const double from_x = pose[0] + c * forward - s * left - place.x_m;
  const double from_y = pose[1] + s * forward + c * left - place.y_m;
  const double plane = camera.height_m - camera.marker_height_m;
  const double depth = camera.height_m - z;
  const double scale = plane / depth;
  // A step along the marker's own axis, as it moves in the image: its far end is at another
  // height.
  const double level = std::cos(ground.pitch_rad) * scale;
  const double rise = -std::sin(ground.pitch_rad) * scale / depth;
  const double along_x = c * level + from_x * rise;
  const double along_y = s * level + from_y * rise;
  const double turned = std::atan2(along_y * c - along_x * s, along_x * c + along_y * s);
  return {place.x_m + from_x * scale, place.y_m + from_y * scale, pose[2] + turned};
}

bool CameraUpdate::contradicted(const Eigen::Vector3d& innovation) {
  const Eigen::Vector3d change = innovation - contradiction_;
  const bool same_story = magnitude(change[0], change[1]) < kSameStoryM &&
                          std::abs(wrap_angle(change[2])) < kSameStoryRad;
  contradictions_ = contradictions_ > 0 && same_story ? contradictions_ + 1 : 1;
  contradiction_ = innovation;
  return contradictions_ >= 2;
}

CameraVerdict CameraUpdate::apply(FilterState& state, const CameraSample& seen,
                                  const Ground& ground, const Twist& twist,
                                  const MotionModel& motion) {
  const Eigen::Vector3d expected = expected_marker(state.mean.head<3>(), ground, camera_, place_);
  Measurement<3> measured;
  measured.innovation << seen.x_m - expected[0], seen.y_m - expected[1],
      wrap_angle(seen.yaw_rad - expected[2]);
  measured.jacobian.setZero();
  measured.jacobian.leftCols<3>().setIdentity();
  const double attitude_sd_rad =
      magnitude(ground.hold_slip ? kClimbingSdRad : 0.0, ground.tilt_radps * kAttitudeLateS);
  const double leaning_sd_m = camera_.marker_height_m * attitude_sd_rad;
  const double place_variance = square(camera_.position_sd_m) + square(leaning_sd_m) +
                                square(twist.vx_mps * camera_.time_sd_s);
  const double yaw_variance =
      square(camera_.yaw_sd_rad) + square(twist.yaw_rate_radps * camera_.time_sd_s);
  measured.noise = Eigen::Vector3d(place_variance, place_variance, yaw_variance).asDiagonal();

  nis_ = normalized_innovation(state, measured);
  if (nis_ <= kNisGate) {
    contradictions_ = 0;
    rejections_ = 0;
    update(state, measured);
    return CameraVerdict::kUsed;
  }
  ++rejections_;
  const bool moved =
      nis_ > kNisTrigger && (magnitude(measured.innovation[0], measured.innovation[1]) > kMovedM ||
                             std::abs(measured.innovation[2]) > kMovedRad);
  if (!(moved ? contradicted(measured.innovation) : rejections_ >= kRejectionsInARow))
    return CameraVerdict::kRejected;
  contradictions_ = 0;
  rejections_ = 0;
  motion.disturb(state);
  update(state, measured);
  return moved ? CameraVerdict::kRecovered : CameraVerdict::kUsed;
}

PoseFilter::PoseFilter(const model::TrackParameters& tracks, const FilterParameters& noise,
                       const CameraParameters& camera, const CameraPlace& place)
    : odometry_(tracks, noise), camera_(camera, place), shared_sd_m_(camera.constant_sd_m) {}

bool PoseFilter::camera_sees(HostNs now) const {
  return camera_known_ && now - camera_ns_ < kFreshNs;
}

void PoseFilter::begin(const Pose& start, HostNs now) {
  nis_ = NisMean{};
  used_ = rejected_ = recoveries_ = 0;
  if (camera_sees(now)) {
    branch_rad_ = whole_turns(state().mean[kYaw], start.yaw_rad);
    return;
  }
  branch_rad_ = 0.0;
  odometry_.begin(start);
  past_.clear();
}

void PoseFilter::interrupt() {
  odometry_.interrupt();
  past_.clear();
  waiting_count_ = 0;
  camera_known_ = false;
}

CarriedFilter PoseFilter::carried() const {
  CarriedFilter state{.estimate = odometry_.carried(),
                      .branch_rad = branch_rad_,
                      .camera_ns = camera_ns_,
                      .last_seen_ns = last_seen_ns_,
                      .camera_known = camera_known_,
                      .nis = camera_.nis(),
                      .nis_sum = nis_.sum(),
                      .nis_count = nis_.count(),
                      .shift_scale = shift_scale_,
                      .camera_used = used_,
                      .camera_rejected = rejected_,
                      .recoveries = recoveries_};
  return state;
}

CarriedFilter PoseFilter::carried_from(const Pose& start, HostNs now) const {
  CarriedFilter state = carried();
  state.nis_sum = 0.0;
  state.nis_count = state.camera_used = state.camera_rejected = state.recoveries = 0;
  if (camera_sees(now)) {
    state.branch_rad = whole_turns(this->state().mean[kYaw], start.yaw_rad);
    return state;
  }
  state.branch_rad = 0.0;
  state.estimate = odometry_.carried_from(start);
  return state;
}

void PoseFilter::resume(const CarriedFilter& state) {
  odometry_.resume(state.estimate);
  past_.clear();
  waiting_count_ = 0;
  branch_rad_ = state.branch_rad;
  camera_ns_ = state.camera_ns;
  last_seen_ns_ = state.last_seen_ns;
  camera_known_ = state.camera_known;
  camera_.resume(state.nis);
  nis_ = NisMean(state.nis_count, state.nis_sum);
  shift_scale_ = state.shift_scale;
  used_ = state.camera_used;
  rejected_ = state.camera_rejected;
  recoveries_ = state.recoveries;
}

void PoseFilter::advance(const FilterInput& in) {
  if (past_.empty()) {
    // State at the beginning of the first interval, to which a camera sample within it rewinds.
    RewindEntry base;
    base.motion.end_ns = in.end_ns - from_s(in.dt_s);
    base.after = odometry_.state();
    past_.push(base);
  }
  RewindEntry step;
  FilterInput scaled = in;
  scaled.shift_scale = shift_scale_;
  step.motion = odometry_.advance(scaled);
  step.after = odometry_.state();
  past_.push(step);
  apply_waiting();
}

void PoseFilter::standstill(const RestRate& rest) {
  if (past_.empty()) return;
  odometry_.standstill(rest);
  past_.back().motion.rest = rest;
  past_.back().after = odometry_.state();
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
  const MotionModel& model = odometry_.model();
  model.predict(state, before);
  const Twist twist = model.twist(state.mean, before);
  const CameraVerdict verdict = camera_.apply(state, seen, before.ground, twist, model);
  // Omitting the samples that the gate rejects would make the mean too small, whatever the noise.
  if (camera_.nis() <= kNisTrigger) {
    nis_.add(camera_.nis());
    shift_scale_ = std::clamp(shift_scale_ * std::exp(kScaleShare * (camera_.nis() - kNisDegrees)),
                              1.0 / kMaxScale, kMaxScale);
  }
  if (verdict == CameraVerdict::kRejected) return false;
  if (verdict == CameraVerdict::kRecovered) ++recoveries_;
  ++used_;
  camera_ns_ = seen.measured_ns;
  camera_known_ = true;

  past_[at].motion = rest;
  at = past_.insert(at, {before, state});
  for (std::size_t i = at + 1; i < past_.size(); ++i) {
    past_[i].motion.shift_scale = shift_scale_;
    model.predict(state, past_[i].motion);
    model.measure(state, past_[i].motion);
    past_[i].after = state;
  }
  odometry_.correct(state);
  return true;
}

Pose PoseFilter::pose() const {
  Pose pose = odometry_.pose();
  pose.yaw_rad += branch_rad_;
  return pose;
}

double PoseFilter::camera_age_s(HostNs now) const {
  return camera_known_ ? to_s(now - camera_ns_) : std::numeric_limits<double>::infinity();
}

PlanarCovariance PoseFilter::pose_covariance() const {
  const double shared_m2 = camera_known_ ? square(shared_sd_m_) : 0.0;
  PlanarCovariance covariance = odometry_.pose_covariance();
  covariance.xx += shared_m2;
  covariance.yy += shared_m2;
  return covariance;
}

FilterFigures PoseFilter::figures(HostNs now) const {
  const model::Slip slip = odometry_.slip();
  return {.slip_left = slip.left,
          .slip_right = slip.right,
          .gyro_bias_radps = state().mean[kBias],
          .nis = camera_.nis(),
          .nis_mean = nis_.mean(),
          .nis_count = nis_.count(),
          .camera_age_us = camera_known_ ? (now - camera_ns_) / kNsPerUs : -1,
          .camera_used = used_,
          .camera_rejected = rejected_,
          .recoveries = recoveries_};
}

}  // namespace tp100::estimation
