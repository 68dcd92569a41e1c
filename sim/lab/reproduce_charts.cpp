#include "sim/lab/reproduce_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/arithmetic.h"
#include "report/chart.h"
#include "report/metrics.h"

namespace tp100::sim {
namespace {

using report::ChartSeries;
using report::TrajectoryPoint;

/// Drawn as a wide band below the estimates, which coincide with it for most of a run.
ChartSeries truth_series() {
  return {.name = "truth", .colour = report::kTruthColour, .broad = true};
}

/// An estimate as it is judged: a pose for each point of the run, not finite where there is none.
struct Shown {
  ChartSeries style{};
  std::vector<Pose> poses;
  std::vector<std::size_t> restarts;  ///< points at which it was set to the truth
};

Pose no_pose() {
  Pose pose;
  pose.x_m = pose.y_m = pose.yaw_rad = std::numeric_limits<double>::quiet_NaN();
  return pose;
}

std::vector<Shown> estimates_of(const report::RunResult& run) {
  std::vector<Shown> estimates;
  for (const PoseSource source : kPoseSources) {
    if (!run.has_estimate(source)) continue;
    Shown& shown = estimates.emplace_back();
    shown.style = {.name = std::string(to_string(source)), .colour = report::colour_of(source)};
    // Dashed, because it is drawn last and would hide the others.
    shown.style.dashed = source == PoseSource::kFused;
    const bool restarted = source == PoseSource::kModel && !run.disturbances.empty();
    if (restarted) shown.style.name = "model, restarted";
    const report::RestartedPoses judged = report::restarted_poses(
        run.points, restarted ? run.disturbances : std::vector<report::DisturbanceWindow>{},
        [source](const TrajectoryPoint& point) -> const Pose& { return point.estimates[source]; });
    for (const std::optional<Pose>& pose : judged.poses)
      shown.poses.push_back(pose.value_or(no_pose()));
    shown.restarts = judged.restarts;
  }
  return estimates;
}

using Value = std::pair<double, double> (*)(const TrajectoryPoint& point, const Pose& pose);

/// Adds the line of an estimate, and a dot where it was restarted.
void add(std::vector<ChartSeries>& series, const report::RunResult& run, const Shown& shown,
         Value value) {
  ChartSeries line = shown.style;
  for (std::size_t i = 0; i < run.points.size(); ++i)
    line.points.push_back(value(run.points[i], shown.poses[i]));
  series.push_back(line);
  if (shown.restarts.empty()) return;
  ChartSeries restarts{.name = "its restart", .colour = shown.style.colour, .marks = true};
  for (const std::size_t i : shown.restarts)
    restarts.points.push_back(value(run.points[i], shown.poses[i]));
  series.push_back(restarts);
}

/// The truth, and each estimate above it.
std::vector<ChartSeries> poses(const report::RunResult& run, Value value) {
  std::vector<ChartSeries> series = {truth_series()};
  for (const TrajectoryPoint& point : run.points)
    series.front().points.push_back(value(point, point.truth));
  for (const Shown& shown : estimates_of(run)) add(series, run, shown, value);
  return series;
}

/// The error of each estimate.
std::vector<ChartSeries> errors(const report::RunResult& run, Value error) {
  std::vector<ChartSeries> series;
  for (const Shown& shown : estimates_of(run)) add(series, run, shown, error);
  return series;
}

std::string over_time(const char* title, const char* y_label, std::vector<ChartSeries> series) {
  return report::svg(
      {.title = title, .x_label = "time [s]", .y_label = y_label, .series = std::move(series)});
}

ChartSeries over_travel(ChartSeries series, const ClimbCheck& climb,
                        double ClimbSample::*pitch_rad) {
  for (const ClimbSample& sample : climb.samples)
    series.points.emplace_back(sample.travel_m * report::kCmPerM,
                               -(sample.*pitch_rad) * kDegPerRad);
  return series;
}

std::string slope_over_time(const report::RunResult& run) {
  ChartSeries truth = truth_series();
  ChartSeries model = {.name = "model's slope", .colour = report::colour_of(PoseSource::kModel)};
  for (const TrajectoryPoint& point : run.points) {
    truth.points.emplace_back(point.t_s, -point.truth.pitch_rad * kDegPerRad);
    model.points.emplace_back(point.t_s,
                              -point.estimates[PoseSource::kModel].pitch_rad * kDegPerRad);
  }
  return over_time("Climb angle", "nose up [deg]", {truth, model});
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
  charts.push_back(over_time(
      "Position error", "distance from the truth [cm]",
      errors(run, [](const TrajectoryPoint& point, const Pose& pose) {
        return std::pair(point.t_s, report::kCmPerM * magnitude(pose.x_m - point.truth.x_m,
                                                                pose.y_m - point.truth.y_m));
      })));
  charts.push_back(over_time(
      "Yaw error", "estimate minus truth [deg]",
      errors(run, [](const TrajectoryPoint& point, const Pose& pose) {
        return std::pair(point.t_s, kDegPerRad * wrap_angle(pose.yaw_rad - point.truth.yaw_rad));
      })));
  if (study.setup == "terrain" && study.course == "3") charts.push_back(slope_over_time(run));
  return charts;
}

std::string climb_chart(const ClimbCheck& climb) {
  ChartSeries phases = {.name = "a phase begins", .colour = report::kPathColour, .dashed = true};
  double highest_deg = 0.0;
  for (const ClimbSample& sample : climb.samples)
    highest_deg = std::max(highest_deg, -sample.body_rad * kDegPerRad);
  for (const ClimbPhaseCheck& phase : climb.phases) {
    const double at_cm = phase.from_m * report::kCmPerM;
    phases.points.insert(phases.points.end(),
                         {{at_cm, 0.0}, {at_cm, highest_deg}, {at_cm, std::nan("")}});
  }
  return report::svg(
      {.title = "Climb angle over a block",
       .x_label = "travel of the tracks since first touch [cm]",
       .y_label = "nose up [deg]",
       .series = {phases, over_travel(truth_series(), climb, &ClimbSample::body_rad),
                  over_travel({.name = "the paper's eq 6", .colour = report::kValueColour}, climb,
                              &ClimbSample::paper_rad),
                  over_travel({.name = "model", .colour = report::colour_of(PoseSource::kModel)},
                              climb, &ClimbSample::model_rad)}});
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
