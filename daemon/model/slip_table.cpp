#include "model/slip_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/arithmetic.h"

namespace tp100::model {
namespace {

struct Row {
  double slope_deg, left, right;
};

constexpr std::array<Row, 7> kRows{{{0, 0.16, 0.162},
                                    {8, 0.17, 0.176},
                                    {12, 0.18, 0.197},
                                    {16, 0.19, 0.204},
                                    {20, 0.20, 0.218},
                                    {24, 0.21, 0.247},
                                    {28, 0.22, 0.260}}};

// Steepness of the straight line through the rows.
constexpr double kLeftPerDeg = 0.00222, kRightPerDeg = 0.00362;

SlipPair interpolated(double deg) {
  std::size_t upper = 1;
  while (upper + 1 < kRows.size() && kRows[upper].slope_deg < deg) ++upper;
  const Row& low = kRows[upper - 1];
  const Row& high = kRows[upper];
  const double share = (deg - low.slope_deg) / (high.slope_deg - low.slope_deg);
  return {std::lerp(low.left, high.left, share), std::lerp(low.right, high.right, share), false};
}

}  // namespace

SlipPair slip_at_slope(double slope_rad, SlipCurve curve) {
  const double deg = slope_rad * kDegPerRad;
  const double first = kRows.front().slope_deg, last = kRows.back().slope_deg;
  const bool downhill = curve == SlipCurve::kTableDownhill || curve == SlipCurve::kFitDownhill;
  const bool table = curve == SlipCurve::kTable || curve == SlipCurve::kTableDownhill;
  const double lowest = downhill ? -last : first;
  const double held = std::isnan(deg) ? first : std::clamp(deg, lowest, last);
  SlipPair slip{0.1557 + kLeftPerDeg * held, 0.1534 + kRightPerDeg * held, false};
  if (table && held >= first) slip = interpolated(held);
  if (table && held < first)
    slip = {kRows[0].left + kLeftPerDeg * held, kRows[0].right + kRightPerDeg * held, false};
  slip.outside = !(deg >= first && deg <= last);
  return slip;
}

}  // namespace tp100::model
