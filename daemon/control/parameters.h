#pragma once
// Settings of the tracking controller, the speed regulation and the aborts.

#include <array>

#include "core/arithmetic.h"
#include "core/enum_names.h"

namespace tp100::control {

/// Steering law on lines and arcs.
enum class LawName { kStanley, kPurePursuit, kLqr };
/// Names as in files.
inline constexpr std::array<EnumName<LawName>, 3> kLawNames = {{
    {LawName::kStanley, "stanley"},
    {LawName::kPurePursuit, "pure-pursuit"},
    {LawName::kLqr, "lqr"},
}};

struct Parameters {
  LawName law = LawName::kStanley;
  double preview_s = 0.06;            ///< loop and motor lag: the tangent is taken this much ahead
  double cross_track_gain_1ps = 3.6;  ///< Stanley: k_e
  double soft_speed_mps = 0.05;       ///< ... and v_s: approach atan(k_e e / (v + v_s))
  double max_approach_rad = 24 * kRadPerDeg;  ///< bound of the cross-track correction
  double pursuit_s = 0.8;                     ///< pure pursuit: look-ahead as the distance driven
                                              ///< in this time, ...
  double pursuit_min_m = 0.05;                ///< ... not shorter
  double pursuit_max_m = 0.15;                ///< ... and not longer
  double lqr_cross_track_m = 0.01;            ///< LQR: errors and turn rate that have equal weight
  double lqr_heading_rad = 15 * kRadPerDeg;
  double lqr_turn_radps = 0.6;
  double acceleration_mps2 = 0.15;    ///< along the path
  double full_speed_radius_m = 0.15;  ///< in narrower curves the speed falls with the radius
  double min_speed_mps = 0.02;        ///< creep speed towards a stop
  double pivot_rate_radps = 0.6;
  double pivot_acceleration_radps2 = 1.5;
  double pivot_tolerance_rad = 0.9 * kRadPerDeg;
  double stop_tolerance_m = 0.003;
  double settle_s = 0.3;  ///< standstill within tolerances for this long: segment done
  double max_cross_track_m = 0.20;
  double max_heading_error_rad = 60 * kRadPerDeg;
  double max_tilt_rad = 50 * kRadPerDeg;
  double time_limit_factor = 3.0;  ///< times the nominal duration of the course
  double min_battery_v = 6.2;
  double stall_s = 1.0;
  double disagreement_radps = 0.6;  ///< gyro against encoders
  double disagreement_s = 1.0;
  double turn_slip_share = 0.05;      ///< of a turn, in total; more is a fault of gyro or encoders
  double disturbance_radps = 0.5;     ///< gyro against tracks: the robot is turned from outside
  double recovery_speed_share = 0.5;  ///< share of the course's speed, until it heads back to the
                                      ///< path
  double recovery_window_m = 0.10;    ///< greatest displacement along the path by a disturbance
};

}  // namespace tp100::control
