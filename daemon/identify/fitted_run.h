#pragma once
// One run in a fit: its motion, its images, and its own unknowns.

#include <array>
#include <span>
#include <vector>

#include "core/arithmetic.h"
#include "identify/drive.h"
#include "identify/drive_motion.h"

namespace tp100::identify {

/// An image minus the predicted pose, in the world.
struct Residual {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
  double off_m() const { return magnitude(x_m, y_m); }
  double off_rad() const { return std::abs(yaw_rad); }
};

/// The median pose, of none the origin; robust against false detections.
Pose median_of(std::span<const SeenPose> seen);

struct FittedRun {
  /// Unknowns of a run: x, y, yaw of its start, and the zero of its gyro angle.
  static constexpr std::size_t kOwn = 4;
  using Own = std::array<double, kOwn>;

  /// Takes the start from the camera's images at standstill, robust against outliers; the images'
  /// yaw is on the branch given by the gyro.
  FittedRun(const RecordedDrive& drive, double counts_per_metre, double gyro_scale);

  std::string name;
  DriveMotion motion;
  std::vector<SeenPose> images;  ///< between first and last sample
  double images_per_s = 0.0;
  HandMeasured measured;
  Own own{};
  /// Usual distance between images and the fit's prediction of this run: a false detection is far
  /// beyond it, a model that does not fit is not.
  double usual_m = 0.0, usual_rad = 0.0;

  /// World pose of a pose since the start.
  Pose predicted(const Pose& driven) const;
  /// Residual of an image against the pose predicted for it.
  static Residual residual(const SeenPose& seen, const Pose& here) {
    return {seen.x_m - here.x_m, seen.y_m - here.y_m, seen.yaw_rad - here.yaw_rad};
  }
  /// Residual of an image that is `late_s` older than its time stamp.
  Residual residual(const std::vector<Pose>& poses, const SeenPose& seen, double late_s) const;
};

}  // namespace tp100::identify
