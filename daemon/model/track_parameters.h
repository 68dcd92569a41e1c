#pragma once
// The parameters of the model of one robot, and the table of those that a robot file holds: from it
// the file is read and written, listed for viewers, identified and reported. A new parameter is a
// member, a row of the table and its use in the model.

#include <array>
#include <cstddef>
#include <string_view>

#include "core/arithmetic.h"
#include "core/enum_names.h"

namespace tp100::model {

/// How the paper's table of slip against slope (slip_at_slope) is interpolated and extrapolated. It
/// has no downhill rows: `kTable` and `kFit` hold the level value there, which overstates slip
/// (contact physics gives about 0.09 at -28 deg, 0.16 level); the other two continue with the fit's
/// slope to -28 deg, which is our extension.
enum class SlipCurve {
  kTable,          ///< linear between the rows, ends held
  kFit,            ///< left 0.1557 + 0.00222 per deg, right 0.1534 + 0.00362 per deg, ends held
  kTableDownhill,  ///< kTable uphill, from its level value down with the steepness of the fit
  kFitDownhill,    ///< the same, held at -28 and 28 deg
};
/// Names as in files.
inline constexpr std::array<EnumName<SlipCurve>, 4> kSlipCurveNames = {{
    {SlipCurve::kTable, "table"},
    {SlipCurve::kFit, "fit"},
    {SlipCurve::kTableDownhill, "table-downhill"},
    {SlipCurve::kFitDownhill, "fit-downhill"},
}};

/// What a slope adds to the slip ratios of level ground.
struct AddedSlip {
  double slope_rad = 0.0;  ///< climb angle, nose-up positive
  double left = 0.0, right = 0.0;
};
/// Slopes on which a robot's slip can be given, the steepest one, and what it may add.
inline constexpr std::size_t kMaxSlopes = 8;
inline constexpr double kSteepestDeg = 45.0;
inline constexpr double kLeastAddedSlip = -0.5, kMostAddedSlip = 0.9;

/// Parameters of eqs 1-5 and ours, and the scale of the gyro that measures the same motion. The
/// defaults are the paper's (tarpaulin; wheelbase as printed), with ours switched off.
struct TrackParameters {
  double slip_left = 0.1;
  double slip_right = 0.1188;
  double slip_angle_straight_rad = 0.404 * kRadPerDeg;
  double slip_angle_turning_rad = 0.0;
  double wheelbase_m = 0.2742;      ///< equivalent wheelbase L
  double x_icr_m = 0.0;             ///< Vy gets -x_icr * yaw rate
  double wheelbase_medium_m = 0.0;  ///< L in arcs of medium curvature; 0: as wheelbase_m
  double wheelbase_tight_m = 0.0;   ///< L in tight arcs; 0: as on the spot
  double wheelbase_spin_m = 0.0;    ///< L on the spot; 0: as wheelbase_m
  double x_icr_spin_shift_m = 0.0;  ///< added to x_icr_m on the spot
  double turn_slip = 0.0;           ///< slip of both tracks that a left turn adds and a right turn
                                    ///< subtracts: uneven creep of the tracks
  double turn_loss = 0.0;           ///< slip of both tracks that a turn to either side adds
  double gyro_scale = 1.0;          ///< true rate / nominal rate, z axis

  /// The robot's own slip on slopes, ascending, none of them level; `slopes` of them are given.
  /// With none, slip_curve applies.
  std::array<AddedSlip, kMaxSlopes> added_slips{};
  std::size_t slopes = 0;

  // Not of the robot: the configuration sets these.
  double turning_threshold_radps = 0.05;  ///< |yaw rate of eq 5| above it takes the turning angle
  SlipCurve slip_curve = SlipCurve::kTableDownhill;  ///< extended only, without added_slips
};

/// A parameter as a member of TrackParameters.
using TrackParameter = double TrackParameters::*;

/// What a parameter belongs to.
enum class ParameterOf {
  kPaper,     ///< eqs 1-5
  kExtended,  ///< the extended model only; 0 switches it off
  kGyro,      ///< the sensor: the motion of the tracks does not depend on it
};

/// A row of the table.
struct ParameterRow {
  const char* key;  ///< in a robot file; its suffix gives the unit
  TrackParameter value;
  ParameterOf of;
  double least, most;        ///< range, in the file's unit
  std::string_view meaning;  ///< one sentence, no unit and no range
  /// Standard deviation around the assumed value before identification, wider than for any robot,
  /// and an error that is harmless. SI.
  double prior_sd, useful;
  double si = 1.0;  ///< SI value of one file unit
  /// If given, prior_sd is in parts of this parameter's assumed value. One that is relative to
  /// another is expected near it, wherever that turns out to be.
  TrackParameter relative_to = nullptr;
};

/// In the order of the file.
inline constexpr std::array kTrackParameters = {
    ParameterRow{"slip_left", &TrackParameters::slip_left, ParameterOf::kPaper, -0.5, 0.9,
                 "Slip ratio of the left track on flat ground", 0.3, 0.01},
    ParameterRow{"slip_right", &TrackParameters::slip_right, ParameterOf::kPaper, -0.5, 0.9,
                 "Slip ratio of the right track on flat ground", 0.3, 0.01},
    ParameterRow{"slip_angle_straight_deg", &TrackParameters::slip_angle_straight_rad,
                 ParameterOf::kPaper, -20, 20, "Slip angle (beta of eq 2) while driving straight",
                 10 * kRadPerDeg, 1 * kRadPerDeg, kRadPerDeg},
    ParameterRow{
        "slip_angle_turning_deg", &TrackParameters::slip_angle_turning_rad, ParameterOf::kPaper,
        -20, 20,
        "Slip angle while turning; the yaw rate above which it applies is in the configuration",
        10 * kRadPerDeg, 2 * kRadPerDeg, kRadPerDeg},
    ParameterRow{"wheelbase_m", &TrackParameters::wheelbase_m, ParameterOf::kPaper, 0.05, 2,
                 "Equivalent wheelbase L of eq 5, turning slip included", 0.5, 0.04, 1.0,
                 &TrackParameters::wheelbase_m},
    ParameterRow{"x_icr_m", &TrackParameters::x_icr_m, ParameterOf::kExtended, -0.2, 0.2,
                 "Distance of the turning centre ahead of the reference point; this times the yaw "
                 "rate is subtracted from the sideways speed",
                 0.1, 0.01},
    ParameterRow{"wheelbase_medium_m", &TrackParameters::wheelbase_medium_m, ParameterOf::kExtended,
                 0, 2,
                 "Equivalent wheelbase in arcs in which the slower track has 0.65 of the faster "
                 "one's speed; "
                 "from 0.9 on, wheelbase_m applies. 0: same as in wide turns",
                 0.15, 0.02, 1.0, &TrackParameters::wheelbase_m},
    ParameterRow{
        "wheelbase_tight_m", &TrackParameters::wheelbase_tight_m, ParameterOf::kExtended, 0, 2,
        "Equivalent wheelbase in tight arcs, in which the slower track has 0.35 of the faster "
        "one's speed. 0: same as on the spot",
        0.25, 0.03, 1.0, &TrackParameters::wheelbase_m},
    ParameterRow{"wheelbase_spin_m", &TrackParameters::wheelbase_spin_m, ParameterOf::kExtended, 0,
                 2, "Equivalent wheelbase while turning on the spot; 0: same as in wide turns",
                 0.25, 0.03, 1.0, &TrackParameters::wheelbase_m},
    ParameterRow{"x_icr_spin_shift_m", &TrackParameters::x_icr_spin_shift_m, ParameterOf::kExtended,
                 -0.2, 0.2,
                 "How much farther ahead the turning centre lies on the spot than in wide turns",
                 0.1, 0.01},
    ParameterRow{
        "turn_slip", &TrackParameters::turn_slip, ParameterOf::kExtended, -0.5, 0.5,
        "Slip that a left turn adds to both tracks and a right turn subtracts, if the tracks "
        "creep unevenly; it grows with the turn until the slower track has 0.55 of the "
        "faster one's speed, and falls to 0 at 0.35",
        0.1, 0.01},
    ParameterRow{
        "turn_loss", &TrackParameters::turn_loss, ParameterOf::kExtended, -0.5, 0.5,
        "Slip that a turn to either side adds to both tracks, where the slower track stands still; "
        "it grows with the curvature of the path up to there",
        0.1, 0.02},
    ParameterRow{"gyro_scale", &TrackParameters::gyro_scale, ParameterOf::kGyro, 0.8, 1.25,
                 "True over nominal rate of the gyro's z axis, from turning on the spot by a known "
                 "angle",
                 0.2, 0.01},
};

/// Place of a parameter in the table; its size if the table does not have it.
constexpr std::size_t row_of(TrackParameter parameter) {
  std::size_t i = 0;
  while (i < kTrackParameters.size() && kTrackParameters[i].value != parameter) ++i;
  return i;
}

}  // namespace tp100::model
