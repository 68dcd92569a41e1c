#pragma once
// Settings of the tracking controller, the speed regulation and the aborts.

#include "core/angle.h"

namespace tp100::control {

struct Parameters {
  double preview_s = 0.06;             ///< loop and motor lag: the tangent is taken this much ahead
  double cross_track_gain_1pm = 16.0;  ///< k_e / (v + v_s) of the Stanley law
  double max_approach_rad = 35 * kRadPerDeg;  ///< bound of the cross-track correction
  double acceleration_mps2 = 0.15;            ///< along the path
  double min_speed_mps = 0.02;                ///< creep speed towards a stop
  double pivot_rate_radps = 0.6;
  double pivot_acceleration_radps2 = 1.5;
  double pivot_tolerance_rad = 0.9 * kRadPerDeg;
  double stop_tolerance_m = 0.003;
  double settle_s = 0.3;  ///< at rest within tolerances for this long: piece done
  double max_cross_track_m = 0.20;
  double max_heading_error_rad = 60 * kRadPerDeg;
  double max_tilt_rad = 50 * kRadPerDeg;
  double time_limit_factor = 3.0;  ///< times the nominal duration of the course
  double min_battery_v = 6.2;
  double stall_s = 1.0;
  double disagreement_radps = 0.6;  ///< gyro against encoders
  double disagreement_s = 1.0;
};

}  // namespace tp100::control
