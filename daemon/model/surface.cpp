#include "model/surface.h"

#include <algorithm>

namespace tp100::model {

SlipPair slip_on_surface(const Surface& surface, double slope_rad, SlipCurve curve) {
  const SlipPair level = slip_at_slope(0.0, curve);
  SlipPair slip = slip_at_slope(slope_rad, curve);
  slip.left = std::min(surface.slip_left + (slip.left - level.left), kMostSlip);
  slip.right = std::min(surface.slip_right + (slip.right - level.right), kMostSlip);
  return slip;
}

}  // namespace tp100::model
