#pragma once
// Flat, climbing or descending, told from pitch.

#include "core/slope.h"
#include "estimation/parameters.h"

namespace tp100::estimation {

/// Enters a slope after it has lasted, leaves it at a smaller angle: noise and a bump change
/// nothing. No allocation; safe in the real-time thread.
class SlopeState {
 public:
  explicit SlopeState(const AttitudeParameters& parameters) : parameters_(parameters) {}

  /// One interval with the pitch of the body, nose-up negative.
  Slope update(double pitch_rad, double dt_s);
  Slope state() const { return state_; }

 private:
  AttitudeParameters parameters_;
  Slope state_ = Slope::kFlat;
  Slope candidate_ = Slope::kFlat;
  double lasted_s_ = 0.0;
};

}  // namespace tp100::estimation
