#pragma once
// An overhead camera that finds the marker on the robot's back: what it reports, when, and how
// wrong. It shares no code with the estimator that takes this out again.

#include <cstdint>
#include <deque>
#include <optional>
#include <random>

#include "core/angle.h"
#include "core/camera_sample.h"
#include "core/pose.h"

namespace tp100::sim {

/// One camera. Its lens looks straight down on the floor.
struct OverheadCameraValues {
  double rate_hz = 33.0;
  double delay_s = 0.060;         ///< from the picture to the sample's arrival
  double delay_jitter_s = 0.008;  ///< standard deviation of that
  double stamp_error_s = 0.001;   ///< standard deviation of the time stamp
  double noise_m = 0.0015;        ///< standard deviation per axis
  double noise_rad = 0.4 * kRadPerDeg;
  double bias_m = 0.0015;   ///< error of the place that stays, its direction drawn by the seed
  double dropped = 0.03;    ///< share of the frames without a detection
  double outliers = 0.0;    ///< share of the frames with a false one
  double outlier_m = 0.3;   ///< a false detection lies this far away at most, in each axis
  double height_m = 2.5;    ///< of the lens above the floor
  double offset_x_m = 0.0;  ///< of the lens from the middle of the course's fence
  double offset_y_m = 0.0;
  double marker_height_m = 0.06;  ///< above the reference point; also the plane it measures in
  double marker_size_m = 0.10;
};

/// Pictures of one run; the same seed gives the same samples.
class OverheadCamera {
 public:
  /// Over (`middle_x_m`, `middle_y_m`) plus the values' offset.
  OverheadCamera(const OverheadCameraValues& values, double middle_x_m, double middle_y_m,
                 std::uint64_t seed);

  /// Shows it the body's exact pose at virtual time `now_ns`; call once per physics step.
  void look(const Pose& truth, std::int64_t now_ns);
  /// The next sample that has arrived by `now_ns`, in order.
  std::optional<CameraSample> take(std::int64_t now_ns);

 private:
  struct Arrival {
    std::int64_t at_ns;
    CameraSample sample;
  };
  /// A point of the body, given in its own axes, as the picture shows it in the marker's plane.
  struct Picture {
    double x_m, y_m;
  };
  Picture picture(const Pose& body, double forward_m, double up_m) const;
  double normal() { return normal_(random_); }
  double uniform() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

  OverheadCameraValues values_;
  double x_m_, y_m_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  double bias_x_m_ = 0.0, bias_y_m_ = 0.0;
  double first_frame_s_ = 0.0;
  std::uint32_t frames_ = 0;
  std::deque<Arrival> under_way_;
};

}  // namespace tp100::sim
