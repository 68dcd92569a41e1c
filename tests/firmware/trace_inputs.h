#pragma once
// Inputs of scripted runs. They are exact on every processor: no function of libm.

#include "support/wire_host.h"

namespace tp100::firmware {

/// Triangle wave over `i`, from 0 up first. [-1, 1]
inline double zigzag(int i, int period) {
  const double phase = static_cast<double>((i % period + period) % period) / period;
  return phase < 0.25 ? 4.0 * phase : phase < 0.75 ? 2.0 - 4.0 * phase : 4.0 * phase - 4.0;
}

/// Parameters in which left and right, and tight and wide turns, differ.
inline wire::Parameters uneven_parameters() {
  wire::Parameters p = test::good_parameters();
  p.wheelbase_m = 0.27f;
  p.wheelbase_tight_m = 0.31f;
  p.wheelbase_spin_m = 0.38f;
  p.turn_slip_share = 0.1f;
  p.slip_left = 0.17f;
  p.slip_right = 0.09f;
  p.stall_duty = 450;
  p.stall_ms = 700;
  return p;
}

}  // namespace tp100::firmware
