#pragma once
// Whether the robot still moves: tracks against the camera, and the map's slope against the IMU's.

#include <optional>

#include "core/estimates.h"
#include "core/pose.h"
#include "model/traction_monitor.h"

namespace tp100::bridge {

/// One sample interval of a run.
struct TractionInput {
  double dt_s = 0.0;
  double distance_m = 0.0;  ///< of the tracks' mean along the ground, slip taken off
  Pose fused{};             ///< at the interval's end
  bool camera = false;      ///< the fused pose has just been seen
  bool climbing = false;    ///< on a block, distances are not proportional
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

  /// The result of a window holds until the next. A disturbance may falsify two of them.
  static constexpr double kWindowS = 0.4;

  model::TractionMonitor monitor_{{.immobilised_after_s = 2.25 * kWindowS}};
  Traction state_ = Traction::kHolding;
  Pose window_begin_{};
  bool window_open_ = false;
  double window_s_ = 0.0, window_distance_m_ = 0.0;
  double last_ground_mps_ = 0.0, last_track_mps_ = 0.0;
  bool judged_ = false;
  double mismatch_distance_m_ = 0.0;
};

}  // namespace tp100::bridge
