#pragma once
// An overhead camera that finds the marker on the robot's back: what it reports, when, and how
// wrong. It shares no code with the estimator that takes this out again.

#include <cstdint>
#include <deque>
#include <optional>
#include <random>

#include "core/camera_sample.h"
#include "core/pose.h"
#include "course/camera.h"

namespace tp100::sim {

/// Pictures of one run; the same seed gives the same samples.
class OverheadCamera {
 public:
  /// Over (`middle_x_m`, `middle_y_m`) plus the values' offset.
  OverheadCamera(const course::EmulatedCamera& values, double middle_x_m, double middle_y_m,
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

  course::EmulatedCamera values_;
  double x_m_, y_m_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  double bias_x_m_ = 0.0, bias_y_m_ = 0.0;
  double first_frame_s_ = 0.0;
  std::uint32_t frames_ = 0;
  std::deque<Arrival> under_way_;
};

}  // namespace tp100::sim
