#pragma once
// Odometry: pose, gyro bias and slip ratios from encoders and gyro.

#include <array>
#include <cstddef>

#include "core/step_record.h"
#include "core/time.h"
#include "estimation/kalman.h"
#include "estimation/motion.h"
#include "estimation/standstill.h"
#include "estimation/track_trust.h"
#include "model/track_model.h"

namespace tp100::estimation {

/// One sample interval, from bridge::SampleIntervals.
struct FilterInput {
  HostNs end_ns = 0;  ///< when its last sample was measured, host's clock
  double dt_s = 0.0;  ///< device time
  TrackSpeeds tracks{};
  double gyro_z_radps = 0.0;  ///< mean, calibrated scale, bias included
  bool gyro = false;  ///< the gyro may be used: it is fresh, and the robot is not on a stand
  double warming_degc = 0.0;  ///< rise of the gyro's temperature
  Ground ground{};
  double shift_scale = 1.0;  ///< see Motion
};

/// A Kalman filter of the state in kalman.h. Distance comes from the tracks; the turn comes from
/// the gyro, whose bias is corrected by the tracks as far as these are to be trusted, see
/// TrackTrust. Without a gyro eq 5 gives the turn. No allocation; safe in the real-time thread.
class Odometry {
 public:
  Odometry(const model::TrackParameters& tracks, const FilterParameters& noise)
      : model_(tracks, noise), state_(model_.prior()) {}

  /// A run begins at `start`. Bias and slip are kept.
  void begin(const Pose& start);
  /// The samples were interrupted (a new session, a new boot): the time between is unknown.
  void interrupt();
  CarriedEstimate carried() const;
  /// What carried() returns after begin() with these arguments; the estimate itself stays.
  CarriedEstimate carried_from(const Pose& start) const;
  /// As after construction, with this state.
  void resume(const CarriedEstimate& carried);

  /// One interval. Returns it as it was taken, with the measurements at its end.
  const Motion& advance(const FilterInput& in);
  /// The robot stands still: its gyro shows its bias. Applied at the end of the last interval.
  void standstill(const RestRate& rest);
  /// Replaces the state at the end of the last interval, after a late measurement.
  void correct(const FilterState& state);

  /// z, roll and pitch are the ground's.
  Pose pose() const;
  const Twist& twist() const { return twist_; }
  /// The last interval, as it was taken.
  const Motion& motion() const { return motion_; }
  /// In the world frame.
  PlanarCovariance pose_covariance() const;
  /// In the body frame; kUnknownVariance before the first interval.
  PlanarCovariance twist_covariance() const;
  /// Of the slip difference along this floor, see TrackTrust.
  double slip_variance() const { return track_trust_.slip_variance(); }
  model::Slip slip() const { return model_.slip(state_.mean, motion_); }
  const FilterState& state() const { return state_; }
  const MotionModel& model() const { return model_; }

 private:
  /// Sums yaw rates of consecutive intervals.
  class Window {
   public:
    void add(const Residual& rates, double dt_s);
    double length_s() const { return length_s_; }
    /// The mean over the window, which restarts.
    Residual take();

   private:
    Residual sum_{};
    double length_s_ = 0.0;
  };

  FilterState state_at(const Pose& start) const;
  CarriedEstimate carry(const FilterState& state) const;
  void restart_from(const FilterState& state);
  void compare_tracks_with_gyro();
  void take_residual(const Residual& now);

  MotionModel model_;
  FilterState state_;
  Motion motion_{};  ///< the last
  Twist twist_{};
  model::TurnShapeFilter turn_shape_filter_{};
  TrackTrust track_trust_{};
  Window residual_window_{};
  Window disturbance_window_{};
};

}  // namespace tp100::estimation
