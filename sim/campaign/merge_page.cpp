#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "report/chart.h"
#include "report/html_page.h"
#include "sim/campaign/merge.h"

namespace tp100::sim {
namespace {

using report::Rows;

// A page of more is none that anybody reads; merged.json has all.
constexpr std::size_t kListed = 500;

constexpr const char* kColour = "#1f5fbf";
// The figures shown first; the rest is in merged.json and runs.csv.
constexpr std::array<const char*, 8> kMain = {"model.max_position_error_m",
                                              "odometry.max_position_error_m",
                                              "fused.max_position_error_m",
                                              "tracking.max_cross_track_m",
                                              "tracking.max_yaw_error_rad",
                                              "tracking.recovery_s",
                                              "duration_s",
                                              "link.lost"};

std::string number(double value) {
  if (!std::isfinite(value)) return "never";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

std::string with_interval(double value, const Interval& interval) {
  if (!interval) return number(value);
  return number(value) + " (" + number(interval->first) + " to " + number(interval->second) + ")";
}

std::vector<const MergedFigure*> main_figures(const Merged& merged) {
  std::vector<const MergedFigure*> found;
  for (const char* name : kMain)
    for (const MergedFigure& figure : merged.figures)
      if (figure.name == name) found.push_back(&figure);
  return found;
}

std::string completion(const Merged& merged) {
  std::string text = std::to_string(merged.asked) + " runs asked for, " +
                     std::to_string(merged.missing.size()) + " missing, " +
                     std::to_string(merged.runs.size() - merged.driven) + " refused; " +
                     std::to_string(merged.completed) + " of " + std::to_string(merged.driven) +
                     " driven runs completed their course";
  if (merged.driven == 0) return text + ".";
  const auto [low, high] = share_interval(merged.completed, merged.driven);
  return text + ": 95 % interval of the share " + number(100.0 * low) + " to " +
         number(100.0 * high) + " %.";
}

Rows figure_rows(const std::vector<const MergedFigure*>& figures) {
  Rows rows = {{"figure", "runs", "mean", "5 %", "median", "95 %", "99 %", "largest"}};
  for (const MergedFigure* figure : figures) {
    const Summary& of = figure->summary;
    rows.push_back(
        {figure->name, std::to_string(of.count), with_interval(of.mean, of.mean_interval)});
    for (const Percentile& percentile : of.percentiles)
      rows.back().push_back(with_interval(percentile.value, percentile.interval));
    rows.back().push_back(number(of.most));
  }
  return rows;
}

std::string sampled_text(const MergedRun& run) {
  std::string sampled;
  for (const auto& [name, text] : run.sampled)
    sampled += (sampled.empty() ? "" : ", ") + name + " " + text;
  return sampled;
}

Rows cause_rows(const Merged& merged) {
  Rows rows = {{"cause", "runs"}};
  for (const auto& [cause, count] : merged.causes()) rows.push_back({cause, std::to_string(count)});
  return rows;
}

Rows failed_rows(const std::vector<const MergedRun*>& failed) {
  Rows rows = {{"run", "seed", "cause", "sampled"}};
  for (std::size_t i = 0; i < std::min(failed.size(), kListed); ++i)
    rows.push_back({std::to_string(failed[i]->index),
                    std::to_string(failed[i]->seed),
                    {failed[i]->cause, true},
                    sampled_text(*failed[i])});
  return rows;
}

void add_failed(report::HtmlPage& page, const Merged& merged) {
  const std::vector<const MergedRun*> failed = merged.failed();
  if (failed.empty()) return;
  page.heading("Failed runs");
  page.table(cause_rows(merged), "Why driven runs did not complete their course");
  page.table(failed_rows(failed), failed.size() > kListed
                                      ? "The first " + std::to_string(kListed) + " of " +
                                            std::to_string(failed.size()) +
                                            " failed runs; merged.json lists all"
                                      : "Every failed run; no figure below counts them");
}

Rows worst_rows(const std::vector<const MergedFigure*>& figures, const Merged& merged) {
  Rows rows = {{"figure", "value", "run", "seed", "sampled"}};
  for (const MergedFigure* figure : figures)
    for (const auto& [index, value] : figure->worst) {
      const MergedRun& run = merged.run(index);
      rows.push_back({figure->name, number(value), std::to_string(index), std::to_string(run.seed),
                      sampled_text(run)});
    }
  return rows;
}

Rows group_rows(const Merged& merged, const std::vector<const MergedFigure*>& figures) {
  Rows rows = {{"variable", "value", "completed", "figure", "median", "95 %"}};
  for (const MergedGroup& group : merged.groups) {
    const std::string completed =
        std::to_string(group.completed) + " of " + std::to_string(group.driven);
    for (const MergedFigure* figure : figures) {
      const auto of = group.figures.find(figure->name);
      if (of == group.figures.end()) continue;
      const std::vector<Percentile>& percentiles = of->second.percentiles;
      rows.push_back({group.variable, group.value.empty() ? "(none)" : group.value, completed,
                      figure->name, with_interval(percentiles[1].value, percentiles[1].interval),
                      with_interval(percentiles[2].value, percentiles[2].interval)});
    }
    if (group.completed == 0)
      rows.push_back({group.variable, group.value, completed, "-", "-", "-"});
  }
  return rows;
}

Rows correlation_rows(const std::vector<const MergedFigure*>& figures) {
  Rows rows = {{"sampled", "figure", "rank correlation"}};
  for (const MergedFigure* figure : figures)
    for (const auto& [name, value] : figure->correlations)
      rows.push_back({name, figure->name, number(value)});
  return rows;
}

Rows refused_rows(const Merged& merged) {
  Rows rows = {{"run", "seed", "why", "sampled"}};
  for (const MergedRun& run : merged.runs)
    if (!run.refused.empty() && rows.size() <= kListed)
      rows.push_back({std::to_string(run.index),
                      std::to_string(run.seed),
                      {run.refused, true},
                      sampled_text(run)});
  return rows;
}

/// Share of the runs that stay below a value.
std::string distribution(const MergedFigure& figure, const Merged& merged) {
  std::vector<double> values;
  for (const MergedRun& run : merged.runs)
    if (const auto found = run.figures.find(figure.name);
        run.completed && found != run.figures.end() && std::isfinite(found->second))
      values.push_back(found->second);
  std::sort(values.begin(), values.end());
  report::ChartSeries series{.colour = kColour};
  for (std::size_t i = 0; i < values.size(); ++i)
    series.points.emplace_back(
        values[i], 100.0 * static_cast<double>(i + 1) / static_cast<double>(figure.summary.count));
  return report::svg({.title = figure.name,
                      .x_label = figure.name,
                      .y_label = "runs that stay below [%]",
                      .series = {series}});
}

}  // namespace

std::string merge_page(const Merged& merged, const std::string& spec_text) {
  report::HtmlPage page("Campaign");
  page.paragraph(completion(merged));
  page.paragraph(
      "Figures are those of completed runs, against the emulated body's exact pose; in brackets 95 "
      "% intervals. Every figure is in merged.json, every run in runs.csv. A single run is driven "
      "again, recorded, by tp100-sim campaign spec.toml --out OTHER --index RUN --record FOLDER.");
  add_failed(page, merged);
  const std::vector<const MergedFigure*> figures = main_figures(merged);
  page.heading("Figures");
  page.table(figure_rows(figures), "Over all completed runs");
  std::vector<std::string> charts;
  charts.reserve(figures.size());
  for (const MergedFigure* figure : figures) charts.push_back(distribution(*figure, merged));
  page.figures(charts, "Distributions");
  if (!merged.groups.empty()) {
    page.heading("By listed value");
    page.table(group_rows(merged, figures), "Each value of each list, over all others");
  }
  if (const Rows rows = correlation_rows(figures); rows.size() > 1) {
    page.heading("Correlations");
    page.table(rows, "Spearman's rank correlation of sampled numbers and figures");
  }
  page.heading("Worst completed runs");
  page.table(
      worst_rows(figures, merged),
      merged.failed().empty()
          ? "The largest values of each figure"
          : "The largest values of each figure; worse than these are the failed runs, above");
  if (const Rows rows = refused_rows(merged); rows.size() > 1) {
    page.heading("Refused");
    page.table(rows, "Runs whose sampled values no robot or configuration can have");
  }
  page.folded("spec.toml", spec_text);
  return page.text();
}

}  // namespace tp100::sim
