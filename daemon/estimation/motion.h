#pragma once
// One sample interval as the pose filter takes it, and the filter's prediction over it.

#include "core/time.h"
#include "estimation/filter_state.h"
#include "estimation/odometry.h"
#include "estimation/parameters.h"
#include "model/track_model.h"

namespace tp100::estimation {

/// What the floor does under the robot. Everything zero on a plane.
struct Ground {
  double planar = 1.0;  ///< horizontal distance per distance along the ground; model::Incline
  double z_m = 0.0;     ///< height and attitude of the body: they shift the marker
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double tilt_radps = 0.0;  ///< how fast the pitch changes; not negative
  model::Slip slip{};       ///< slip ratios to expect here
  bool hold_slip = false;  ///< on an obstacle: belts say nothing about the slip of the surface, and
                           ///< the way is known less well
};

/// Belts against gyro over a window of several intervals.
struct Residual {
  BeltSpeeds belts{};
  double gyro_z_radps = 0.0;
};

/// One interval, and the measurements that its end carries.
struct Motion {
  HostNs end_ns = 0;
  double dt_s = 0.0;
  BeltSpeeds belts{};
  model::TurnShape shape{};   ///< of the turn
  double gyro_z_radps = 0.0;  ///< mean over the interval, bias included
  bool gyro = false;          ///< false: bench or dead sensor, eq 5 gives the turn
  Ground ground{};
  bool has_residual = false;
  Residual residual{};
  double rest_radps = 0.0;     ///< gyro of a robot at rest
  double rest_sd_radps = 0.0;  ///< 0: not at rest
};

/// Turning a motion into a change of the state. Pure; no allocation.
class MotionModel {
 public:
  MotionModel(const model::TrackParameters& tracks, const FilterParameters& noise)
      : tracks_(tracks), noise_(noise) {}

  /// Twist that the state and the motion mean.
  Twist twist(const StateVector& mean, const Motion& motion) const;
  /// Mean and covariance over the interval: the exact arc, as odometry takes it.
  void predict(FilterState& state, const Motion& motion) const;
  /// The measurements at the interval's end: rest and residual.
  void measure(FilterState& state, const Motion& motion) const;
  /// Forgets the pose as far as a push may have moved it; bias and slip are held.
  void disturb(FilterState& state) const;

 private:
  double slip_angle_rad(double yaw_rate_radps) const;
  model::Turn turn_of(const Motion& motion) const;

  model::TrackParameters tracks_;
  FilterParameters noise_;
};

}  // namespace tp100::estimation
