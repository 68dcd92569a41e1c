#pragma once
// Whether the belts still move the robot: gripping, slipping, immobilised.

#include <optional>

#include "core/underfoot.h"

namespace tp100::model {

/// When to change state. A speed here is along the robot, forward positive.
struct TractionLimits {
  double immobilised_share = 0.2;       ///< of the track speed, below which the robot stands
  double immobilised_after_s = 0.3;     ///< of such evidence without interruption
  double slipping_above = 0.4;          ///< |slip|; the paper's steepest ramp has 0.26
  double slipping_after_s = 0.1;        ///< of such evidence without interruption
  double recovered_below = 0.3;         ///< |slip| at which slipping and immobilised end
  double recovered_after_s = 0.1;       ///< of such evidence without interruption
  double least_track_speed_mps = 0.02;  ///< slower belts show nothing
};

/// State machine over track speed and an independent ground speed. No allocation; safe in the
/// real-time thread.
class TractionWatch {
 public:
  explicit TractionWatch(const TractionLimits& limits = {}) : limits_(limits) {}

  void reset() { *this = TractionWatch(limits_); }

  /// `dt_s` with belts at the mean speed `track_mps`. `ground_mps` comes from the camera or the
  /// accelerometer, never from the encoders; without one (or with values that are not finite) the
  /// state and its evidence stay as they are. Belts slower than the least track speed end every
  /// state, so that a stopped robot may try again.
  Traction update(double track_mps, std::optional<double> ground_mps, double dt_s);

  Traction state() const { return state_; }
  /// 1 - ground / track of the last judgement; 0 before there was one. Negative: sliding ahead.
  double slip() const { return slip_; }

 private:
  TractionLimits limits_;
  Traction state_ = Traction::kGripping;
  double slip_ = 0.0;
  double standing_s_ = 0.0;
  double slipping_s_ = 0.0;
  double recovered_s_ = 0.0;
};

}  // namespace tp100::model
