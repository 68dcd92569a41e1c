#pragma once
// One sample interval as the pose filter takes it, and the filter's prediction over it.

#include "core/time.h"
#include "estimation/kalman.h"
#include "estimation/odometry.h"
#include "estimation/parameters.h"
#include "model/track_model.h"

namespace tp100::estimation {

/// Terrain under the robot. All zero on a plane.
struct Ground {
  double horizontal_fraction = 1.0;  ///< horizontal distance per distance along the slope,
                                     ///< cos(slope) on a ramp; see model::Incline
  double z_m = 0.0;                  ///< height and attitude of the body: they displace the marker
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double tilt_radps = 0.0;  ///< how fast the pitch changes; not negative
  model::Slip slip{};       ///< slip ratios to expect here
  bool hold_slip = false;   ///< on an obstacle: tracks do not show the surface's slip, and the
                            ///< distance is less certain
};

/// Tracks against gyro over a window of several intervals.
struct Residual {
  TrackSpeeds tracks{};
  double gyro_z_radps = 0.0;
};

/// One interval, and the measurements that its end carries.
struct Motion {
  HostNs end_ns = 0;
  double dt_s = 0.0;
  TrackSpeeds tracks{};
  model::TurnShape shape{};   ///< of the turn
  double gyro_z_radps = 0.0;  ///< mean over the interval, bias included
  bool gyro = false;          ///< false: stand or dead sensor, eq 5 gives the turn
  Ground ground{};
  bool has_residual = false;
  Residual residual{};
  double standstill_radps = 0.0;     ///< gyro of a robot at rest
  double standstill_sd_radps = 0.0;  ///< 0: not at rest
};

/// Turns a motion into a change of the state. Pure; no allocation.
class MotionModel {
 public:
  MotionModel(const model::TrackParameters& tracks, const FilterParameters& noise)
      : tracks_(tracks), noise_(noise) {}

  /// Twist according to state and motion.
  Twist twist(const StateVector& mean, const Motion& motion) const;
  /// Propagates mean and covariance over the interval, along the exact arc as odometry does.
  void predict(FilterState& state, const Motion& motion) const;
  /// Applies the measurements at the interval's end: standstill and residual.
  void measure(FilterState& state, const Motion& motion) const;
  /// Adds the pose uncertainty of a disturbance; bias and slip are kept.
  void disturb(FilterState& state) const;

 private:
  model::Turn turn_of(const Motion& motion) const;

  model::TrackParameters tracks_;
  FilterParameters noise_;
};

}  // namespace tp100::estimation
