#pragma once
// What a run keeps to evaluate the simpler forms of the model: its encoder counts and its gyro.

#include <cstdint>
#include <optional>

#include "core/sample.h"
#include "course/robot_file.h"
#include "model/model_form.h"

namespace tp100::report {

/// Sums of the robot's measurements up to a sample; only their differences have a meaning.
struct Measured {
  DeviceUs device_us = 0;
  std::int64_t left_counts = 0;
  std::int64_t right_counts = 0;
  double gyro_rad = 0.0;  ///< integral of the z rate, nominal scale, bias included
};

/// Sums up the samples of a session in their order.
class MeasuredMotion {
 public:
  void take(const Sample& sample);
  /// Up to the newest sample.
  const Measured& now() const { return now_; }
  /// Mean z rate while the tracks stood still the last time: the gyro's bias, nominal scale.
  double bias_radps() const { return bias_radps_; }

 private:
  bool started_ = false;
  Measured now_{}, standstill_{};  // standstill_: where it began
  double gyro_radps_ = 0.0;        // newest
  double bias_radps_ = 0.0;
};

/// The forms of one robot; without any, a run is not compared with them.
struct Baselines {
  model::PerBaseline<std::optional<model::TrackParameters>> forms{};  ///< nothing: not fitted
  double counts_per_metre = 0.0;
  double gyro_bias_radps = 0.0;  ///< of MeasuredMotion, when the run began
};

/// The forms in the robot's file, and those that need no fit. The caller sets the bias.
Baselines baselines_of(const course::Robot& robot, double turning_threshold_radps);

}  // namespace tp100::report
