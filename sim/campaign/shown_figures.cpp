#include "sim/campaign/shown_figures.h"

#include <cmath>

#include "core/arithmetic.h"
#include "report/chart.h"
#include "report/metrics.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

using report::colour_of;
using report::kCmPerM;

constexpr double kStrong = 0.6;

const ShownFigure kShown[] = {
    {"model.max_position_error_m", "Model: largest position error", "cm", kCmPerM, 2,
     colour_of(PoseSource::kModel)},
    {"odometry.max_position_error_m", "Odometry: largest position error", "cm", kCmPerM, 2,
     colour_of(PoseSource::kOdometry)},
    {"fused.max_position_error_m", "Fused pose: largest position error", "cm", kCmPerM, 2,
     colour_of(PoseSource::kFused)},
    {"tracking.max_cross_track_m", "Tracking: truth farthest from the path", "cm", kCmPerM, 2,
     report::kTruthColour},
    {"tracking.max_yaw_error_rad", "Tracking: largest yaw error of the truth", "deg", kDegPerRad, 2,
     report::kTruthColour},
    {"tracking.recovery_s", "Slowest recovery from a disturbance", "s", 1.0, 2,
     report::kValueColour},
    {"duration_s", "Duration of the run", "s", 1.0, 2, report::kValueColour},
    {"link.lost", "Frames lost on the link", "frames", 1.0, 0, report::kValueColour}};

/// The values in the shown unit, of the completed runs with this value of `variable` (empty: all).
std::vector<double> values_of(const ShownFigure& figure, const Merged& merged,
                              const std::string& variable = {}, const std::string& value = {}) {
  std::vector<double> values;
  for (const MergedRun& run : merged.runs) {
    const auto found = run.figures.find(figure.name);
    if (!run.completed || found == run.figures.end()) continue;
    const auto sampled = run.sampled.find(variable);
    if (variable.empty() || (sampled != run.sampled.end() && sampled->second == value))
      values.push_back(found->second * figure.scale);
  }
  return values;
}

}  // namespace

const char* const kStrongRule =
    "Strong: the absolute value is above 0.6, and above 2 / sqrt(runs - 1), which chance exceeds "
    "in about one of 20 cases.";

std::string ShownFigure::with_unit() const { return std::string(title) + " [" + unit + "]"; }

std::string ShownFigure::text(double value) const {
  return std::isfinite(value) ? text::format("%.*f", places, value * scale) : "never";
}

std::string ShownFigure::text(double value, const Interval& interval) const {
  if (!interval) return text(value);
  return text(value) + " (" + text(interval->first) + " to " + text(interval->second) + ")";
}

std::vector<ShownFigure> shown_figures(const Merged& merged) {
  std::vector<ShownFigure> figures;
  for (ShownFigure shown : kShown)
    for (const MergedFigure& figure : merged.figures)
      if (figure.name == shown.name) {
        shown.merged = &figure;
        figures.push_back(shown);
      }
  return figures;
}

bool is_strong(double rank_correlation, std::size_t runs) {
  const double strength = std::abs(rank_correlation);
  return runs > 1 && strength > kStrong &&
         strength > 2.0 / std::sqrt(static_cast<double>(runs - 1));
}

std::string spread_chart(const ShownFigure& figure, const Merged& merged) {
  report::BoxChart chart{.title = figure.title,
                         .x_label = figure.with_unit(),
                         .boxes = {{"all", values_of(figure, merged)}}};
  for (const MergedGroup& group : merged.groups)
    chart.boxes.push_back({group.value.empty() ? "(no " + group.variable + ")" : group.value,
                           values_of(figure, merged, group.variable, group.value)});
  return report::box_plot(chart);
}

std::string correlation_chart(const ShownFigure& figure, const std::string& sampled,
                              double rank_correlation, const Merged& merged) {
  report::ChartSeries series{.colour = figure.colour, .marks = true};
  for (const MergedRun& run : merged.runs) {
    const auto x = run.sampled_numbers.find(sampled);
    const auto y = run.figures.find(figure.name);
    if (run.completed && x != run.sampled_numbers.end() && y != run.figures.end())
      series.points.emplace_back(x->second, y->second * figure.scale);
  }
  return report::svg({.title = text::format("Rank correlation %+.2f", rank_correlation),
                      .x_label = sampled,
                      .y_label = figure.with_unit(),
                      .series = {series}});
}

}  // namespace tp100::sim
