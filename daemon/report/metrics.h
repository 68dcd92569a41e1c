#pragma once
// Metrics of a run. Three errors that are kept apart: the model against the truth, the estimate
// against the truth, and the truth against the path.

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/fields.h"
#include "course/course.h"
#include "course/path.h"
#include "report/run_result.h"

namespace tp100::report {

/// Tables and figures show errors in centimetres.
inline constexpr double kCmPerM = 100.0;

// Deviation of one true pose from the path.

struct Deviation {
  double cross_track_m = std::numeric_limits<double>::infinity();  ///< distance; not negative
  bool left = false;                                         ///< side of the path, looking along it
  double yaw_rad = std::numeric_limits<double>::infinity();  ///< from the tangent; not negative
};

/// Compares the true poses with the path in its order, one deviation per point: with the part up to
/// 0.3 m before and after the controller's progress, but not with the path beyond a turn on the
/// spot, where it may fold back. The place of the turn must also be reached: one of the poses there
/// is compared with it, those before with the path before it, and those after with the path after
/// it. While turning on the spot, yaw is compared with the commanded turn.
std::vector<Deviation> deviations(const course::Path& path,
                                  const std::vector<TrajectoryPoint>& points);

// Response to a disturbance: when it was detected, how large it became, how the robot recovered.

/// One disturbance. All values are true ones, except the controller's time of detection.
struct DisturbanceResponse {
  double begin_s = 0.0;  ///< of the disturbance, from the start of the run
  /// From there until the controller detected it; nothing: never.
  std::optional<double> detection_s{};
  double peak_cross_track_m = 0.0;  ///< until settled, including the disturbance
  double peak_yaw_error_rad = 0.0;
  /// From the end of the disturbance until the robot stayed within kRecoveredM and kRecoveredRad
  /// for kRecoveredForS; nothing: never.
  std::optional<double> settling_s{};
  /// Greatest distance to the other side of the path, until the end of that stay.
  double overshoot_m = 0.0;
  double shortcut_m = 0.0;  ///< length of path that was skipped; 0: none
};
TP100_FIELDS(DisturbanceResponse, begin_s, detection_s, peak_cross_track_m, peak_yaw_error_rad,
             settling_s, overshoot_m, shortcut_m)

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
TP100_FIELDS(PoseErrors, max_position_error_m, mean_position_error_m, rms_position_error_m,
             final_position_error_m, mse_x_m2, mse_y_m2, mse_yaw_rad2, max_yaw_error_rad)

/// The true path against the reference.
struct TrackingErrors {
  double max_cross_track_m = 0.0;
  double rms_cross_track_m = 0.0;
  /// From the tangent; while turning on the spot, from the commanded turn.
  double max_yaw_error_rad = 0.0;
  std::vector<DisturbanceResponse> recovery;  ///< per disturbance
  int false_alarms = 0;  ///< disturbances that the controller detected although there was none
};

/// Share of the instants at which the true pose lay within two standard deviations of an estimated
/// one, by its covariance: 0.95 if that is right and errors are normal.
struct Coverage {
  double position = 0.0;  ///< x and y, each counted by itself
  double yaw = 0.0;
};
/// `points` is not empty.
Coverage coverage(std::span<const TrajectoryPoint> points, PoseSource source);

/// All figures of one run.
struct RunFigures {
  /// From start to end, disturbances included; for a source that is blind to them, piece by piece
  /// between them. Nothing if the run has no such estimate.
  PerSource<std::optional<PoseErrors>> estimates{};
  /// Simpler forms of the model on the same counts, piece by piece between disturbances like the
  /// model. Nothing of a form that was not fitted to the robot, and on a stand.
  model::PerBaseline<std::optional<PoseErrors>> baselines{};
  TrackingErrors tracking{};
  /// Nothing on a stand, or if the run has no such estimate. Of a source that is blind to
  /// disturbances: up to the first one.
  PerSource<std::optional<Coverage>> within_2_sd{};
};

/// Selects the pose of a point to evaluate.
using PoseOf = std::function<const Pose&(const TrajectoryPoint&)>;

/// Errors of one pose, which is reset to the truth at the end of each disturbance; points within a
/// disturbance do not count. Disturbances in ascending order, not overlapping.
PoseErrors pose_errors(const std::vector<TrajectoryPoint>& points,
                       const std::vector<DisturbanceWindow>& disturbances, const PoseOf& estimate);

/// The poses that pose_errors() compares with the truth: one for each point, none within a
/// disturbance, and the points at which it was reset.
struct RestartedPoses {
  std::vector<std::optional<Pose>> poses;
  std::vector<std::size_t> restarts;
};
RestartedPoses restarted_poses(const std::vector<TrajectoryPoint>& points,
                               const std::vector<DisturbanceWindow>& disturbances,
                               const PoseOf& estimate);

/// True path against the reference.
TrackingErrors tracking_errors(const std::vector<TrajectoryPoint>& points,
                               const std::vector<DisturbanceWindow>& disturbances,
                               const course::Path& path);

/// Poses by a form of the model at the points of the run, from where the model began. Pure.
std::vector<Pose> baseline_poses(const RunResult& run, const model::ModelForm& form,
                                 const model::TrackParameters& parameters);

/// All metrics.
RunFigures figures(const RunResult& run, const course::Course& course);

}  // namespace tp100::report
