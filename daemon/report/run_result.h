#pragma once
// A run and its events as plain data, the input of metrics, table and JSON; and its poses as files:
// CSV of all poses, TUM lines for evo.

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "core/estimates.h"
#include "core/faults.h"
#include "core/link_state.h"
#include "core/pose.h"
#include "core/run_state.h"
#include "core/time.h"
#include "course/path.h"
#include "report/baselines.h"

namespace tp100::report {

/// Standard deviations of a pose, by its estimator.
struct PoseSd {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
};

inline PerSource<PoseSd> sd_of(const PerSource<Estimate>& estimates) {
  PerSource<PoseSd> sd;
  for (const PoseSource source : kPoseSources) {
    const PlanarCovariance& covariance = estimates[source].covariance;
    sd[source] = {std::sqrt(covariance.xx), std::sqrt(covariance.yy),
                  std::sqrt(covariance.yaw_yaw)};
  }
  return sd;
}

/// One instant of a run; all poses belong to the same time. World frame; yaw may exceed [-pi, pi].
struct TrajectoryPoint {
  double t_s = 0.0;  ///< from the start of the run
  Pose truth{};      ///< exact pose of the reference point; on a stand the steering pose
  Pose world{};  ///< in the course's world, compared with the path; behind `truth` by the distance
                 ///< that virtual obstacles cost
  PerSource<Pose> estimates{};  ///< valid where RunResult::has_estimate()
  PerSource<PoseSd> sd{};       ///< of these
  /// Along the path, as estimated by the controller; distinguishes crossing segments.
  double progress_m = 0.0;
  bool recovering = false;     ///< the controller detected a disturbance and has not recovered yet
  double imu_pitch_rad = 0.0;  ///< by the IMU, of the real body
  Slope slope = Slope::kFlat;  ///< state derived from it
  ObstacleClass obstacle_class = ObstacleClass::kNone;  ///< ... and from its rise
  Measured measured{};                                  ///< by the robot, up to this instant
};

/// Time window of a disturbance.
struct DisturbanceWindow {
  double begin_s = 0.0;
  double end_s = 0.0;
};

/// How the pose filter used the overhead camera's samples.
struct CameraFigures {
  std::uint32_t used = 0, rejected = 0, recoveries = 0;
  std::uint32_t judged = 0;  ///< samples that count for the mean
  double nis_mean = 0.0;     ///< kNisDegrees if noise is as assumed

  /// Half width of the band around kNisDegrees that contains the mean of independent samples with a
  /// probability of 95 %.
  double nis_half_band() const { return kNormal95 * std::sqrt(2.0 * kNisDegrees / judged); }
};

/// Figures as of a step of the run.
inline CameraFigures camera_figures(const FilterFigures& filter) {
  return {.used = filter.camera_used,
          .rejected = filter.camera_rejected,
          .recoveries = filter.recoveries,
          .judged = filter.nis_count,
          .nis_mean = filter.nis_mean};
}

/// One run. `points` runs from the first to the last step of the course, ascending in time.
struct RunResult {
  std::string course, board, robot, setup;
  std::string body;   ///< of an emulated robot: contact law; empty in recordings
  std::string floor;  ///< of an emulated robot: even or uneven; empty in recordings
  std::uint64_t seed = 0;
  bool finished = false;           ///< the controller reached the end of the course
  bool completed = false;          ///< ... and the robot was at_end() then
  std::string cause;               ///< why it was not completed; empty otherwise
  std::optional<HostNs> began_ns;  ///< where t_s is 0; empty: the run never began
  double duration_s = 0.0;         ///< virtual time of the run
  double realtime_factor = 0.0;
  bool has_camera = false;  ///< an overhead camera was in use; see has_estimate()
  std::vector<TrajectoryPoint> points;
  std::vector<DisturbanceWindow> disturbances;
  LinkCounters link{};     ///< since the start of the program, by the last step
  CameraFigures camera{};  ///< by the last step of the run
  Baselines baselines{};
  std::vector<std::pair<std::string, double>> loop;  ///< figures of the loop by name

  /// Whether the run has all inputs of the estimate.
  bool has_estimate(PoseSource source) const { return has_camera || !needs_camera(source); }
};

/// Cause of a run that never began.
inline constexpr const char* kNeverBegan = "never began";

/// Whether the robot truly stands at the end of the path, within kEndToleranceM.
bool at_end(const course::Path& path, const Pose& truth);
/// Judges how a run ended, if it began: by the state after kRunning, or kRunning if none is known,
/// by its faults and by at_end() then, if that is known.
void judge_end(RunResult& result, RunState state, FaultMask faults, std::optional<bool> at_end);

/// The columns of a pose in a CSV header, each after a comma: `,<name>_x_m` and y_m, z_m, roll_rad,
/// pitch_rad, yaw_rad.
std::string pose_columns(std::string_view name);

/// Every pose of a run, with the truth, as CSV. Header t_s, then x_m, y_m, z_m, roll_rad, pitch_rad
/// and yaw_rad with the prefixes truth_, world_ and those of the estimates that the run has, and
/// progress_m. One row per instant, t_s from the start of the run, full double precision.
std::string poses_csv(const RunResult& result);

/// A line of the TUM format, which evo and rpg_trajectory_evaluation read: one per pose, `time x y
/// z qx qy qz qw`, seconds and metres, with its line feed. Keeps microseconds and micrometres.
std::string tum_line(double t_s, const Pose& pose);

}  // namespace tp100::report
