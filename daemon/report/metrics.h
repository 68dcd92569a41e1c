#pragma once
// Figures of a run. Three things that are never mixed: how far the model was from the truth, how
// far the estimate was from the truth, and how far the truth was from the path.

#include <functional>
#include <optional>
#include <vector>

#include "course/course.h"
#include "course/path.h"
#include "report/recovery.h"
#include "report/run_result.h"
#include "report/slope_figures.h"

namespace tp100::report {

/// A pose against the truth: eq 8 point by point, and mean squared errors per axis.
struct PoseErrors {
  double max_position_error_m = 0.0;
  double mean_position_error_m = 0.0;
  double rms_position_error_m = 0.0;
  double final_position_error_m = 0.0;
  double mse_x_m2 = 0.0;
  double mse_y_m2 = 0.0;
  double mse_yaw_rad2 = 0.0;
  double max_yaw_error_rad = 0.0;
};

/// The true path against the reference.
struct TrackingErrors {
  double max_cross_track_m = 0.0;
  double rms_cross_track_m = 0.0;
  double max_yaw_error_rad =
      0.0;  ///< against the tangent; while turning on the spot, against the turn
  std::vector<std::optional<double>> recovery_s;  ///< per shove; nothing: never recovered
  std::vector<Recovery> recovery;                 ///< the same shoves in full
  int false_alarms = 0;  ///< disturbances that the controller noticed and nobody made
};

/// All figures of one run.
struct RunFigures {
  PoseErrors model{};                 ///< piece by piece between shoves, which encoders cannot see
  PoseErrors odometry{};              ///< from start to end
  std::optional<PoseErrors> fused{};  ///< from start to end, shoves included; only with a camera
  TrackingErrors tracking{};
  SlopeFigures slope{};
};

/// Which pose of a point is judged.
using PoseOf = std::function<const Pose&(const TrackPoint&)>;

/// Errors of one pose over the whole run.
PoseErrors pose_errors(const std::vector<TrackPoint>& points, const PoseOf& estimate);

/// Same, but set onto the truth again at the end of each shove; points within a shove do not count.
/// Shoves in ascending order, not overlapping.
PoseErrors pose_errors_between(const std::vector<TrackPoint>& points,
                               const std::vector<ShoveWindow>& shoves, const PoseOf& estimate);

/// True path against the reference.
TrackingErrors tracking_errors(const std::vector<TrackPoint>& points,
                               const std::vector<ShoveWindow>& shoves, const course::Path& path);

/// Everything.
RunFigures figures(const RunResult& run, const course::Course& course);

}  // namespace tp100::report
