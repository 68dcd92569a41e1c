#pragma once
// An overhead camera that finds the marker on the robot's back: its reports, their delay and their
// errors. It shares no code with the estimator that corrects them.

#include <cstdint>
#include <deque>
#include <optional>
#include <random>

#include "core/pose.h"
#include "core/sample.h"
#include "core/time.h"
#include "course/camera.h"

namespace tp100::sim {

/// Images of one run; the same seed gives the same samples.
class OverheadCamera {
 public:
  /// The camera is above (`middle_x_m`, `middle_y_m`) plus the values' offset.
  OverheadCamera(const course::EmulatedCamera& values, double middle_x_m, double middle_y_m,
                 std::uint64_t seed);

  /// Passes the body's exact pose at virtual time `now_ns`; call once per physics step.
  void look(const Pose& truth, HostNs now_ns);
  /// The next sample that has arrived by `now_ns`, in order.
  std::optional<CameraSample> take(HostNs now_ns);

 private:
  struct Arrival {
    HostNs at_ns;
    CameraSample sample;
  };
  /// Where the image shows a point of the body (given in body axes), in the marker's plane.
  struct Image {
    double x_m, y_m;
  };
  Image image(const Pose& body, double forward_m, double up_m) const;
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
