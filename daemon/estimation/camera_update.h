#pragma once
// The overhead camera as a measurement: what it should see, its noise, its gate.

#include <Eigen/Core>

#include "core/camera_sample.h"
#include "estimation/kalman_update.h"
#include "estimation/motion.h"
#include "estimation/nis.h"
#include "estimation/parameters.h"

namespace tp100::estimation {

/// A camera over the floor that looks straight down.
struct CameraPlace {
  double x_m = 0.0, y_m = 0.0;  ///< below the lens, world frame
};

/// What the camera should show of a robot at (x, y, yaw) on this ground: the marker is raised,
/// tilted with the body, and shifted away from the camera's foot by what it rises over the plane of
/// the homography. Its direction is that of its two ends as seen. Pure.
Eigen::Vector3d expected_marker(const Eigen::Vector3d& pose, const Ground& ground,
                                const CameraParameters& camera, const CameraPlace& place);

/// What became of a sample.
enum class CameraVerdict {
  kUsed,
  kRejected,   ///< beyond the gate
  kRecovered,  ///< the second contradiction in a row: the estimate gave way
};

/// Judges samples and applies them. Remembers only the contradictions in a row. No allocation.
class CameraUpdate {
 public:
  CameraUpdate(const CameraParameters& camera, const CameraPlace& place)
      : camera_(camera), place_(place) {}

  /// Applies `seen` to the state of the instant at which it was measured. `twist` is the motion
  /// then.
  CameraVerdict apply(FilterState& state, const CameraSample& seen, const Ground& ground,
                      const Twist& twist, const MotionModel& motion);
  /// Of the last sample, before any recovery.
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
