#pragma once
// Odometry: pose, gyro bias and slip ratios from encoders and gyro; and how much the slip
// difference changes along the floor, by the same two sensors.

#include <array>
#include <cstddef>

#include "core/step_record.h"
#include "core/time.h"
#include "estimation/kalman.h"
#include "estimation/motion.h"
#include "estimation/standstill.h"
#include "model/track_model.h"

namespace tp100::estimation {

/// Models the slip difference as a random walk over the distance driven. On an even floor it is
/// nearly constant, and the tracks then reveal a drift of the gyro; on an uneven one they do not.
/// Its step per root metre is one of a few candidates, each with its likelihood given the changes
/// seen; old changes are forgotten over some 30 windows. No allocation.
class SlipWalk {
 public:
  static constexpr std::size_t kCandidates = 8;
  /// Per root metre: from an even floor to gravel.
  static constexpr std::array<double, kCandidates> kStepsRtm{3e-5, 1e-4, 3e-4, 1e-3,
                                                             3e-3, 1e-2, 3e-2, 1e-1};
  using LogLikelihoods = std::array<double, kCandidates>;

  /// Nothing is known.
  SlipWalk() { weigh(); }
  explicit SlipWalk(const LogLikelihoods& logs);
  const LogLikelihoods& log_likelihoods() const { return logs_; }

  /// From one window to the next of `distance_m` each, the measured slip difference changed by
  /// `change`, with measurement noise of `noise_sd` (> 0).
  void add(double change, double noise_sd, double distance_m);
  /// Root mean square of the step over all candidates. [1 / sqrt(m)]
  double step_rtm() const { return step_rtm_; }

 private:
  void weigh();

  LogLikelihoods logs_{};
  double step_rtm_ = 0.0;
};

/// One sample interval, from bridge::SampleIntervals.
struct FilterInput {
  HostNs end_ns = 0;  ///< when its last sample was measured, host's clock
  double dt_s = 0.0;  ///< device time
  TrackSpeeds tracks{};
  double gyro_z_radps = 0.0;  ///< mean, calibrated scale, bias included
  bool gyro = false;  ///< the gyro may be used: it is fresh, and the robot is not on a stand
  double warming_degc = 0.0;  ///< rise of the gyro's temperature
  Ground ground{};
};

/// A Kalman filter of the state in kalman.h. Distance comes from the tracks; the turn comes from
/// the gyro, whose bias is corrected by the tracks where they determine it better: in straight
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
  SlipWalk slip_walk_{};
  Residual last_residual_{};  ///< of the window before; 0: there is none
  Window residual_window_{};
  Window disturbance_window_{};
};

}  // namespace tp100::estimation
