#pragma once
// Gyro bias, learned while the robot stands still.

#include <cstdint>
#include <optional>

#include "core/sample.h"
#include "estimation/parameters.h"

namespace tp100::estimation {

/// Calibrated z rate of a gyro at rest, which is its bias.
struct RestRate {
  double radps = 0.0;
  double sd_radps = 0.0;
};

/// All conditions must hold for `still_s`: motors off, tracks at standstill and a quiet gyro.
/// Encoders alone would accept a robot turned by hand, the gyro alone a robot that turns slowly and
/// evenly. No allocation; safe in the real-time thread.
class Standstill {
 public:
  explicit Standstill(const Parameters& parameters) : parameters_(parameters) {}

  /// One more sample; `gyro_z_radps` is its calibrated z rate.
  void update(const Sample& sample, double gyro_z_radps);
  /// A new boot: counts restart; the bias is kept.
  void restart() { started_ = false; }
  /// As after construction, with this bias.
  void resume(double bias_radps, bool known) {
    *this = Standstill(parameters_);
    bias_radps_ = bias_radps;
    bias_known_ = known;
  }

  bool still() const { return still_; }
  /// The newest measurement of the bias: the mean over the whole window when the standstill is
  /// detected, then each sample; nothing unless the robot stands still.
  const std::optional<RestRate>& rest() const { return rest_; }
  /// True once a bias has been measured.
  bool bias_known() const { return bias_known_; }
  double bias_radps() const { return bias_radps_; }

 private:
  void begin_window(const Sample& sample, double gyro_z_radps);

  Parameters parameters_;
  bool started_ = false;
  bool still_ = false;
  bool bias_known_ = false;
  std::optional<RestRate> rest_{};
  double bias_radps_ = 0.0;
  std::int64_t left_counts_ = 0;
  std::int64_t right_counts_ = 0;
  DeviceUs window_start_us_ = 0;
  DeviceUs last_us_ = 0;
  std::int64_t window_size_ = 0;
  double window_mean_ = 0.0;
  double window_squares_ = 0.0;
};

}  // namespace tp100::estimation
