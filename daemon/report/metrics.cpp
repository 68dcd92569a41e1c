#include "report/metrics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/arithmetic.h"
#include "core/limits.h"
#include "core/pose.h"

namespace tp100::report {
namespace {

// A disturbance is detected at the latest when a camera has seen it twice.
constexpr double kNoticedWithinS = 0.5;

/// Points of one disturbance: from its beginning to the next one's.
struct Window {
  std::size_t begin = 0, end = 0;
};

Window window_of(const std::vector<TrajectoryPoint>& points, double begin_s, double end_s) {
  const auto before = [](const TrajectoryPoint& point, double t_s) { return point.t_s < t_s; };
  const auto first = std::lower_bound(points.begin(), points.end(), begin_s, before);
  const auto last = std::lower_bound(first, points.end(), end_s, before);
  return {static_cast<std::size_t>(first - points.begin()),
          static_cast<std::size_t>(last - points.begin())};
}

/// The points before the first disturbance.
std::span<const TrajectoryPoint> undisturbed(const RunResult& run) {
  const double until_s = run.disturbances.empty() ? HUGE_VAL : run.disturbances.front().begin_s;
  return std::span(run.points).first(window_of(run.points, -HUGE_VAL, until_s).end);
}

/// First and last point of the half second inside the limits; `window.end` twice if there is none.
Window settled(const std::vector<TrajectoryPoint>& points, const std::vector<Deviation>& deviations,
               const Window& window, double disturbed_until_s) {
  std::size_t since = window.end;
  for (std::size_t i = window.begin; i < window.end; ++i) {
    if (points[i].t_s < disturbed_until_s) continue;
    if (deviations[i].cross_track_m > kRecoveredM || deviations[i].yaw_rad > kRecoveredRad) {
      since = window.end;
      continue;
    }
    if (since == window.end) since = i;
    if (points[i].t_s - points[since].t_s >= kRecoveredForS) return {since, i};
  }
  return {window.end, window.end};
}

DisturbanceResponse recovery(const std::vector<TrajectoryPoint>& points,
                             const std::vector<Deviation>& deviations,
                             const DisturbanceWindow& disturbance, const Window& window) {
  DisturbanceResponse result;
  result.begin_s = disturbance.begin_s;
  const Window back = settled(points, deviations, window, disturbance.end_s);
  if (back.begin != window.end) result.settling_s = points[back.begin].t_s - disturbance.end_s;

  bool disturbed_left = false;
  for (std::size_t i = window.begin; i < back.begin; ++i) {
    if (points[i].recovering && !result.detection_s)
      result.detection_s = points[i].t_s - disturbance.begin_s;
    if (deviations[i].cross_track_m > result.peak_cross_track_m)
      disturbed_left = deviations[i].left;
    result.peak_cross_track_m = std::max(result.peak_cross_track_m, deviations[i].cross_track_m);
    result.peak_yaw_error_rad = std::max(result.peak_yaw_error_rad, deviations[i].yaw_rad);
  }
  const std::size_t last = std::min(back.end, window.end - 1);
  double driven_m = 0.0;
  for (std::size_t i = window.begin; i <= last; ++i) {
    if (points[i].t_s > disturbance.end_s && deviations[i].left != disturbed_left)
      result.overshoot_m = std::max(result.overshoot_m, deviations[i].cross_track_m);
    if (i > window.begin)
      driven_m += magnitude(points[i].world.x_m - points[i - 1].world.x_m,
                            points[i].world.y_m - points[i - 1].world.y_m);
  }
  const double gained_m = points[last].progress_m - points[window.begin].progress_m;
  result.shortcut_m = std::max(0.0, gained_m - driven_m);
  return result;
}

/// One entry per disturbance. `deviations` belong to `points`; disturbances ascending, not
/// overlapping.
std::vector<DisturbanceResponse> recoveries(const std::vector<TrajectoryPoint>& points,
                                            const std::vector<Deviation>& deviations,
                                            const std::vector<DisturbanceWindow>& disturbances) {
  std::vector<DisturbanceResponse> result;
  for (std::size_t i = 0; i < disturbances.size(); ++i) {
    const double until_s = i + 1 < disturbances.size() ? disturbances[i + 1].begin_s : HUGE_VAL;
    const Window window = window_of(points, disturbances[i].begin_s, until_s);
    result.push_back(window.begin == window.end
                         ? DisturbanceResponse{.begin_s = disturbances[i].begin_s}
                         : recovery(points, deviations, disturbances[i], window));
  }
  return result;
}

/// How often the controller detected a disturbance that did not occur.
int false_alarms(const std::vector<TrajectoryPoint>& points,
                 const std::vector<DisturbanceWindow>& disturbances) {
  int count = 0;
  bool before = false;
  for (const TrajectoryPoint& point : points) {
    const bool pushed = std::any_of(disturbances.begin(), disturbances.end(),
                                    [&](const DisturbanceWindow& disturbance) {
                                      return point.t_s >= disturbance.begin_s &&
                                             point.t_s <= disturbance.end_s + kNoticedWithinS;
                                    });
    if (point.recovering && !before && !pushed) ++count;
    before = point.recovering;
  }
  return count;
}

// Largest part of the path around the controller's progress that a pose is compared with.
constexpr double kWindowM = 0.3;
// At a corner, neighbouring segments are equally near, apart from the few millimetres by which the
// robot stops beside it.
constexpr double kCornerM = 0.01;

double yaw_error(const course::PathSegment& segment, const course::PathPoint& nearest,
                 double yaw_rad) {
  if (segment.kind != course::PathSegment::Kind::kPivot)
    return std::abs(wrap_angle(yaw_rad - nearest.yaw_rad));
  const double half = std::abs(segment.end.yaw_rad - segment.begin.yaw_rad) / 2.0;
  const double middle = (segment.end.yaw_rad + segment.begin.yaw_rad) / 2.0;
  return std::max(0.0, std::abs(wrap_angle(yaw_rad - middle)) - half);
}

/// Part of the path between two lengths from its start.
struct Stretch {
  double from_m, to_m;
};

/// Around `progress_m`. Not beyond a turn on the spot, where the path may fold back.
Stretch stretch_around(const course::Path& path, double progress_m) {
  Stretch part{progress_m - kWindowM, progress_m + kWindowM};
  for (const course::PathSegment& segment : path.segments()) {
    if (segment.kind != course::PathSegment::Kind::kPivot) continue;
    if (segment.begin.s_m < progress_m) part.from_m = std::max(part.from_m, segment.begin.s_m);
    if (segment.begin.s_m > progress_m) part.to_m = std::min(part.to_m, segment.begin.s_m);
  }
  return part;
}

Deviation deviation(const course::Path& path, const Pose& pose, double progress_m,
                    const Stretch& part) {
  Deviation result;
  result.cross_track_m = path.distance(pose.x_m, pose.y_m, part.from_m, part.to_m);
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.segments().size(); ++i) {
    const course::PathSegment& segment = path.segments()[i];
    if (segment.end.s_m < part.from_m || segment.begin.s_m > part.to_m) continue;
    const double offset_m =
        std::clamp(path.project(i, pose.x_m, pose.y_m, progress_m - segment.begin.s_m),
                   std::max(part.from_m - segment.begin.s_m, 0.0), part.to_m - segment.begin.s_m);
    const course::PathPoint near = path.at(i, offset_m);
    const double dx = pose.x_m - near.x_m, dy = pose.y_m - near.y_m;
    const double distance = magnitude(dx, dy);
    if (distance > result.cross_track_m + kCornerM) continue;
    result.yaw_rad = std::min(result.yaw_rad, yaw_error(segment, near, pose.yaw_rad));
    if (segment.kind == course::PathSegment::Kind::kPivot || distance >= nearest_m) continue;
    nearest_m = distance;
    result.left = dy * std::cos(near.yaw_rad) - dx * std::sin(near.yaw_rad) > 0.0;
  }
  if (!std::isfinite(result.yaw_rad)) result.yaw_rad = 0.0;
  return result;
}

bool turns_at(const course::Path& path, double progress_m) {
  return std::ranges::any_of(path.segments(), [&](const course::PathSegment& segment) {
    return segment.kind == course::PathSegment::Kind::kPivot && segment.begin.s_m == progress_m;
  });
}

/// Adds the deviations of the points [begin, end), at all of which the robot turns at one place:
/// some are compared with the path before it, one with the place itself, the others with the path
/// after it. That one is chosen as for the Frechet distance: so that the largest distance is
/// smallest.
void add_turn(const course::Path& path, const TrajectoryPoint* begin, const TrajectoryPoint* end,
              std::vector<Deviation>& deviations) {
  const double at_m = begin->progress_m;
  const Stretch part = stretch_around(path, at_m);
  std::vector<Deviation> before, at, after;
  for (const TrajectoryPoint* point = begin; point != end; ++point) {
    before.push_back(deviation(path, point->world, at_m, {part.from_m, at_m}));
    at.push_back(deviation(path, point->world, at_m, {at_m, at_m}));
    after.push_back(deviation(path, point->world, at_m, {at_m, part.to_m}));
  }
  std::vector<double> rest_m(at.size() + 1, 0.0);  // largest distance from the path after the turn
  for (std::size_t i = at.size(); i-- > 0;)
    rest_m[i] = std::max(rest_m[i + 1], after[i].cross_track_m);
  std::size_t reached = 0;
  double past_m = 0.0, smallest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double largest_m = std::max({past_m, at[i].cross_track_m, rest_m[i + 1]});
    if (largest_m < smallest_m) {
      smallest_m = largest_m;
      reached = i;
    }
    past_m = std::max(past_m, before[i].cross_track_m);
  }
  for (std::size_t i = 0; i < at.size(); ++i) {
    deviations.push_back(i < reached ? before[i] : i > reached ? after[i] : at[i]);
    deviations.back().yaw_rad = at[i].yaw_rad;
  }
}

}  // namespace

std::vector<Deviation> deviations(const course::Path& path,
                                  const std::vector<TrajectoryPoint>& points) {
  std::vector<Deviation> result;
  result.reserve(points.size());
  while (result.size() < points.size()) {
    const TrajectoryPoint* const point = &points[result.size()];
    const TrajectoryPoint* end = point + 1;
    if (turns_at(path, point->progress_m)) {
      while (end != points.data() + points.size() && end->progress_m == point->progress_m) ++end;
      add_turn(path, point, end, result);
    } else {
      result.push_back(deviation(path, point->world, point->progress_m,
                                 stretch_around(path, point->progress_m)));
    }
  }
  return result;
}

namespace {

/// Sums up errors point by point.
class Tally {
 public:
  void add(const Pose& truth, const Pose& estimate) {
    const double dx = estimate.x_m - truth.x_m, dy = estimate.y_m - truth.y_m;
    const double dyaw = wrap_angle(estimate.yaw_rad - truth.yaw_rad);
    const double error = magnitude(dx, dy);
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

RestartedPoses restarted_poses(const std::vector<TrajectoryPoint>& points,
                               const std::vector<DisturbanceWindow>& disturbances,
                               const PoseOf& estimate) {
  RestartedPoses restarted;
  restarted.poses.reserve(points.size());
  Transform2d transform;
  std::size_t next = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const TrajectoryPoint& point = points[i];
    if (next < disturbances.size() && point.t_s > disturbances[next].begin_s &&
        point.t_s < disturbances[next].end_s) {
      restarted.poses.emplace_back();
      continue;
    }
    // Also correct for a disturbance shorter than the time between two points.
    if (next < disturbances.size() && point.t_s >= disturbances[next].end_s) {
      while (next < disturbances.size() && point.t_s >= disturbances[next].end_s) ++next;
      transform = Transform2d::between(estimate(point), point.truth);
      restarted.restarts.push_back(i);
    }
    restarted.poses.emplace_back(transform.of(estimate(point)));
  }
  return restarted;
}

PoseErrors pose_errors(const std::vector<TrajectoryPoint>& points,
                       const std::vector<DisturbanceWindow>& disturbances, const PoseOf& estimate) {
  Tally tally;
  const RestartedPoses restarted = restarted_poses(points, disturbances, estimate);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (restarted.poses[i]) tally.add(points[i].truth, *restarted.poses[i]);
  return tally.result();
}

TrackingErrors tracking_errors(const std::vector<TrajectoryPoint>& points,
                               const std::vector<DisturbanceWindow>& disturbances,
                               const course::Path& path) {
  TrackingErrors result;
  if (points.empty()) return result;
  const std::vector<Deviation> deviations = report::deviations(path, points);
  double squares = 0.0;
  for (const Deviation& now : deviations) {
    squares += now.cross_track_m * now.cross_track_m;
    result.max_cross_track_m = std::max(result.max_cross_track_m, now.cross_track_m);
    result.max_yaw_error_rad = std::max(result.max_yaw_error_rad, now.yaw_rad);
  }
  result.rms_cross_track_m = std::sqrt(squares / static_cast<double>(points.size()));
  result.recovery = recoveries(points, deviations, disturbances);
  result.false_alarms = false_alarms(points, disturbances);
  return result;
}

std::vector<Pose> baseline_poses(const RunResult& run, const model::ModelForm& form,
                                 const model::TrackParameters& parameters) {
  std::vector<Pose> poses;
  if (run.points.empty()) return poses;
  const Pose& start = run.points.front().estimates[PoseSource::kModel];
  model::DeadReckoning reckoning(form, parameters, start);
  const Measured* last = &run.points.front().measured;
  for (const TrajectoryPoint& point : run.points) {
    const Measured& now = point.measured;
    const double dt_s = static_cast<double>(now.device_us - last->device_us) * 1e-6;
    const auto speed_mps = [&](std::int64_t counts) {
      return static_cast<double>(counts) / run.baselines.counts_per_metre / dt_s;
    };
    if (dt_s > 0.0)
      reckoning.advance(speed_mps(now.left_counts - last->left_counts),
                        speed_mps(now.right_counts - last->right_counts),
                        (now.gyro_rad - last->gyro_rad) / dt_s - run.baselines.gyro_bias_radps,
                        dt_s);
    poses.push_back(reckoning.pose());
    last = &now;
  }
  return poses;
}

Coverage coverage(std::span<const TrajectoryPoint> points, PoseSource source) {
  double position = 0.0, yaw = 0.0;
  const auto within = [](double error, double sd) { return std::abs(error) <= 2.0 * sd; };
  for (const TrajectoryPoint& point : points) {
    const Pose& pose = point.estimates[source];
    const PoseSd& sd = point.sd[source];
    position += 0.5 * within(pose.x_m - point.truth.x_m, sd.x_m);
    position += 0.5 * within(pose.y_m - point.truth.y_m, sd.y_m);
    yaw += within(wrap_angle(pose.yaw_rad - point.truth.yaw_rad), sd.yaw_rad);
  }
  const auto count = static_cast<double>(points.size());
  return {position / count, yaw / count};
}

RunFigures figures(const RunResult& run, const course::Course& course) {
  const course::Path path(course);
  const bool stand = run.setup == "stand";  // there the truth is an estimate itself
  RunFigures result;
  for (const PoseSource source : kPoseSources) {
    if (!run.has_estimate(source)) continue;
    const PoseOf estimate = [source](const TrajectoryPoint& p) -> const Pose& {
      return p.estimates[source];
    };
    const bool blind = blind_to_disturbances(source);
    result.estimates[source] = pose_errors(
        run.points, blind ? run.disturbances : std::vector<DisturbanceWindow>{}, estimate);
    const auto judged = blind ? undisturbed(run) : std::span(run.points);
    if (!stand && !judged.empty()) result.within_2_sd[source] = coverage(judged, source);
  }
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i) {
    const auto& form = run.baselines.forms[i];
    if (!form || stand) continue;
    const std::vector<Pose> poses = baseline_poses(run, model::kBaselines[i], *form);
    result.baselines[i] =
        pose_errors(run.points, run.disturbances, [&](const TrajectoryPoint& point) -> const Pose& {
          return poses[static_cast<std::size_t>(&point - run.points.data())];
        });
  }
  result.tracking = tracking_errors(run.points, run.disturbances, path);
  return result;
}

}  // namespace tp100::report
