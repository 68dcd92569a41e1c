#pragma once
// What a run was and what happened in it, as plain data: the input of metrics, table and JSON.

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/link_state.h"
#include "core/pose.h"
#include "core/slope.h"
#include "core/underfoot.h"

namespace tp100::report {

/// One instant of a run; all poses belong to the same time. World frame; yaw of any branch.
struct TrackPoint {
  double t_s = 0.0;  ///< from the start of the run
  Pose truth{};      ///< exact pose of the reference point; on a bench the steering pose
  Pose world{};     ///< the same in the course's world: behind `truth` where a virtual obstacle has
                    ///< cost the virtual robot way; judged against the reference path
  Pose model{};     ///< the model (model/track_model.h) on encoder counts alone
  Pose odometry{};  ///< encoders + gyro
  Pose fused{};     ///< with the overhead camera, if the run had one
  double progress_m =
      0.0;  ///< along the path, as the controller sees it; tells crossing pieces apart
  bool recovering = false;     ///< the controller noticed a disturbance and is not back yet
  double imu_pitch_rad = 0.0;  ///< by the IMU, of the real body
  Slope slope = Slope::kFlat;  ///< state told from it
  Obstacle leans_on = Obstacle::kNone;  ///< ... and from how it rose
};

/// Time during which someone pushed the robot.
struct ShoveWindow {
  double begin_s = 0.0;
  double end_s = 0.0;
};

/// What the pose filter did with the overhead camera's samples.
struct CameraFigures {
  std::uint32_t used = 0, rejected = 0, recoveries = 0;
  std::uint32_t judged = 0;  ///< samples that count for the mean
  double nis_mean = 0.0;     ///< kNisDegrees if noise is as assumed

  static constexpr double kNisDegrees = 3.0;
  /// Half width of the band around kNisDegrees in which the mean of independent samples lies 95
  /// times of a hundred.
  double nis_half_band() const { return 1.96 * std::sqrt(2.0 * kNisDegrees / judged); }
};

/// One run. `points` runs from the first to the last step of the course, ascending in time.
struct RunResult {
  std::string course, board, robot, setup;
  std::uint64_t seed = 0;
  bool finished = false;    ///< the controller came to the end of the course
  bool completed = false;   ///< ... and the true end lies within 15 cm of the path's
  std::string cause;        ///< why it was not completed; empty otherwise
  double duration_s = 0.0;  ///< virtual time of the run
  double realtime_factor = 0.0;
  bool has_camera = false;  ///< an overhead camera looked on; else `fused` is not judged
  std::vector<TrackPoint> points;
  std::vector<ShoveWindow> shoves;
  LinkCounters link{};
  CameraFigures camera{};
  std::vector<std::pair<std::string, double>> loop;  ///< figures of the loop by name
};

}  // namespace tp100::report
