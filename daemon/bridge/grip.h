#pragma once
// Whether the robot still gets ahead: belts against the camera, and the map's slope against the
// IMU's.

#include <optional>

#include "core/pose.h"
#include "core/underfoot.h"
#include "model/traction_watch.h"

namespace tp100::bridge {

/// One sample interval of a run.
struct GripInput {
  double dt_s = 0.0;
  double way_m = 0.0;     ///< of the belts' mean along the ground, slip taken off
  Pose fused{};           ///< at the interval's end
  bool camera = false;    ///< the fused pose has just been seen
  bool climbing = false;  ///< on a block nothing is in proportion
  /// Pitch by the map at the steering pose, and by the IMU; only where the terrain is real. [rad]
  std::optional<double> mapped_pitch_rad{};
  double measured_pitch_rad = 0.0;
};

/// Camera noise of two millimetres over a short time is no speed, so belts and camera are compared
/// over windows; three in a row have to say that the robot stands. No allocation; safe in the
/// real-time thread.
class Grip {
 public:
  void restart() { *this = Grip{}; }
  Traction update(const GripInput& in);
  Traction state() const { return state_; }

 private:
  std::optional<double> ground_mps(const GripInput& in);

  /// What a window says holds until the next. A shove may spoil two of them.
  static constexpr double kWindowS = 0.4;

  model::TractionWatch watch_{{.immobilised_after_s = 2.25 * kWindowS}};
  Traction state_ = Traction::kGripping;
  Pose window_begin_{};
  bool window_open_ = false;
  double window_s_ = 0.0, window_way_m_ = 0.0;
  double last_ground_mps_ = 0.0, last_track_mps_ = 0.0;
  bool judged_ = false;
  double mismatch_way_m_ = 0.0;
};

}  // namespace tp100::bridge
