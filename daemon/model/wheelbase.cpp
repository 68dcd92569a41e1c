#include "model/wheelbase.h"

namespace tp100::model {

double equivalent_wheelbase_m(const WheelbaseGeometry& geometry) {
  const double lateral = geometry.width_m / 2.0 - geometry.gamma * geometry.offset_y_m;
  const double longitudinal = geometry.length_m / 2.0 - geometry.offset_x_m;
  return 2.0 * (lateral * lateral + longitudinal * longitudinal) / lateral;
}

}  // namespace tp100::model
