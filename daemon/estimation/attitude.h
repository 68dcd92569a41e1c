#pragma once
// The body's attitude from the IMU: roll and pitch from gyro and accelerometer (the gyro over short
// times, gravity over long ones), and from the pitch alone, without map or camera, the slope and
// the class of the obstacle under the robot.

#include <array>
#include <cstddef>

#include "core/estimates.h"
#include "core/step_record.h"

namespace tp100::estimation {

/// Complementary filter, z-y-x angles, nose-up pitch negative. The standstill at the start counts
/// as level, and any deviation from gravity there as an axis's offset: an accelerometer may be off
/// by 3 deg. No allocation; safe in the real-time thread.
class AttitudeFilter {
 public:
  using Vector = std::array<double, 3>;

  /// The tracks stand still for `dt_s`: learns both sensors' offsets, unless the robot is being
  /// tilted or is steeper than any offset.
  void level(const Vector& gyro_radps, const Vector& accel_mps2, double dt_s);
  /// One interval; body axes, specific force.
  void update(const Vector& gyro_radps, const Vector& accel_mps2, double dt_s);

  CarriedAttitude carried() const {
    return {levelled_s_, gyro_offset_, accel_offset_, roll_rad_, pitch_rad_};
  }
  /// As after construction, with this state.
  void resume(const CarriedAttitude& state);

  double roll_rad() const { return roll_rad_; }
  double pitch_rad() const { return pitch_rad_; }
  /// Rate of the heading (z-y-x Euler rate) of a body whose own z axis turns at `body_z_radps`,
  /// offset removed.
  double yaw_rate_radps(double body_z_radps) const;

 private:
  bool looks_level(const Vector& gyro_radps, const Vector& accel_mps2) const;

  double levelled_s_ = 0.0;
  Vector gyro_offset_{};
  Vector accel_offset_{};
  double roll_rad_ = 0.0, pitch_rad_ = 0.0;
  double body_y_radps_ = 0.0;
};

/// Flat, climbing or descending. Enters a slope after it has lasted and leaves it at a smaller
/// angle, so that noise or a bump change nothing. No allocation; safe in the real-time thread.
class SlopeState {
 public:
  /// One interval with the pitch of the body, nose-up negative.
  Slope update(double pitch_rad, double dt_s);
  Slope state() const { return state_; }

 private:
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
  ObstacleClass update(double pitch_rad, Slope slope, double distance_m);
  /// The obstacle that tilts the body; kNone while it is level.
  ObstacleClass state() const { return state_; }

 private:
  /// The steepest line that the front end climbed, over a centimetre of distance.
  void climb(double nose_up_rad, double distance_m);

  static constexpr std::size_t kMarks = 10;

  double axle_spacing_m_;
  Slope slope_ = Slope::kFlat;
  ObstacleClass state_ = ObstacleClass::kNone;
  ObstacleClass last_ = ObstacleClass::kNone;  ///< the obstacle that the robot climbed
  double level_m_ = 0.0;                       ///< distance since last_ was left
  double up_m_ = 0.0;                          ///< distance since the slope state became up
  double since_mark_m_ = 0.0;
  std::array<double, kMarks> sines_{};  ///< of the pitch, a millimetre apart; a ring
  std::size_t marks_ = 0;               ///< so far
  double steepest_ = 0.0;               ///< sine
};

}  // namespace tp100::estimation
