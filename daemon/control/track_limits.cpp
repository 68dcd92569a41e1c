#include "control/track_limits.h"

#include <algorithm>

namespace tp100::control {
namespace {

/// Half the difference of the tracks' ground speeds. [m/s]
double arc_of(double turn_radps, const TrackLimits& limits) {
  const double most = limits.max_track_mps * (2.0 - limits.slip_left - limits.slip_right) / 2.0;
  return std::clamp(turn_radps * limits.wheelbase_m / 2.0, -most, most);
}

}  // namespace

double turn_asked(double yaw_error_rad, double feed_forward_radps, const TrackLimits& limits) {
  return std::clamp(feed_forward_radps + limits.yaw_kp * yaw_error_rad, -limits.max_yaw_radps,
                    limits.max_yaw_radps);
}

double speed_within(double speed_mps, double turn_radps, const TrackLimits& limits) {
  const double arc = arc_of(turn_radps, limits);
  const double left = limits.max_track_mps * (1.0 - limits.slip_left);
  const double right = limits.max_track_mps * (1.0 - limits.slip_right);
  const double slowest = std::max(arc - left, -arc - right);
  const double fastest = std::min(arc + left, -arc + right);
  return std::max(slowest, std::min(fastest, speed_mps));
}

double speed_along(double speed_mps, double yaw_error_rad, double curvature_1pm,
                   const TrackLimits& limits) {
  const auto fits = [&](double mps) {
    const double turn = turn_asked(yaw_error_rad, curvature_1pm * mps, limits);
    return speed_within(mps, turn, limits) >= mps;
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

TrackSpeeds tracks_for(double speed_mps, double turn_radps, const TrackLimits& limits) {
  const double arc = arc_of(turn_radps, limits);
  const double speed = speed_within(speed_mps, turn_radps, limits);
  return {(speed - arc) / (1.0 - limits.slip_left), (speed + arc) / (1.0 - limits.slip_right)};
}

}  // namespace tp100::control
