#pragma once
// One run that takes part in a fit: its motion, its pictures, and what is the run's own.

#include <array>
#include <cmath>
#include <vector>

#include "identify/drive.h"
#include "identify/drive_motion.h"

namespace tp100::identify {

/// A picture less the predicted pose, in the world.
struct Residual {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
  double off_m() const { return std::hypot(x_m, y_m); }
  double off_rad() const { return std::abs(yaw_rad); }
};

struct FittedRun {
  /// Unknowns of a run: x, y, yaw of its start, and the zero of its gyro angle.
  static constexpr std::size_t kOwn = 4;
  using Own = std::array<double, kOwn>;

  /// The start as the camera saw it at rest, outliers notwithstanding; the pictures' yaw on the
  /// branch that the gyro says.
  FittedRun(const Drive& drive, double counts_per_metre, double gyro_scale);

  std::string name;
  DriveMotion motion;
  std::vector<SeenPose> pictures;  ///< between first and last sample
  double pictures_per_s = 0.0;
  HandMeasured measured;
  Own own{};
  /// How far pictures usually are from what the fit predicts of this run: a false detection is far
  /// beyond, a model that does not fit is not.
  double usual_m = 0.0, usual_rad = 0.0;

  /// World pose at `t_s` from the poses since the start.
  Pose predicted(const std::vector<Pose>& poses, double t_s) const;
  /// Of a picture against the pose that is predicted for it.
  static Residual residual(const SeenPose& seen, const Pose& here) {
    return {seen.x_m - here.x_m, seen.y_m - here.y_m, seen.yaw_rad - here.yaw_rad};
  }
  /// Of a picture that is `late_s` older than its time says.
  Residual residual(const std::vector<Pose>& poses, const SeenPose& seen, double late_s) const;
};

}  // namespace tp100::identify
