#pragma once
// Slip ratio against slope: the paper's table (straight climb at 0.10 m/s) and interpolations of
// it.

#include <array>

#include "core/enum_names.h"

namespace tp100::model {

/// Slip ratios of both tracks.
struct SlipPair {
  double left = 0.0;
  double right = 0.0;
  bool outside = false;  ///< the slope lies outside the table; the values are not measured
};

/// How the table is interpolated and extrapolated. It has no downhill rows: `kTable` and `kFit`
/// hold the level value there, which overstates slip (contact physics gives about 0.09 at -28 deg,
/// 0.16 level); the other two continue with the fit's slope to -28 deg, which is our extension.
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

/// Slip of the board that the paper measured. `slope_rad`: climb angle, 0..28 deg inside; any other
/// value, NaN included, gives the nearest end (NaN: the level one) and sets `outside`. Pure.
SlipPair slip_at_slope(double slope_rad, SlipCurve curve = SlipCurve::kTable);

/// Bound that keeps 1 - slip away from 0 where slip is divided out of a command.
inline constexpr double kMaxSlip = 0.95;

}  // namespace tp100::model
