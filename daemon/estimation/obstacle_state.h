#pragma once
// The slope and the class of the obstacle under the robot, by the pitch alone: no map, no camera.

#include <array>
#include <cstddef>

#include "core/estimates.h"
#include "estimation/parameters.h"

namespace tp100::estimation {

/// Flat, climbing or descending. Enters a slope after it has lasted and leaves it at a smaller
/// angle, so that noise or a bump change nothing. No allocation; safe in the real-time thread.
class SlopeState {
 public:
  explicit SlopeState(const AttitudeParameters& parameters) : parameters_(parameters) {}

  /// One interval with the pitch of the body, nose-up negative.
  Slope update(double pitch_rad, double dt_s);
  Slope state() const { return state_; }

 private:
  AttitudeParameters parameters_;
  Slope state_ = Slope::kFlat;
  Slope candidate_ = Slope::kFlat;
  double lasted_s_ = 0.0;
};

/// Distinguishes ramp and step by how the body rises. While the rear end still rolls on the floor,
/// the front end climbs along a line of slope g, and the pitch p obeys L d(sin p) = sin(g) ds (L
/// axle spacing, s distance of the tracks). On a ramp g is the ramp's slope, up to 34 deg; over the
/// riser and the edge of a step it is steeper somewhere, though slipping tracks hide that at first.
/// An apparent ramp may therefore still turn out to be a step in the four centimetres after the
/// slope state became up. A descent soon afterwards is the other side of the same obstacle. No
/// allocation; safe in the real-time thread.
class ObstacleState {
 public:
  explicit ObstacleState(double axle_spacing_m) : axle_spacing_m_(axle_spacing_m) {}

  void restart() { *this = ObstacleState(axle_spacing_m_); }
  /// One interval at whose end the body has this pitch (nose-up negative) and state; `distance_m`
  /// is the tracks' distance without slip.
  Obstacle update(double pitch_rad, Slope slope, double distance_m);
  /// The obstacle that tilts the body; none while it is level.
  Obstacle state() const { return state_; }

 private:
  /// The steepest line that the front end climbed, over a centimetre of distance.
  void climb(double nose_up_rad, double distance_m);

  static constexpr std::size_t kMarks = 10;

  double axle_spacing_m_;
  Slope slope_ = Slope::kFlat;
  Obstacle state_ = Obstacle::kNone;
  Obstacle last_ = Obstacle::kNone;  ///< the obstacle that the robot climbed
  double level_m_ = 0.0;             ///< distance since it was left
  double up_m_ = 0.0;                ///< distance since the slope state became up
  double since_mark_m_ = 0.0;
  std::array<double, kMarks> sines_{};  ///< of the pitch, a millimetre apart; a ring
  std::size_t marks_ = 0;               ///< so far
  double steepest_ = 0.0;               ///< sine
};

}  // namespace tp100::estimation
