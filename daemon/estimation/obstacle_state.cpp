#include "estimation/obstacle_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/angle.h"

namespace tp100::estimation {

Slope SlopeState::update(double pitch_rad, double dt_s) {
  const double steep = std::abs(pitch_rad);
  const Slope side = pitch_rad < 0.0 ? Slope::kUp : Slope::kDown;
  Slope seen = Slope::kFlat;
  if (steep > parameters_.enter_slope_rad ||
      (side == state_ && steep > parameters_.leave_slope_rad))
    seen = side;
  if (seen == state_) {
    lasted_s_ = 0.0;
    candidate_ = seen;
    return state_;
  }
  lasted_s_ = seen == candidate_ ? lasted_s_ + dt_s : dt_s;
  candidate_ = seen;
  if (lasted_s_ >= parameters_.slope_lasts_s) {
    state_ = seen;
    lasted_s_ = 0.0;
  }
  return state_;
}

namespace {

// A body tilted by less counts as level: noise and offset of the pitch.
constexpr double kLevelRad = 2.0 * kRadPerDeg;
// Steeper than a ramp of 34 deg, less steep than any riser and edge climbed so far.
constexpr double kStepSine = 0.56;
// After this distance uphill a ramp is certain.
constexpr double kJudgedM = 0.04;
// Distance over the top of an obstacle, from leaving its up side to its down side.
constexpr double kTopM = 0.6;
constexpr double kMarkM = 0.001;

}  // namespace

void ObstacleState::climb(double nose_up_rad, double distance_m) {
  since_mark_m_ += distance_m;
  if (since_mark_m_ < kMarkM) return;
  since_mark_m_ = std::fmod(since_mark_m_, kMarkM);
  const double sine = std::sin(nose_up_rad);
  double& oldest = sines_[marks_ % kMarks];
  if (marks_ >= kMarks)
    steepest_ = std::max(steepest_, axle_spacing_m_ * (sine - oldest) / (kMarks * kMarkM));
  oldest = sine;
  ++marks_;
}

Obstacle ObstacleState::update(double pitch_rad, Slope slope, double distance_m) {
  const double nose_up = -pitch_rad;
  level_m_ += std::abs(distance_m);
  up_m_ += std::abs(distance_m);
  if (slope == Slope::kFlat && nose_up < kLevelRad) steepest_ = 0.0;
  climb(nose_up, std::abs(distance_m));
  const Slope before = std::exchange(slope_, slope);
  if (slope == Slope::kFlat) {
    if (before != Slope::kFlat) level_m_ = 0.0;
    return state_ = Obstacle::kNone;
  }
  const Obstacle risen = steepest_ > kStepSine ? Obstacle::kBlock : Obstacle::kRamp;
  if (slope == Slope::kUp && before == Slope::kFlat) {
    up_m_ = 0.0;
    state_ = last_ = risen;
  } else if (slope == Slope::kUp && up_m_ < kJudgedM && risen == Obstacle::kBlock) {
    state_ = last_ = risen;
  } else if (before == Slope::kFlat) {
    state_ = level_m_ < kTopM && last_ != Obstacle::kNone ? last_ : Obstacle::kRamp;
  }
  return state_;
}

}  // namespace tp100::estimation
