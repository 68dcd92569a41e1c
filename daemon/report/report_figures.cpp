#include "report/report_figures.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/arithmetic.h"
#include "course/path.h"
#include "report/chart.h"
#include "report/metrics.h"

namespace tp100::report {
namespace {

constexpr std::size_t kMaxPointsOfRun = 2000;

using Value = std::function<double(const TrajectoryPoint&, const RunMoment&)>;

ChartSeries empty_series(const std::string& name, const char* colour, bool dashed = false) {
  return {.name = name, .colour = colour, .points = {}, .dashed = dashed};
}

/// `value` over time.
ChartSeries over_time(const RecordedRun& run, ChartSeries series, const Value& value) {
  for (std::size_t i = 0; i < run.moments.size(); ++i)
    series.points.emplace_back(run.result.points[i].t_s,
                               value(run.result.points[i], run.moments[i]));
  return series;
}

ChartSeries map_of(const RecordedRun& run, ChartSeries series,
                   const std::function<const Pose&(const TrajectoryPoint&)>& pose) {
  for (const TrajectoryPoint& point : run.result.points)
    series.points.emplace_back(pose(point).x_m, pose(point).y_m);
  return series;
}

/// Below the estimates, which it would hide or be hidden by.
ChartSeries truth_series() {
  ChartSeries series = empty_series("truth", kTruthColour);
  series.broad = true;
  return series;
}

ChartSeries planned(const course::Course& course) {
  ChartSeries series = empty_series("path", kPathColour, true);
  series.points = path_line(course);
  return series;
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

ChartSeries series_of(PoseSource source) {
  return empty_series(std::string(to_string(source)), colour_of(source));
}

Figure path_figure(const RecordedRun& run) {
  Chart chart{.title = "Path", .x_label = "x [m]", .y_label = "y [m]", .equal_scale = true};
  if (run.run_context.course != nullptr) chart.series.push_back(planned(*run.run_context.course));
  if (run.has_truth)
    chart.series.push_back(map_of(run, truth_series(),
                                  [](const TrajectoryPoint& p) -> const Pose& { return p.truth; }));
  for (const PoseSource source : estimates_of(run))
    chart.series.push_back(
        map_of(run, series_of(source),
               [&](const TrajectoryPoint& p) -> const Pose& { return p.estimates[source]; }));
  return {
      "path", svg(chart),
      "Where the robot was: the truth, if known, is the broad band, estimates are lines on it."};
}

Figure yaw_figure(const RecordedRun& run) {
  Chart chart{.title = "Yaw", .x_label = "time [s]", .y_label = "yaw [deg]"};
  if (run.has_truth)
    chart.series.push_back(over_time(
        run, truth_series(),
        [](const TrajectoryPoint& p, const RunMoment&) { return p.truth.yaw_rad * kDegPerRad; }));
  for (const PoseSource source : estimates_of(run))
    chart.series.push_back(
        over_time(run, series_of(source), [&](const TrajectoryPoint& p, const RunMoment&) {
          return p.estimates[source].yaw_rad * kDegPerRad;
        }));
  return {"yaw", svg(chart), "Yaw, counted on beyond a full turn."};
}

/// How far each estimate is from the truth; without one, from odometry.
std::vector<ChartSeries> error_series(const RecordedRun& run) {
  std::vector<ChartSeries> series;
  for (const PoseSource source : estimates_of(run)) {
    if (!run.has_truth && source == PoseSource::kOdometry) continue;
    series.push_back(
        over_time(run, series_of(source), [&](const TrajectoryPoint& p, const RunMoment&) {
          return distance_cm(p.estimates[source],
                             run.has_truth ? p.truth : p.estimates[PoseSource::kOdometry]);
        }));
  }
  return series;
}

Figure error_figure(const RecordedRun& run) {
  const Chart chart{.title = run.has_truth ? "Distance from the truth" : "Distance from odometry",
                    .x_label = "time [s]",
                    .y_label = "distance [cm]",
                    .series = error_series(run)};
  return {
      "error", svg(chart),
      run.has_truth
          ? "How far each estimate was from the truth, from start to end, disturbances included."
          : "The truth is not known: how far the estimates were from each other, which is no "
            "error."};
}

Figure uncertainty_figure(const RecordedRun& run) {
  Chart chart{.title = "Uncertainty", .x_label = "time [s]", .y_label = "distance [cm]"};
  if (run.has_truth) chart.series = error_series(run);
  for (const PoseSource source : estimates_of(run))
    chart.series.push_back(over_time(
        run, empty_series(std::string(to_string(source)) + ", 2 sd", colour_of(source), true),
        [&](const TrajectoryPoint& p, const RunMoment&) {
          return 2.0 * kCmPerM * magnitude(p.sd[source].x_m, p.sd[source].y_m);
        }));
  return {
      "uncertainty", svg(chart),
      std::string("Dashed: two standard deviations of each position, by its own covariance.") +
          (run.has_truth ? " Lines: its distance from the truth, as in the figure before." : "")};
}

Figure tracking_figure(const RecordedRun& run) {
  Chart chart{.title = "Cross-track, as the controller saw it",
              .x_label = "time [s]",
              .y_label = "left of the path [cm]"};
  chart.series.push_back(over_time(
      run, empty_series("", kValueColour),
      [](const TrajectoryPoint&, const RunMoment& m) { return m.cross_track_m * kCmPerM; }));
  return {"tracking", svg(chart), "The steering pose against the path."};
}

Figure slip_figure(const RecordedRun& run) {
  Chart chart{.title = "Slip in use", .x_label = "time [s]", .y_label = "slip ratio"};
  chart.series.push_back(
      over_time(run, empty_series("left", kLeftColour),
                [](const TrajectoryPoint&, const RunMoment& m) { return m.slip_left; }));
  chart.series.push_back(
      over_time(run, empty_series("right", kRightColour),
                [](const TrajectoryPoint&, const RunMoment& m) { return m.slip_right; }));
  return {"slip", svg(chart), "Slip ratios that the model used."};
}

Figure jitter_figure(const RecordedRun& run) {
  Chart chart{.title = "Jitter", .x_label = "time [s]", .y_label = "|step - period| [us]"};
  chart.series.push_back(
      over_time(run, empty_series("", kValueColour),
                [](const TrajectoryPoint&, const RunMoment& m) { return m.jitter_us; }));
  return {"jitter", svg(chart), "Time between two steps against the loop's period."};
}

Figure climb_figure(const RecordedRun& run) {
  Chart chart{.title = "Climb angle", .x_label = "time [s]", .y_label = "nose up [deg]"};
  if (run.has_truth)
    chart.series.push_back(
        over_time(run, truth_series(), [](const TrajectoryPoint& p, const RunMoment&) {
          return -p.truth.pitch_rad * kDegPerRad;
        }));
  chart.series.push_back(over_time(run, empty_series("robot in the course's world", kValueColour),
                                   [](const TrajectoryPoint&, const RunMoment& m) {
                                     return -m.steering_world.pitch_rad * kDegPerRad;
                                   }));
  return {"climb", svg(chart),
          "Where obstacles are virtual, the truth lies on the flat floor below them."};
}

/// A colour for each of several runs; dashed where colours repeat.
ChartSeries series_of(const ComparedRun& run, std::size_t i) {
  return empty_series(run.name, colour_of_run(i), i >= kRunColours);
}

const Pose& shown_pose(const RecordedRun& run, const TrajectoryPoint& point) {
  return run.has_truth ? point.truth : point.estimates[run.run_context.steering];
}

Figure compared(const std::vector<ComparedRun>& runs, Figure figure, Chart chart,
                const std::function<double(const RecordedRun&, const TrajectoryPoint&,
                                           const RunMoment&)>& value) {
  for (std::size_t i = 0; i < runs.size(); ++i)
    chart.series.push_back(over_time(
        runs[i].run, series_of(runs[i], i),
        [&](const TrajectoryPoint& p, const RunMoment& m) { return value(runs[i].run, p, m); }));
  figure.svg = svg(chart);
  return figure;
}

}  // namespace

std::vector<std::pair<double, double>> path_line(const course::Course& course) {
  constexpr int kParts = 600;
  const course::Path path(course);
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i <= kParts; ++i) {
    const course::PathPoint at = path.at(path.length_m() * i / kParts);
    points.emplace_back(at.x_m, at.y_m);
  }
  return points;
}

std::vector<Figure> figures_of(const RecordedRun& run) {
  std::vector<Figure> figures = {path_figure(run),        yaw_figure(run),      error_figure(run),
                                 uncertainty_figure(run), tracking_figure(run), slip_figure(run),
                                 jitter_figure(run)};
  std::erase_if(figures, [&](const Figure& figure) {
    return (figure.name == "tracking" && run.run_context.course == nullptr) ||
           (figure.name == "jitter" && !in_real_time(run));
  });
  if (run.run_context.course != nullptr && !run.run_context.course->terrain.flat())
    figures.push_back(climb_figure(run));
  return figures;
}

std::vector<Figure> figures_of(const std::vector<ComparedRun>& runs) {
  std::vector<Figure> figures;
  Chart map{.title = "Paths", .x_label = "x [m]", .y_label = "y [m]", .equal_scale = true};
  if (!runs.empty() && runs[0].run.run_context.course != nullptr)
    map.series.push_back(planned(*runs[0].run.run_context.course));
  for (std::size_t i = 0; i < runs.size(); ++i)
    map.series.push_back(map_of(
        runs[i].run, series_of(runs[i], i),
        [&](const TrajectoryPoint& p) -> const Pose& { return shown_pose(runs[i].run, p); }));
  figures.push_back({"paths", svg(map),
                     "The truth where it is known, else the steering pose. The path is that of "
                     "the first run."});
  figures.push_back(
      compared(runs, {"yaws", {}, "Yaw, of the same poses."},
               {.title = "Yaw", .x_label = "time [s]", .y_label = "yaw [deg]"},
               [](const RecordedRun& run, const TrajectoryPoint& p, const RunMoment&) {
                 return shown_pose(run, p).yaw_rad * kDegPerRad;
               }));
  const struct {
    const char *name, *title, *caption;
    PoseSource source;
  } errors[] = {{"model-errors", "Model: distance from the truth",
                 "The model, only of runs whose truth is known.", PoseSource::kModel},
                {"odometry-errors", "Odometry: distance from the truth",
                 "Odometry, of the same runs.", PoseSource::kOdometry},
                {"fused-errors", "Fused pose: distance from the truth",
                 "The fused pose, of those of the runs that had a camera.", PoseSource::kFused}};
  const auto shown = [&](PoseSource source) {
    return std::ranges::any_of(
        runs, [&](const ComparedRun& one) { return one.run.result.has_estimate(source); });
  };
  for (const auto& one : errors) {
    if (!shown(one.source)) continue;
    figures.push_back(
        compared(runs, {one.name, {}, one.caption},
                 {.title = one.title, .x_label = "time [s]", .y_label = "distance [cm]"},
                 [&](const RecordedRun& run, const TrajectoryPoint& p, const RunMoment&) {
                   return run.has_truth && run.result.has_estimate(one.source)
                              ? distance_cm(p.estimates[one.source], p.truth)
                              : std::nan("");
                 }));
  }
  figures.push_back(compared(runs, {"trackings", {}, "The steering pose against the path."},
                             {.title = "Cross-track, as the controller saw it",
                              .x_label = "time [s]",
                              .y_label = "left of the path [cm]"},
                             [](const RecordedRun&, const TrajectoryPoint&, const RunMoment& m) {
                               return m.cross_track_m * kCmPerM;
                             }));
  if (std::ranges::any_of(runs, [](const ComparedRun& one) { return in_real_time(one.run); }))
    figures.push_back(
        compared(runs, {"jitters", {}, "Time between two steps against the loop's period."},
                 {.title = "Jitter", .x_label = "time [s]", .y_label = "|step - period| [us]"},
                 [](const RecordedRun&, const TrajectoryPoint&, const RunMoment& m) {
                   return m.jitter_us;
                 }));
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
