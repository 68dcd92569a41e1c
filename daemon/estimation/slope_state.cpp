#include "estimation/slope_state.h"

#include <cmath>

namespace tp100::estimation {

Slope SlopeState::update(double pitch_rad, double dt_s) {
  const double steep = std::abs(pitch_rad);
  const Slope side = pitch_rad < 0.0 ? Slope::kUp : Slope::kDown;
  Slope seen = Slope::kFlat;
  if (steep > parameters_.enter_slope_rad ||
      (side == state_ && steep > parameters_.leave_slope_rad))
    seen = side;
  if (seen == state_) {
    lasted_s_ = 0.0;
    candidate_ = seen;
    return state_;
  }
  lasted_s_ = seen == candidate_ ? lasted_s_ + dt_s : dt_s;
  candidate_ = seen;
  if (lasted_s_ >= parameters_.slope_lasts_s) {
    state_ = seen;
    lasted_s_ = 0.0;
  }
  return state_;
}

}  // namespace tp100::estimation
