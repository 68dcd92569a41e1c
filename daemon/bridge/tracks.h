#pragma once
// Track speeds from counts, one sample interval at a time.

#include <optional>

#include "core/sample.h"
#include "estimation/motion.h"

namespace tp100::bridge {

/// One sample interval in device time.
struct Interval {
  double dt_s = 0.0;
  estimation::TrackSpeeds tracks{};
  double gyro_z_radps = 0.0;  ///< mean over the interval, calibrated scale, bias included
  bool gyro_fresh = false;    ///< both ends had a new IMU value
  double warming_degc = 0.0;  ///< rise of the gyro's temperature
};

/// Turns consecutive samples into intervals. No allocation; safe in the real-time thread.
class Tracks {
 public:
  Tracks(double counts_per_metre, double gyro_scale)
      : metres_per_count_(1.0 / counts_per_metre), gyro_scale_(gyro_scale) {}

  /// Forgets the last sample (a new session or boot).
  void restart() { has_last_ = false; }
  /// The next interval begins with `last`.
  void resume(const Sample& last) {
    has_last_ = true;
    last_ = last;
  }
  /// The next sample ends an interval.
  bool has_last() const { return has_last_; }
  /// The interval that ends with `sample`; nothing for the first sample or one that is not newer.
  std::optional<Interval> update(const Sample& sample);

  /// Calibrated z rate of a sample, bias included. [rad/s]
  double gyro_z_radps(const Sample& sample) const { return sample.gyro_radps[2] * gyro_scale_; }

 private:
  double metres_per_count_;
  double gyro_scale_;
  bool has_last_ = false;
  Sample last_{};
};

}  // namespace tp100::bridge
