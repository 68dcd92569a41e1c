#pragma once
// What the belts stand on, by name: slip belongs to a surface, the slope shifts it.

#include <string>

#include "model/slip_table.h"

namespace tp100::model {

/// Named surface and the slip ratios that were measured on it, level and straight. The defaults are
/// the paper's tarpaulin.
struct Surface {
  std::string name = "tarpaulin";
  double slip_left = 0.1;
  double slip_right = 0.1188;
};

/// Slip on `surface` at a slope: the surface's own value plus what the slope adds in the paper's
/// table, curve(slope) - curve(0). At most `kMostSlip`. No allocation; pure.
SlipPair slip_on_surface(const Surface& surface, double slope_rad,
                         SlipCurve curve = SlipCurve::kTable);

/// Bound that keeps 1 - slip away from 0 where slip is divided out of a command.
inline constexpr double kMostSlip = 0.95;

}  // namespace tp100::model
