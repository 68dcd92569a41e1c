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

// Share of the tracks' speed below which the robot counts as standing still.
constexpr double kImmobilisedShare = 0.2;
// |slip| that counts as slipping (the paper's steepest ramp has 0.26), and at which that and a
// standstill end, each after this time.
constexpr double kSlipping = 0.4, kRecovered = 0.3, kAfterS = 0.1;
// Slower tracks give no evidence.
constexpr double kLeastTrackMps = 0.02;

// Beyond this mismatch over this distance, the robot is not where the tracks indicate.
constexpr double kMismatchRad = 10.0 * kRadPerDeg;
constexpr double kMismatchM = 0.12;

}  // namespace

void TractionEstimator::judge(double track_mps, std::optional<double> ground_mps, double dt_s) {
  if (!std::isfinite(track_mps) || !(dt_s > 0.0) || !std::isfinite(dt_s)) return;
  if (std::abs(track_mps) < kLeastTrackMps) {
    by_speed_ = Traction::kHolding;
    standing_s_ = slipping_s_ = recovered_s_ = 0.0;
    return;
  }
  if (!ground_mps || !std::isfinite(*ground_mps)) return;
  const double slip = 1.0 - *ground_mps / track_mps;

  // A robot that slides back against its tracks is no better than one at standstill.
  gather(standing_s_, slip > 1.0 - kImmobilisedShare, dt_s);
  gather(slipping_s_, std::abs(slip) > kSlipping, dt_s);
  gather(recovered_s_, std::abs(slip) < kRecovered, dt_s);

  if (enough(standing_s_, kImmobilisedAfterS)) {
    by_speed_ = Traction::kImmobilised;
  } else if (enough(recovered_s_, kAfterS)) {
    by_speed_ = Traction::kHolding;
  } else if (by_speed_ == Traction::kHolding && enough(slipping_s_, kAfterS)) {
    by_speed_ = Traction::kSlipping;
  }
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
  judge(track, ground, in.dt_s);
  state_ = by_speed_;

  const bool mismatch =
      in.mapped_pitch_rad && std::abs(*in.mapped_pitch_rad - in.measured_pitch_rad) > kMismatchRad;
  mismatch_distance_m_ = mismatch ? mismatch_distance_m_ + std::abs(in.distance_m) : 0.0;
  if (mismatch_distance_m_ > kMismatchM) state_ = Traction::kImmobilised;
  return state_;
}

}  // namespace tp100::bridge
