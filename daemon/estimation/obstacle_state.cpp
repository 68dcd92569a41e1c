#include "estimation/obstacle_state.h"

#include <cmath>
#include <utility>

#include "core/angle.h"

namespace tp100::estimation {
namespace {

// A body that leans by less counts as level: noise and offset of the pitch.
constexpr double kLevelRad = 2.0 * kRadPerDeg;
// Steeper than any ramp that belts hold on (37 deg), less steep than any riser rolled up so far.
constexpr double kStepSine = 0.6;
// Way over the top of an obstacle, from leaving its up side to its down side.
constexpr double kTopM = 0.6;

}  // namespace

Obstacle ObstacleState::judge(double nose_up_rad) const {
  const double risen = axle_spacing_m_ * (nose_up_rad - level_rad_);
  return risen > kStepSine * rise_m_ ? Obstacle::kBlock : Obstacle::kRamp;
}

Obstacle ObstacleState::update(double pitch_rad, Slope slope, double way_m) {
  const double nose_up = -pitch_rad;
  rise_m_ += std::abs(way_m);
  level_m_ += std::abs(way_m);
  if (slope == Slope::kFlat && nose_up < kLevelRad) {
    rise_m_ = 0.0;
    level_rad_ = nose_up;
  }
  const Slope before = std::exchange(slope_, slope);
  if (slope == Slope::kFlat) {
    if (before != Slope::kFlat) level_m_ = 0.0;
    return state_ = Obstacle::kNone;
  }
  if (slope == before) return state_;
  if (slope == Slope::kUp && before == Slope::kFlat) {
    state_ = last_ = judge(nose_up);
  } else if (before == Slope::kFlat) {
    state_ = level_m_ < kTopM && last_ != Obstacle::kNone ? last_ : Obstacle::kRamp;
  }
  return state_;
}

}  // namespace tp100::estimation
