#include "model/slip_table.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "core/angle.h"

namespace tp100::model {
namespace {

struct Row {
  double slope_deg, left, right;
};

constexpr std::array<Row, 7> kTable{{{0, 0.16, 0.162},
                                     {8, 0.17, 0.176},
                                     {12, 0.18, 0.197},
                                     {16, 0.19, 0.204},
                                     {20, 0.20, 0.218},
                                     {24, 0.21, 0.247},
                                     {28, 0.22, 0.260}}};

}  // namespace

SlipPair slip_at_slope(double slope_rad) {
  const double deg = slope_rad * kDegPerRad;
  const Row& first = kTable.front();
  const Row& last = kTable.back();
  if (!(deg >= first.slope_deg)) return {first.left, first.right, true};
  if (deg > last.slope_deg) return {last.left, last.right, true};
  std::size_t upper = 1;
  while (upper + 1 < kTable.size() && kTable[upper].slope_deg < deg) ++upper;
  const Row& low = kTable[upper - 1];
  const Row& high = kTable[upper];
  const double share = (deg - low.slope_deg) / (high.slope_deg - low.slope_deg);
  return {std::lerp(low.left, high.left, share), std::lerp(low.right, high.right, share), false};
}

}  // namespace tp100::model
