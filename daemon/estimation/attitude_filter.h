#pragma once
// Roll and pitch from gyro and accelerometer: the gyro over short times, gravity over long ones.

#include <array>

#include "core/carried_state.h"
#include "estimation/parameters.h"

namespace tp100::estimation {

/// Complementary filter, z-y-x angles, nose-up pitch negative. The standstill at the start counts
/// as level, and any deviation from gravity there as an axis's offset: an accelerometer may be off
/// by 3 deg. No allocation; safe in the real-time thread.
class AttitudeFilter {
 public:
  using Vector = std::array<double, 3>;

  explicit AttitudeFilter(const AttitudeParameters& parameters) : parameters_(parameters) {}

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
  /// Rate of pitch_rad(), offsets removed.
  double pitch_rate_radps() const { return pitch_rate_radps_; }
  /// Rate of the heading (z-y-x Euler rate) of a body whose own z axis turns at `body_z_radps`,
  /// offset removed.
  double yaw_rate_radps(double body_z_radps) const;

 private:
  bool looks_level(const Vector& gyro_radps, const Vector& accel_mps2) const;

  AttitudeParameters parameters_;
  double levelled_s_ = 0.0;
  Vector gyro_offset_{};
  Vector accel_offset_{};
  double roll_rad_ = 0.0, pitch_rad_ = 0.0;
  double pitch_rate_radps_ = 0.0;
  double body_y_radps_ = 0.0;
};

}  // namespace tp100::estimation
