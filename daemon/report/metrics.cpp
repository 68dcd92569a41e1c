#include "report/metrics.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"

namespace tp100::report {
namespace {

/// A planar motion that carries one pose onto another.
struct Shift {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;

  static Shift from_to(const Pose& from, const Pose& to) {
    Shift shift;
    shift.yaw_rad = to.yaw_rad - from.yaw_rad;
    const double c = std::cos(shift.yaw_rad), s = std::sin(shift.yaw_rad);
    shift.x_m = to.x_m - (c * from.x_m - s * from.y_m);
    shift.y_m = to.y_m - (s * from.x_m + c * from.y_m);
    return shift;
  }
  Pose operator()(const Pose& pose) const {
    const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
    Pose moved = pose;
    moved.x_m = c * pose.x_m - s * pose.y_m + x_m;
    moved.y_m = s * pose.x_m + c * pose.y_m + y_m;
    moved.yaw_rad = pose.yaw_rad + yaw_rad;
    return moved;
  }
};

/// Sums up errors point by point.
class Tally {
 public:
  void add(const Pose& truth, const Pose& estimate) {
    const double dx = estimate.x_m - truth.x_m, dy = estimate.y_m - truth.y_m;
    const double dyaw = wrap_angle(estimate.yaw_rad - truth.yaw_rad);
    const double error = std::hypot(dx, dy);
    ++count_;
    sum_ += error;
    squares_x_ += dx * dx;
    squares_y_ += dy * dy;
    squares_yaw_ += dyaw * dyaw;
    result_.max_position_error_m = std::max(result_.max_position_error_m, error);
    result_.max_yaw_error_rad = std::max(result_.max_yaw_error_rad, std::abs(dyaw));
    result_.final_position_error_m = error;
  }

  PoseErrors result() const {
    PoseErrors result = result_;
    if (count_ == 0) return result;
    const auto n = static_cast<double>(count_);
    result.mean_position_error_m = sum_ / n;
    result.mse_x_m2 = squares_x_ / n;
    result.mse_y_m2 = squares_y_ / n;
    result.mse_yaw_rad2 = squares_yaw_ / n;
    result.rms_position_error_m = std::sqrt(result.mse_x_m2 + result.mse_y_m2);
    return result;
  }

 private:
  std::size_t count_ = 0;
  double sum_ = 0.0, squares_x_ = 0.0, squares_y_ = 0.0, squares_yaw_ = 0.0;
  PoseErrors result_{};
};

}  // namespace

PoseErrors pose_errors(const std::vector<TrackPoint>& points, const PoseOf& estimate) {
  return pose_errors_between(points, {}, estimate);
}

PoseErrors pose_errors_between(const std::vector<TrackPoint>& points,
                               const std::vector<ShoveWindow>& shoves, const PoseOf& estimate) {
  Tally tally;
  Shift shift;
  std::size_t next = 0;
  for (const TrackPoint& point : points) {
    if (next < shoves.size() && point.t_s > shoves[next].begin_s &&
        point.t_s < shoves[next].end_s) {
      continue;
    }
    // Also right for a shove shorter than the time between two points.
    if (next < shoves.size() && point.t_s >= shoves[next].end_s) {
      while (next < shoves.size() && point.t_s >= shoves[next].end_s) ++next;
      shift = Shift::from_to(estimate(point), point.truth);
    }
    tally.add(point.truth, shift(estimate(point)));
  }
  return tally.result();
}

TrackingErrors tracking_errors(const std::vector<TrackPoint>& points,
                               const std::vector<ShoveWindow>& shoves, const course::Path& path) {
  TrackingErrors result;
  if (points.empty()) return result;
  std::vector<Deviation> deviations;
  deviations.reserve(points.size());
  double squares = 0.0;
  for (const TrackPoint& point : points) {
    deviations.push_back(deviation(path, point));
    const Deviation& now = deviations.back();
    squares += now.cross_track_m * now.cross_track_m;
    result.max_cross_track_m = std::max(result.max_cross_track_m, now.cross_track_m);
    result.max_yaw_error_rad = std::max(result.max_yaw_error_rad, now.yaw_rad);
  }
  result.rms_cross_track_m = std::sqrt(squares / static_cast<double>(points.size()));
  result.recovery = recoveries(points, deviations, shoves);
  for (const Recovery& one : result.recovery) result.recovery_s.push_back(one.settling_s);
  result.false_alarms = false_alarms(points, shoves);
  return result;
}

RunFigures figures(const RunResult& run, const course::Course& course) {
  const course::Path path(course);
  RunFigures result;
  result.model = pose_errors_between(run.points, run.shoves,
                                     [](const TrackPoint& p) -> const Pose& { return p.model; });
  result.odometry =
      pose_errors(run.points, [](const TrackPoint& p) -> const Pose& { return p.odometry; });
  if (run.has_camera) {
    result.fused =
        pose_errors(run.points, [](const TrackPoint& p) -> const Pose& { return p.fused; });
  }
  result.tracking = tracking_errors(run.points, run.shoves, path);
  // Elsewhere the obstacles are not on the floor.
  result.slope =
      slope_figures(run.points, run.setup == "terrain" ? course.terrain : course::Terrain{});
  return result;
}

}  // namespace tp100::report
