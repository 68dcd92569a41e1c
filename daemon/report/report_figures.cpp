#include "report/report_figures.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/arithmetic.h"
#include "course/path.h"
#include "report/chart.h"
#include "report/metrics.h"

namespace tp100::report {
namespace {

constexpr std::size_t kMaxPointsOfRun = 2000;

using Value = std::function<double(const RecordedRun&, const TrajectoryPoint&, const RunMoment&)>;
using Line = ChartSeries;

/// `value` over time.
Line over_time(const RecordedRun& run, Line line, const Value& value) {
  for (std::size_t i = 0; i < run.moments.size(); ++i)
    line.points.emplace_back(run.result.points[i].t_s,
                             value(run, run.result.points[i], run.moments[i]));
  return line;
}

Line map_of(const RecordedRun& run, Line line,
            const std::function<const Pose&(const TrajectoryPoint&)>& pose) {
  for (const TrajectoryPoint& point : run.result.points)
    line.points.emplace_back(pose(point).x_m, pose(point).y_m);
  return line;
}

/// Below the estimates, which it would hide or be hidden by.
Line truth_line() { return {.name = "truth", .colour = kTruthColour, .broad = true}; }

Line planned(const course::Course& course) {
  constexpr int kParts = 600;
  Line line{.name = "path", .colour = kPathColour, .dashed = true};
  const course::Path path(course);
  for (int i = 0; i <= kParts; ++i) {
    const course::PathPoint at = path.at(path.length_m() * i / kParts);
    line.points.emplace_back(at.x_m, at.y_m);
  }
  return line;
}

Chart of_time(const std::string& title, const std::string& y_label, std::vector<Line> lines = {}) {
  return {.title = title, .x_label = "time [s]", .y_label = y_label, .series = std::move(lines)};
}

Chart map(const std::string& title) {
  return {.title = title, .x_label = "x [m]", .y_label = "y [m]", .equal_scale = true};
}

/// One value of a run over time, in a figure of its own; several runs are overlaid.
struct Plot {
  const char *name, *title, *y_label, *caption;
  Value value;
};

Plot tracking() {
  return {"tracking", "Cross-track, as the controller saw it", "left of the path [cm]",
          "The steering pose against the path.",
          [](auto&, auto&, auto& m) { return m.cross_track_m * kCmPerM; }};
}

Plot jitter() {
  return {"jitter", "Jitter", "|step - period| [us]",
          "Time between two steps against the loop's period.",
          [](auto&, auto&, auto& m) { return m.jitter_us; }};
}

Figure figure_of(const Plot& plot, const RecordedRun& run) {
  const Line line = over_time(run, {.colour = kValueColour}, plot.value);
  return {plot.name, svg(of_time(plot.title, plot.y_label, {line})), plot.caption};
}

double distance_cm(const Pose& a, const Pose& b) {
  return kCmPerM * magnitude(a.x_m - b.x_m, a.y_m - b.y_m);
}

std::vector<PoseSource> estimates_of(const RecordedRun& run) {
  std::vector<PoseSource> estimates;
  for (const PoseSource source : kPoseSources)
    if (run.result.has_estimate(source)) estimates.push_back(source);
  return estimates;
}

Line line_of(PoseSource source) {
  return {.name = std::string(to_string(source)), .colour = colour_of(source)};
}

Figure path_figure(const RecordedRun& run) {
  Chart chart = map("Path");
  if (run.run_context.course != nullptr) chart.series.push_back(planned(*run.run_context.course));
  if (run.has_truth)
    chart.series.push_back(
        map_of(run, truth_line(), [](const TrajectoryPoint& p) -> const Pose& { return p.truth; }));
  for (const PoseSource source : estimates_of(run))
    chart.series.push_back(
        map_of(run, line_of(source),
               [&](const TrajectoryPoint& p) -> const Pose& { return p.estimates[source]; }));
  return {
      "path", svg(chart),
      "Where the robot was: the truth, if known, is the broad band, estimates are lines on it."};
}

Figure yaw_figure(const RecordedRun& run) {
  Chart chart = of_time("Yaw", "yaw [deg]");
  if (run.has_truth)
    chart.series.push_back(over_time(
        run, truth_line(), [](auto&, auto& p, auto&) { return p.truth.yaw_rad * kDegPerRad; }));
  for (const PoseSource source : estimates_of(run))
    chart.series.push_back(over_time(run, line_of(source), [&](auto&, auto& p, auto&) {
      return p.estimates[source].yaw_rad * kDegPerRad;
    }));
  return {"yaw", svg(chart), "Yaw, counted on beyond a full turn."};
}

/// How far each estimate is from the truth; without one, from odometry.
std::vector<Line> error_lines(const RecordedRun& run) {
  std::vector<Line> lines;
  for (const PoseSource source : estimates_of(run)) {
    if (!run.has_truth && source == PoseSource::kOdometry) continue;
    lines.push_back(over_time(run, line_of(source), [&](auto&, auto& p, auto&) {
      return distance_cm(p.estimates[source],
                         run.has_truth ? p.truth : p.estimates[PoseSource::kOdometry]);
    }));
  }
  return lines;
}

Figure error_figure(const RecordedRun& run) {
  return {
      "error",
      svg(of_time(run.has_truth ? "Distance from the truth" : "Distance from odometry",
                  "distance [cm]", error_lines(run))),
      run.has_truth
          ? "How far each estimate was from the truth, from start to end, disturbances included."
          : "The truth is not known: how far the estimates were from each other, which is no "
            "error."};
}

Figure uncertainty_figure(const RecordedRun& run) {
  Chart chart = of_time("Uncertainty", "distance [cm]");
  if (run.has_truth) chart.series = error_lines(run);
  for (const PoseSource source : estimates_of(run)) {
    Line line = line_of(source);
    line.name += ", 2 sd";
    line.dashed = true;
    chart.series.push_back(over_time(run, line, [&](auto&, auto& p, auto&) {
      return 2.0 * kCmPerM * magnitude(p.sd[source].x_m, p.sd[source].y_m);
    }));
  }
  return {
      "uncertainty", svg(chart),
      std::string("Dashed: two standard deviations of each position, by its own covariance.") +
          (run.has_truth ? " Lines: its distance from the truth, as in the figure before." : "")};
}

Figure slip_figure(const RecordedRun& run) {
  const auto left = [](auto&, auto&, auto& m) { return m.slip_left; };
  const auto right = [](auto&, auto&, auto& m) { return m.slip_right; };
  return {"slip",
          svg(of_time("Slip in use", "slip ratio",
                      {over_time(run, {.name = "left", .colour = kLeftColour}, left),
                       over_time(run, {.name = "right", .colour = kRightColour}, right)})),
          "Slip ratios that the model used."};
}

Figure climb_figure(const RecordedRun& run) {
  Chart chart = of_time("Climb angle", "nose up [deg]");
  if (run.has_truth)
    chart.series.push_back(over_time(
        run, truth_line(), [](auto&, auto& p, auto&) { return -p.truth.pitch_rad * kDegPerRad; }));
  chart.series.push_back(
      over_time(run, {.name = "robot in the course's world", .colour = kValueColour},
                [](auto&, auto&, auto& m) { return -m.steering_world.pitch_rad * kDegPerRad; }));
  return {"climb", svg(chart),
          "Where obstacles are virtual, the truth lies on the flat floor below them."};
}

/// A colour for each of several runs; dashed where colours repeat.
Line line_of(const ComparedRun& run, std::size_t i) {
  return {.name = run.name, .colour = colour_of_run(i), .dashed = i >= kRunColours};
}

const Pose& shown_pose(const RecordedRun& run, const TrajectoryPoint& point) {
  return run.has_truth ? point.truth : point.estimates[run.run_context.steering];
}

/// Its name is in the plural.
Figure figure_of(const Plot& plot, const std::vector<ComparedRun>& runs) {
  Chart chart = of_time(plot.title, plot.y_label);
  for (std::size_t i = 0; i < runs.size(); ++i)
    chart.series.push_back(over_time(runs[i].run, line_of(runs[i], i), plot.value));
  return {std::string(plot.name) + "s", svg(chart), plot.caption};
}

}  // namespace

std::vector<Figure> figures_of(const RecordedRun& run) {
  const course::Course* course = run.run_context.course.get();
  std::vector<Figure> figures = {path_figure(run), yaw_figure(run), error_figure(run),
                                 uncertainty_figure(run)};
  if (course != nullptr) figures.push_back(figure_of(tracking(), run));
  figures.push_back(slip_figure(run));
  if (in_real_time(run)) figures.push_back(figure_of(jitter(), run));
  if (course != nullptr && !course->terrain.flat()) figures.push_back(climb_figure(run));
  return figures;
}

std::vector<Figure> figures_of(const std::vector<ComparedRun>& runs) {
  const auto any = [&](const auto& has) {
    return std::ranges::any_of(runs, [&](const ComparedRun& one) { return has(one.run); });
  };
  Chart paths = map("Paths");
  if (!runs.empty() && runs[0].run.run_context.course != nullptr)
    paths.series.push_back(planned(*runs[0].run.run_context.course));
  for (std::size_t i = 0; i < runs.size(); ++i)
    paths.series.push_back(map_of(
        runs[i].run, line_of(runs[i], i),
        [&](const TrajectoryPoint& p) -> const Pose& { return shown_pose(runs[i].run, p); }));
  std::vector<Figure> figures = {
      {"paths", svg(paths),
       "The truth where it is known, else the steering pose. The path is that of the first run."},
      figure_of({"yaw", "Yaw", "yaw [deg]", "Yaw, of the same poses.",
                 [](auto& run, auto& p, auto&) { return shown_pose(run, p).yaw_rad * kDegPerRad; }},
                runs)};
  const struct {
    const char *name, *title, *caption;
    PoseSource source;
  } errors[] = {{"model-error", "Model: distance from the truth",
                 "The model, only of runs whose truth is known.", PoseSource::kModel},
                {"odometry-error", "Odometry: distance from the truth",
                 "Odometry, of the same runs.", PoseSource::kOdometry},
                {"fused-error", "Fused pose: distance from the truth",
                 "The fused pose, of those of the runs that had a camera.", PoseSource::kFused}};
  for (const auto& one : errors) {
    if (!any([&](const RecordedRun& run) { return run.result.has_estimate(one.source); })) continue;
    const Value error = [source = one.source](auto& run, auto& p, auto&) {
      return run.has_truth && run.result.has_estimate(source)
                 ? distance_cm(p.estimates[source], p.truth)
                 : std::nan("");
    };
    figures.push_back(figure_of({one.name, one.title, "distance [cm]", one.caption, error}, runs));
  }
  figures.push_back(figure_of(tracking(), runs));
  if (any(in_real_time)) figures.push_back(figure_of(jitter(), runs));
  return figures;
}

void thin_for_figures(RecordedRun& run) {
  const std::size_t every = run.moments.size() / kMaxPointsOfRun + 1;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < run.moments.size(); i += every) {
    run.result.points[kept] = run.result.points[i];
    run.moments[kept++] = run.moments[i];
  }
  run.result.points.resize(kept);
  run.moments.resize(kept);
  run.result.points.shrink_to_fit();
  run.moments.shrink_to_fit();
}

}  // namespace tp100::report
