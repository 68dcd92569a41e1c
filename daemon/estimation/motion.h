#pragma once
// One sample interval as the input of the estimators, the prediction of a state over it, and the
// measurements at its end.

#include "core/estimates.h"
#include "core/pose.h"
#include "core/time.h"
#include "estimation/kalman.h"
#include "estimation/parameters.h"
#include "estimation/standstill.h"
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

/// Level and without an obstacle: tracks against gyro show the slip difference.
bool shows_slip(const Ground& ground);

/// Tracks against gyro: mean yaw rates over a window of several intervals.
struct Residual {
  double left_radps = 0.0;  ///< speed of the track with the expected slip, over the wheelbase of
                            ///< its interval
  double right_radps = 0.0;
  double gyro_z_radps = 0.0;
  double variance = 0.0;  ///< of its noise; 0: there is no residual
  /// By how much it changes the information that slip difference and turn gain are near 0, see
  /// TrackTrust.
  double slip_information = 0.0, gain_information = 0.0;
};

/// One interval, and the measurements at its end.
struct Motion {
  HostNs end_ns = 0;
  double dt_s = 0.0;
  TrackSpeeds tracks{};       ///< constant over the interval
  model::TurnShape shape{};   ///< of the turn
  double gyro_z_radps = 0.0;  ///< mean over the interval, bias included
  bool gyro = false;          ///< false: stand or dead sensor, eq 5 gives the turn
  double warming_degc = 0.0;  ///< rise of the gyro's temperature over the interval
  Ground ground{};
  double shift_scale = 1.0;  ///< of the variance that motion adds to the position
  Residual residual{};
  bool disturbed = false;  ///< the robot was turned from outside
  RestRate rest{};         ///< of a robot at rest; standard deviation 0: it is not at rest
};

/// Share of the common slip that is left at the interval's end: it returns to 0 while the tracks
/// move on level ground.
double kept_slip(const FilterParameters& noise, const Motion& motion);

/// Variance of the position at an interval's end, along and across its direction, beside the part
/// that bias and slip explain. Distance and turn of either sign.
struct ShiftVariance {
  double along_m2, across_m2;
};
ShiftVariance shift_variance(const FilterParameters& noise, double distance_m, double turn_rad,
                             const Motion& motion);

/// Adds the variance of a shift in the direction of cosine `c` and sine `s` to that of the
/// position.
template <int N>
void add_shift(Eigen::Matrix<double, N, N>& covariance, const ShiftVariance& shift, double c,
               double s) {
  const auto [along, across] = shift;
  covariance(kX, kX) += along * c * c + across * s * s;
  covariance(kY, kY) += along * s * s + across * c * c;
  covariance(kX, kY) += (along - across) * c * s;
  covariance(kY, kX) += (along - across) * c * s;
}

/// Propagates a state over a motion. Pure; no allocation.
class MotionModel {
 public:
  MotionModel(const model::TrackParameters& tracks, const FilterParameters& noise)
      : tracks_(tracks), noise_(noise) {}

  const FilterParameters& noise() const { return noise_; }
  /// The state before anything is known: at the origin, with the robot's own slip.
  FilterState prior() const;

  /// Wheelbase, turning centre and slip of the motion's turn.
  model::Turn turn_of(const Motion& motion) const;
  /// Speeds of the tracks over the ground, with the slip of the state.
  TrackSpeeds over_ground(const StateVector& mean, const Motion& motion) const;
  /// Slip ratios of the state.
  model::Slip slip(const StateVector& mean, const Motion& motion) const;
  /// Twist according to state and motion.
  Twist twist(const StateVector& mean, const Motion& motion) const;
  /// Covariance of twist(), in the body frame, for an interval that is not empty: from the state,
  /// the encoders' edges, the gyro and the shift that the filter expects.
  PlanarCovariance twist_covariance(const FilterState& state, const Motion& motion) const;
  /// Yaw rate of the gyro against that of the tracks according to the state.
  double innovation_radps(const StateVector& mean, const Residual& residual) const;
  /// A residual as a measurement.
  Measurement<1> measured(const StateVector& mean, const Residual& residual) const;
  /// Noise of a residual due to gyro and encoders.
  double residual_sd_radps(const Motion& motion) const;
  /// Propagates mean and covariance over the interval, along the exact arc as odometry does.
  void predict(FilterState& state, const Motion& motion) const;
  /// Applies what is known at the interval's end: standstill, residual, disturbance.
  void measure(FilterState& state, const Motion& motion) const;
  /// The robot may have been carried or turned unseen: adds to the uncertainty of the pose. Bias
  /// and slip are kept.
  void disturb(FilterState& state) const;

 private:
  model::TrackParameters tracks_;
  FilterParameters noise_;
};

}  // namespace tp100::estimation
