#pragma once
// Odometry: distance from the encoders through the slip model, rotation from the gyro.

#include "model/track_model.h"

namespace tp100::estimation {

/// Track speeds, constant over one interval.
struct TrackSpeeds {
  double left_mps = 0.0;
  double right_mps = 0.0;
};

/// Pose by encoders and gyro. No allocation; safe in the real-time thread.
class Odometry {
 public:
  explicit Odometry(const model::TrackParameters& parameters) : parameters_(parameters) {}

  void reset(const Pose& pose) {
    pose_ = pose;
    turn_monitor_.restart();
  }

  /// One interval with the mean yaw rate `yaw_rate_radps` of the gyro, bias removed. The slip
  /// angle's turning switch and the ICR offset follow the gyro too, not the tracks.
  const Twist& advance(const TrackSpeeds& tracks, double yaw_rate_radps, double dt_s,
                       const model::Incline& incline = {});
  /// One interval without a usable gyro (stand, dead sensor): eq 5 gives the turn.
  const Twist& advance_without_gyro(const TrackSpeeds& tracks, double dt_s,
                                    const model::Incline& incline = {});

  const Pose& pose() const { return pose_; }
  const Twist& twist() const { return twist_; }

 private:
  model::TurnShape shape(const TrackSpeeds& tracks, double dt_s);

  model::TrackParameters parameters_;
  Pose pose_{};
  Twist twist_{};
  model::TurnMonitor turn_monitor_{};
};

}  // namespace tp100::estimation
