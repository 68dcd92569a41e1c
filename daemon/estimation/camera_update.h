#pragma once
// The overhead camera as a measurement: expected marker pose, noise, gate.

#include <Eigen/Core>

#include "core/sample.h"
#include "estimation/kalman.h"
#include "estimation/motion.h"
#include "estimation/parameters.h"

namespace tp100::estimation {

/// A camera over the floor that looks straight down.
struct CameraPlace {
  double x_m = 0.0, y_m = 0.0;  ///< below the lens, world frame
};

/// Expected marker of a robot at (x, y, yaw) on this ground. The marker is raised, tilted with the
/// body, and displaced from the camera's foot in proportion to its height over the plane of the
/// homography. Its direction is that of its two ends as seen. Pure.
Eigen::Vector3d expected_marker(const Eigen::Vector3d& pose, const Ground& ground,
                                const CameraParameters& camera, const CameraPlace& place);

/// Outcome of a sample.
enum class CameraVerdict {
  kUsed,
  kRejected,   ///< beyond the gate
  kRecovered,  ///< the second contradiction in a row: the estimate was reset
};

/// Judges samples and applies them. It keeps only the number of contradictions in a row. No
/// allocation.
class CameraUpdate {
 public:
  CameraUpdate(const CameraParameters& camera, const CameraPlace& place)
      : camera_(camera), place_(place) {}

  /// Applies `seen` to the state at its time of measurement. `twist` is the motion then.
  CameraVerdict apply(FilterState& state, const CameraSample& seen, const Ground& ground,
                      const Twist& twist, const MotionModel& motion);
  /// As after construction, with the NIS of the last sample.
  void resume(double nis) {
    *this = CameraUpdate(camera_, place_);
    nis_ = nis;
  }
  /// NIS of the last sample, before any recovery.
  double nis() const { return nis_; }

 private:
  bool contradicted(const Eigen::Vector3d& innovation);

  CameraParameters camera_;
  CameraPlace place_;
  double nis_ = 0.0;
  int contradictions_ = 0;
  int rejections_ = 0;
  Eigen::Vector3d contradiction_ = Eigen::Vector3d::Zero();
};

}  // namespace tp100::estimation
