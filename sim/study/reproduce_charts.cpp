#include "sim/study/reproduce_charts.h"

#include <cmath>
#include <functional>

#include "core/arithmetic.h"
#include "report/chart.h"
#include "report/metrics.h"

namespace tp100::sim {
namespace {

using report::ChartSeries;
using report::TrajectoryPoint;

using Values = std::function<std::pair<double, double>(const TrajectoryPoint&)>;

ChartSeries over(const report::RunResult& run, ChartSeries series, const Values& values) {
  series.points.reserve(run.points.size());
  for (const TrajectoryPoint& point : run.points) series.points.push_back(values(point));
  return series;
}

/// A band below the estimates, which lie on it for most of a run.
ChartSeries truth_series() {
  return {.name = "truth", .colour = report::kTruthColour, .broad = true};
}

ChartSeries series_of(PoseSource source) {
  return {.name = std::string(to_string(source)), .colour = report::colour_of(source)};
}

std::vector<PoseSource> estimates_of(const report::RunResult& run) {
  std::vector<PoseSource> estimates;
  for (const PoseSource source : kPoseSources)
    if (run.has_estimate(source)) estimates.push_back(source);
  return estimates;
}

/// The truth, and each estimate on it.
std::vector<ChartSeries> poses(const report::RunResult& run,
                               std::pair<double, double> (*values)(const TrajectoryPoint&,
                                                                   const Pose&)) {
  std::vector<ChartSeries> series = {over(run, truth_series(), [&](const TrajectoryPoint& point) {
    return values(point, point.truth);
  })};
  for (const PoseSource source : estimates_of(run)) {
    series.push_back(over(run, series_of(source), [&](const TrajectoryPoint& point) {
      return values(point, point.estimates[source]);
    }));
    // Last drawn, it would hide the others.
    series.back().dashed = source == PoseSource::kFused;
  }
  return series;
}

/// What each estimate is off by.
std::vector<ChartSeries> errors(const report::RunResult& run,
                                double (*error)(const Pose& truth, const Pose& estimate)) {
  std::vector<ChartSeries> series;
  for (const PoseSource source : estimates_of(run))
    series.push_back(over(run, series_of(source), [&](const TrajectoryPoint& point) {
      return std::pair(point.t_s, error(point.truth, point.estimates[source]));
    }));
  return series;
}

std::string over_time(const char* title, const char* y_label, std::vector<ChartSeries> series) {
  return report::svg(
      {.title = title, .x_label = "time [s]", .y_label = y_label, .series = std::move(series)});
}

std::string climb_chart(const report::RunResult& run) {
  ChartSeries model = series_of(PoseSource::kModel);
  model.name = "model's slope";
  return over_time("Climb angle", "nose up [deg]",
                   {over(run, truth_series(),
                         [](const TrajectoryPoint& point) {
                           return std::pair(point.t_s, -point.truth.pitch_rad * kDegPerRad);
                         }),
                    over(run, model, [](const TrajectoryPoint& point) {
                      return std::pair(point.t_s,
                                       -point.estimates[PoseSource::kModel].pitch_rad * kDegPerRad);
                    })});
}

}  // namespace

std::vector<std::string> run_charts(const CourseStudy& study) {
  const report::RunResult& run = study.shown.result;
  std::vector<std::string> charts = {
      report::svg(
          {.title = "Path",
           .x_label = "x [m]",
           .y_label = "y [m]",
           .series = poses(run, [](const TrajectoryPoint&,
                                   const Pose& pose) { return std::pair(pose.x_m, pose.y_m); }),
           .equal_scale = true}),
      over_time("Yaw", "yaw [deg]", poses(run, [](const TrajectoryPoint& point, const Pose& pose) {
                  return std::pair(point.t_s, pose.yaw_rad * kDegPerRad);
                }))};
  if (study.setup == "stand") return charts;
  charts.push_back(over_time("Position error", "distance from the truth [cm]",
                             errors(run, [](const Pose& truth, const Pose& estimate) {
                               return report::kCmPerM *
                                      magnitude(estimate.x_m - truth.x_m, estimate.y_m - truth.y_m);
                             })));
  charts.push_back(over_time("Yaw error", "estimate minus truth [deg]",
                             errors(run, [](const Pose& truth, const Pose& estimate) {
                               return kDegPerRad * wrap_angle(estimate.yaw_rad - truth.yaw_rad);
                             })));
  if (study.setup == "terrain" && study.course == "3") charts.push_back(climb_chart(run));
  return charts;
}

std::vector<std::string> slope_charts(const Reproduction& what) {
  std::vector<std::string> charts;
  for (const bool left : {true, false}) {
    ChartSeries ours{.name = "ours, measured",
                     .colour = left ? report::kLeftColour : report::kRightColour};
    ChartSeries paper{.name = "paper", .colour = report::kPathColour, .marks = true};
    for (std::size_t i = 0; i < what.slopes.size(); ++i) {
      const SlopeRow& row = slope_rows()[i];
      ours.points.emplace_back(row.slope_deg, left ? what.slopes[i].left : what.slopes[i].right);
      if (const auto printed = left ? row.paper_left : row.paper_right)
        paper.points.emplace_back(row.slope_deg, *printed);
    }
    charts.push_back(report::svg({.title = left ? "Left track" : "Right track",
                                  .x_label = "slope [deg]",
                                  .y_label = "slip ratio",
                                  .series = {ours, paper}}));
  }
  return charts;
}

}  // namespace tp100::sim
