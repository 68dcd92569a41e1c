#include "model/traction_monitor.h"

#include <cmath>

namespace tp100::model {
namespace {

// By rounding, a sum of equal steps may fall short of the time that they span.
constexpr double kRoundingS = 1e-9;

void gather(double& evidence_s, bool seen, double dt_s) {
  evidence_s = seen ? evidence_s + dt_s : 0.0;
}

bool enough(double evidence_s, double after_s) {
  return evidence_s > 0.0 && evidence_s >= after_s - kRoundingS;
}

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

}  // namespace tp100::model
