#include "bridge/traction_estimator.h"

#include <cmath>

#include "core/arithmetic.h"

namespace tp100::bridge {
namespace {

// Because of rounding, a sum of equal steps may fall short of the time that they span.
constexpr double kRoundingS = 1e-9;

void gather(double& evidence_s, bool seen, double dt_s) {
  evidence_s = seen ? evidence_s + dt_s : 0.0;
}

bool enough(double evidence_s, double after_s) {
  return evidence_s > 0.0 && evidence_s >= after_s - kRoundingS;
}

// Beyond this mismatch over this distance, the robot is not where the tracks indicate.
constexpr double kMismatchRad = 10.0 * kRadPerDeg;
constexpr double kMismatchM = 0.12;

}  // namespace

Traction TractionMonitor::update(double track_mps, std::optional<double> ground_mps, double dt_s) {
  if (!std::isfinite(track_mps) || !(dt_s > 0.0) || !std::isfinite(dt_s)) return state_;
  if (std::abs(track_mps) < limits_.least_track_speed_mps) {
    reset();
    return state_;
  }
  if (!ground_mps || !std::isfinite(*ground_mps)) return state_;
  slip_ = 1.0 - *ground_mps / track_mps;

  // A robot that slides back against its tracks is no better than one at standstill.
  gather(standing_s_, slip_ > 1.0 - limits_.immobilised_share, dt_s);
  gather(slipping_s_, std::abs(slip_) > limits_.slipping_above, dt_s);
  gather(recovered_s_, std::abs(slip_) < limits_.recovered_below, dt_s);

  if (enough(standing_s_, limits_.immobilised_after_s)) {
    state_ = Traction::kImmobilised;
  } else if (enough(recovered_s_, limits_.recovered_after_s)) {
    state_ = Traction::kHolding;
  } else if (state_ == Traction::kHolding && enough(slipping_s_, limits_.slipping_after_s)) {
    state_ = Traction::kSlipping;
  }
  return state_;
}

std::optional<double> TractionEstimator::ground_mps(const TractionInput& in) {
  if (!in.camera || in.climbing) {
    window_open_ = judged_ = false;
    return std::nullopt;
  }
  if (!window_open_) {
    window_open_ = true;
    window_begin_ = in.fused;
    window_s_ = window_distance_m_ = 0.0;
    return judged_ ? std::optional(last_ground_mps_) : std::nullopt;
  }
  window_s_ += in.dt_s;
  window_distance_m_ += in.distance_m;
  if (window_s_ >= kWindowS) {
    const double dx = in.fused.x_m - window_begin_.x_m, dy = in.fused.y_m - window_begin_.y_m;
    last_ground_mps_ =
        (dx * std::cos(in.fused.yaw_rad) + dy * std::sin(in.fused.yaw_rad)) / window_s_;
    last_track_mps_ = window_distance_m_ / window_s_;
    judged_ = true;
    window_open_ = false;
  }
  return judged_ ? std::optional(last_ground_mps_) : std::nullopt;
}

Traction TractionEstimator::update(const TractionInput& in) {
  const std::optional<double> ground = ground_mps(in);
  const double track = judged_ ? last_track_mps_ : in.dt_s > 0.0 ? in.distance_m / in.dt_s : 0.0;
  state_ = monitor_.update(track, ground, in.dt_s);

  const bool mismatch =
      in.mapped_pitch_rad && std::abs(*in.mapped_pitch_rad - in.measured_pitch_rad) > kMismatchRad;
  mismatch_distance_m_ = mismatch ? mismatch_distance_m_ + std::abs(in.distance_m) : 0.0;
  if (mismatch_distance_m_ > kMismatchM) state_ = Traction::kImmobilised;
  return state_;
}

}  // namespace tp100::bridge
