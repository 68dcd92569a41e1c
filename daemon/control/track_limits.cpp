#include "control/track_limits.h"

#include <algorithm>

namespace tp100::control {

double turn_asked(double yaw_error_rad, double feed_forward_radps, const TrackLimits& limits) {
  return std::clamp(feed_forward_radps + limits.yaw_kp * yaw_error_rad, -limits.max_yaw_radps,
                    limits.max_yaw_radps);
}

double speed_along(double speed_mps, double yaw_error_rad, double curvature_1pm,
                   const TrackLimits& limits) {
  const shared::SkidSteer<double> tracks = skid_steer(limits);
  const auto fits = [&](double mps) {
    const double turn = turn_asked(yaw_error_rad, curvature_1pm * mps, limits);
    return tracks.speed_within(mps, turn) >= mps;
  };
  if (fits(speed_mps)) return std::max(speed_mps, 0.0);
  double good = 0.0, bad = speed_mps;
  constexpr int kHalvings = 16;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (good + bad) / 2.0;
    (fits(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace tp100::control
