#pragma once
// Slip ratio against slope: the paper's table, straight climb at 0.10 m/s.

namespace tp100::model {

/// Slip ratios of both belts.
struct SlipPair {
  double left = 0.0;
  double right = 0.0;
  bool outside = false;  ///< the slope lies outside the table and its end was used
};

/// Linear interpolation in the paper's table. `slope_rad`: climb angle, 0..28 deg inside. Pure.
SlipPair slip_at_slope(double slope_rad);

}  // namespace tp100::model
