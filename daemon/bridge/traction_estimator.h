#pragma once
// Whether the robot still moves: tracks against the camera, and the map's slope against the IMU's.

#include <optional>

#include "core/estimates.h"
#include "core/pose.h"

namespace tp100::bridge {

/// Thresholds for changes of state. A speed here is along the robot, forward positive.
struct TractionLimits {
  double immobilised_share = 0.2;       ///< share of the track speed below which the robot counts
                                        ///< as standing still
  double immobilised_after_s = 0.3;     ///< duration of such evidence without interruption
  double slipping_above = 0.4;          ///< |slip|; the paper's steepest ramp has 0.26
  double slipping_after_s = 0.1;        ///< duration of such evidence without interruption
  double recovered_below = 0.3;         ///< |slip| at which slipping and immobilised end
  double recovered_after_s = 0.1;       ///< duration of such evidence without interruption
  double least_track_speed_mps = 0.02;  ///< slower tracks give no evidence
};

/// State machine over track speed and an independent ground speed. No allocation; safe in the
/// real-time thread.
class TractionMonitor {
 public:
  explicit TractionMonitor(const TractionLimits& limits = {}) : limits_(limits) {}

  void reset() { *this = TractionMonitor(limits_); }

  /// Advances by `dt_s` with tracks at the mean speed `track_mps`. `ground_mps` comes from the
  /// camera or the accelerometer, never from the encoders; without one (or with values that are not
  /// finite) state and evidence stay as they are. Tracks slower than least_track_speed_mps end
  /// every state, so that a stopped robot may try again.
  Traction update(double track_mps, std::optional<double> ground_mps, double dt_s);

  Traction state() const { return state_; }
  /// 1 - ground / track speed of the last update with both; 0 before there was one. Negative: the
  /// robot moves faster than its tracks.
  double slip() const { return slip_; }

 private:
  TractionLimits limits_;
  Traction state_ = Traction::kHolding;
  double slip_ = 0.0;
  double standing_s_ = 0.0;
  double slipping_s_ = 0.0;
  double recovered_s_ = 0.0;
};

/// One sample interval of a run.
struct TractionInput {
  double dt_s = 0.0;
  double distance_m = 0.0;  ///< mean of the tracks along the ground, expected slip subtracted
  Pose fused{};             ///< at the interval's end
  bool camera = false;      ///< the camera has just confirmed the fused pose
  bool climbing = false;    ///< on a block, where tracks and ground distance are not proportional
  /// Pitch by the map at the steering pose, and by the IMU; only where the terrain is real. [rad]
  std::optional<double> mapped_pitch_rad{};
  double measured_pitch_rad = 0.0;
};

/// Short windows would measure camera noise (two millimetres); therefore tracks and camera are
/// compared over windows of 0.4 s, of which three in a row must show a standstill. No allocation;
/// safe in the real-time thread.
class TractionEstimator {
 public:
  void restart() { *this = TractionEstimator{}; }
  Traction update(const TractionInput& in);
  Traction state() const { return state_; }

 private:
  std::optional<double> ground_mps(const TractionInput& in);

  /// The result of a window holds until the next. A disturbance may falsify two windows.
  static constexpr double kWindowS = 0.4;

  TractionMonitor monitor_{{.immobilised_after_s = 2.25 * kWindowS}};
  Traction state_ = Traction::kHolding;
  Pose window_begin_{};
  bool window_open_ = false;
  double window_s_ = 0.0, window_distance_m_ = 0.0;
  double last_ground_mps_ = 0.0, last_track_mps_ = 0.0;
  bool judged_ = false;
  double mismatch_distance_m_ = 0.0;
};

}  // namespace tp100::bridge
