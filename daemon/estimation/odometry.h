#pragma once
// Odometry: pose, gyro bias and slip ratios from encoders and gyro.

#include "core/carried_state.h"
#include "core/time.h"
#include "estimation/kalman.h"
#include "estimation/motion.h"
#include "estimation/slip_walk.h"
#include "estimation/standstill.h"
#include "model/track_model.h"

namespace tp100::estimation {

/// One sample interval, as bridge::Tracks finds it.
struct FilterInput {
  HostNs end_ns = 0;  ///< when its last sample was measured, host's clock
  double dt_s = 0.0;  ///< device time
  TrackSpeeds tracks{};
  double gyro_z_radps = 0.0;  ///< mean, calibrated scale, bias included
  bool gyro = false;          ///< may be used: fresh, and not on a stand
  double warming_degc = 0.0;  ///< rise of the gyro's temperature
  Ground ground{};
};

/// A Kalman filter over the state in kalman.h. Distance comes from the tracks; the turn comes from
/// the gyro, whose bias follows the tracks' turn where they determine it better: in straight
/// driving. Without a gyro eq 5 gives the turn. No allocation; safe in the real-time thread.
class Odometry {
 public:
  Odometry(const model::TrackParameters& tracks, const FilterParameters& noise)
      : model_(tracks, noise), state_(model_.prior()) {}

  /// A run begins at `start`. Bias and slip are kept.
  void begin(const Pose& start);
  /// The samples were interrupted (a new session, a new boot): the time between is unknown.
  void interrupt();
  CarriedEstimate carried() const;
  /// The same, as if begin() had been called.
  CarriedEstimate carried_from(const Pose& start) const;
  /// As after construction, with this state.
  void resume(const CarriedEstimate& carried);

  /// One interval. Returns it as it was taken, with the measurements at its end.
  const Motion& advance(const FilterInput& in);
  /// The robot stands still: its gyro shows its bias. Applied at the end of the last interval.
  void standstill(const RestRate& rest);
  /// The state at the end of the last interval is known better, by a late measurement.
  void correct(const FilterState& state);

  /// z, roll and pitch are the ground's.
  Pose pose() const;
  const Twist& twist() const { return twist_; }
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
  model::TurnMonitor turn_monitor_{};
  SlipWalk slip_walk_{};
  Residual last_residual_{};  ///< of the window before; 0: there is none
  Window residual_window_{};
  Window disturbance_window_{};
};

}  // namespace tp100::estimation
