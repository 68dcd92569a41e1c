#include "control/pivot.h"

#include <algorithm>
#include <cmath>

namespace tp100::control {

void Pivot::begin(const course::Piece& piece, double most_radps) {
  most_radps_ = most_radps;
  yaw_rad_ = piece.begin.yaw_rad;
  end_rad_ = piece.end.yaw_rad;
  rate_radps_ = 0.0;
  arrived_ = false;
}

void Pivot::update(const Parameters& parameters, double dt_s) {
  const double left = end_rad_ - yaw_rad_;
  const double sign = left < 0.0 ? -1.0 : 1.0;
  const double braking = std::sqrt(2.0 * parameters.pivot_acceleration_radps2 * std::abs(left));
  const double rate =
      std::min({parameters.pivot_rate_radps, most_radps_, braking,
                std::abs(rate_radps_) + parameters.pivot_acceleration_radps2 * dt_s});
  yaw_rad_ += sign * std::min(rate * dt_s, std::abs(left));
  arrived_ = std::abs(end_rad_ - yaw_rad_) < 1e-4;
  if (arrived_) yaw_rad_ = end_rad_;
  rate_radps_ = arrived_ ? 0.0 : sign * rate;
}

}  // namespace tp100::control
