#pragma once
// What identify looks for, in one order everywhere.

#include <array>
#include <cstddef>

#include "core/angle.h"
#include "model/track_model.h"

namespace tp100::identify {

/// What can be found of a robot.
enum class Parameter : std::size_t {
  kSlipLeft,
  kSlipRight,
  kSlipAngleStraight,
  kSlipAngleTurning,
  kWheelbase,
  kXIcr,
  kWheelbaseTight,
  kXIcrTightShift,
  kWheelbaseSpin,
  kXIcrSpinShift,
  kTurnSlip,
  kTurnSlipTight,
  kGyroScale,
};
inline constexpr std::size_t kParameters = 13;
inline constexpr std::size_t index(Parameter parameter) {
  return static_cast<std::size_t>(parameter);
}

/// What is believed of a robot, before and after.
struct Belief {
  model::TrackParameters tracks{};
  double gyro_scale = 1.0;            ///< true / nominal
  double counts_per_metre = 11140.0;  ///< never fitted: it cannot be told from slip
};

/// Key of a parameter in a robot file, and SI units per unit of that file.
struct ParameterKey {
  const char* key;
  double si = 1.0;
};
inline constexpr std::array<ParameterKey, kParameters> kParameterKeys = {{
    {"slip_left"},
    {"slip_right"},
    {"slip_angle_straight_deg", kRadPerDeg},
    {"slip_angle_turning_deg", kRadPerDeg},
    {"wheelbase_m"},
    {"x_icr_m"},
    {"wheelbase_tight_m"},
    {"x_icr_tight_shift_m"},
    {"wheelbase_spin_m"},
    {"x_icr_spin_shift_m"},
    {"turn_slip"},
    {"turn_slip_tight"},
    {"gyro_scale"},
}};

}  // namespace tp100::identify
