#pragma once
// Ramp or step, told from how the body rises: no map, no camera.

#include <array>
#include <cstddef>

#include "core/slope.h"
#include "core/underfoot.h"

namespace tp100::estimation {

/// While the rear end still rolls on the floor, the front one climbs along a line of slope g, and
/// the pitch p obeys L d(sin p) = sin(g) ds (L axle spacing, s way of the belts). On a ramp g is
/// the ramp's slope, up to 34 deg; over the riser and the edge of a step it is steeper somewhere,
/// though belts that slip there hide it at first. So what looks like a ramp when the slope state
/// turns to up may still turn out to be a step for the next four centimetres. What comes down soon
/// afterwards is the other side of the same obstacle. No allocation; safe in the real-time thread.
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
  /// The steepest line that the front end climbed, over a centimetre of way.
  void climb(double nose_up_rad, double way_m);

  static constexpr std::size_t kMarks = 10;

  double axle_spacing_m_;
  Slope slope_ = Slope::kFlat;
  Obstacle state_ = Obstacle::kNone;
  Obstacle last_ = Obstacle::kNone;  ///< that the robot went up
  double level_m_ = 0.0;             ///< way since it was left
  double up_m_ = 0.0;                ///< way since the slope state turned to up
  double since_mark_m_ = 0.0;
  std::array<double, kMarks> sines_{};  ///< of the pitch, a millimetre apart; a ring
  std::size_t marks_ = 0;               ///< so far
  double steepest_ = 0.0;               ///< sine
};

}  // namespace tp100::estimation
