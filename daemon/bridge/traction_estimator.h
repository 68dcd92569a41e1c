#pragma once
// Whether the robot still moves: tracks against the camera, and the map's slope against the IMU's.

#include <optional>

#include "core/estimates.h"
#include "core/pose.h"

namespace tp100::bridge {

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
/// compared over windows of 0.4 s, of which three in a row must show a standstill. Without a camera
/// the state stays as it is; tracks that stand end it, so that a stopped robot may try again. No
/// allocation; safe in the real-time thread.
class TractionEstimator {
 public:
  void restart() { *this = TractionEstimator{}; }
  Traction update(const TractionInput& in);
  Traction state() const { return state_; }

 private:
  std::optional<double> ground_mps(const TractionInput& in);
  void judge(double track_mps, std::optional<double> ground_mps, double dt_s);

  /// The result of a window holds until the next. A disturbance may falsify two windows.
  static constexpr double kWindowS = 0.4;
  static constexpr double kImmobilisedAfterS = 2.25 * kWindowS;

  Traction state_ = Traction::kHolding, by_speed_ = Traction::kHolding;
  double standing_s_ = 0.0, slipping_s_ = 0.0, recovered_s_ = 0.0;  ///< evidence without a break
  Pose window_begin_{};
  bool window_open_ = false;
  double window_s_ = 0.0, window_distance_m_ = 0.0;
  double last_ground_mps_ = 0.0, last_track_mps_ = 0.0;
  bool judged_ = false;
  double mismatch_distance_m_ = 0.0;
};

}  // namespace tp100::bridge
