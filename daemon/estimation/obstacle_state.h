#pragma once
// Ramp or step, told from how the body rises: no map, no camera.

#include "core/slope.h"
#include "core/underfoot.h"

namespace tp100::estimation {

/// While the rear end still rolls on the floor, the front one climbs along a line of slope g, and
/// the pitch p obeys L dp = sin(g) ds (L axle spacing, s way of the belts). On a ramp g is the
/// ramp's slope, on the riser of a step it is steep. Judged once, when the slope state turns to up;
/// what comes down soon afterwards is the other side of the same obstacle. No allocation; safe in
/// the real-time thread.
class ObstacleState {
 public:
  explicit ObstacleState(double axle_spacing_m) : axle_spacing_m_(axle_spacing_m) {}

  void restart() { *this = ObstacleState(axle_spacing_m_); }
  /// One interval at whose end the body has this pitch (nose-up negative) and state; `way_m` is the
  /// belts' way, slip taken off.
  Obstacle update(double pitch_rad, Slope slope, double way_m);
  /// What leans the body; none while it is level.
  Obstacle state() const { return state_; }

 private:
  Obstacle judge(double nose_up_rad) const;

  double axle_spacing_m_;
  Slope slope_ = Slope::kFlat;
  Obstacle state_ = Obstacle::kNone;
  Obstacle last_ = Obstacle::kNone;  ///< that the robot went up
  double level_m_ = 0.0;             ///< way since it was left
  double rise_m_ = 0.0;              ///< way since the body was level
  double level_rad_ = 0.0;           ///< nose-up there
};

}  // namespace tp100::estimation
