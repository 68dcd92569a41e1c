#include <algorithm>
#include <cmath>

#include "report/html_page.h"
#include "sim/campaign/merge.h"
#include "sim/campaign/shown_figures.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

using report::Rows;
using text::format;

// Longer lists would not be read; merged.json has all.
constexpr std::size_t kListed = 500;
constexpr std::size_t kMaxScatters = 24;

std::string percent(double share) { return format("%.3g", 100.0 * share); }

std::string completion(const Merged& merged) {
  std::string text = std::to_string(merged.completed) + " of " + std::to_string(merged.driven) +
                     " driven runs completed their course";
  if (merged.driven > 0) {
    const auto [low, high] = share_interval(merged.completed, merged.driven);
    text += " (95 % interval of the share: " + percent(low) + " to " + percent(high) + " %)";
  }
  return text + "; " + std::to_string(merged.asked) + " asked for, " +
         std::to_string(merged.missing.size()) + " missing, " +
         std::to_string(merged.runs.size() - merged.driven) + " refused.";
}

bool all_completed(const Merged& merged) {
  return merged.completed == merged.asked && merged.missing.empty();
}

/// Command that drives the run again, into another folder than the campaign's runs.
std::string command(std::uint64_t index) {
  return "tp100-sim campaign spec.toml --out again --index " + std::to_string(index) +
         " --record again";
}

Rows figure_rows(const std::vector<ShownFigure>& figures) {
  Rows rows = {
      {"figure", "runs", "mean", "5 %", "median", "95 %", "99 %", "largest", "in merged.json"}};
  for (const ShownFigure& figure : figures) {
    const Summary& of = figure.merged->summary;
    rows.push_back(
        {figure.with_unit(), std::to_string(of.count), figure.text(of.mean, of.mean_interval)});
    for (const Percentile& percentile : of.percentiles)
      rows.back().push_back(figure.text(percentile.value, percentile.interval));
    rows.back().push_back(figure.text(of.most));
    rows.back().emplace_back(figure.name);
  }
  return rows;
}

/// Numbers to four digits; merged.json has all.
std::string sampled_text(const MergedRun& run) {
  std::string sampled;
  for (const auto& [name, text] : run.sampled) {
    const auto number = run.sampled_numbers.find(name);
    sampled += (sampled.empty() ? "" : ", ") + name + " " +
               (number == run.sampled_numbers.end() ? text : format("%.4g", number->second));
  }
  return sampled;
}

Rows cause_rows(const Merged& merged) {
  Rows rows = {{"cause", "runs"}};
  for (const auto& [cause, count] : merged.causes()) rows.push_back({cause, std::to_string(count)});
  return rows;
}

Rows failed_rows(const std::vector<const MergedRun*>& failed) {
  Rows rows = {{"run", "seed", "cause", "sampled", "to drive it again"}};
  for (std::size_t i = 0; i < std::min(failed.size(), kListed); ++i)
    rows.push_back({std::to_string(failed[i]->index),
                    std::to_string(failed[i]->seed),
                    {failed[i]->cause, true},
                    sampled_text(*failed[i]),
                    command(failed[i]->index)});
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

void add_spreads(report::HtmlPage& page, const std::vector<ShownFigure>& figures,
                 const Merged& merged) {
  if (figures.empty()) return;
  page.heading("Spread");
  page.paragraph(
      "Box plots over the completed runs, their number in brackets: box from the first to the "
      "third quartile with the median in it, whiskers from 5 to 95 %, a dot for each run beyond "
      "them. Below all runs those of each listed value, over all others.");
  for (const ShownFigure& figure : figures)
    page.figure(spread_chart(figure, merged), figure.with_unit() + ", by listed value");
}

/// A table for each list: a row for each of its values.
void add_groups(report::HtmlPage& page, const Merged& merged,
                const std::vector<ShownFigure>& figures) {
  if (merged.groups.empty()) return;
  page.heading("By listed value");
  page.paragraph("Median / 95 % of each figure; their intervals are in merged.json.");
  Rows rows;
  for (std::size_t i = 0; i < merged.groups.size(); ++i) {
    const MergedGroup& group = merged.groups[i];
    if (rows.empty()) {
      rows = {{"value", "completed"}};
      for (const ShownFigure& figure : figures) rows[0].emplace_back(figure.with_unit());
    }
    rows.push_back({group.value.empty() ? "(none)" : group.value,
                    std::to_string(group.completed) + " of " + std::to_string(group.driven)});
    for (const ShownFigure& figure : figures) {
      const auto of = group.figures.find(figure.name);
      if (of == group.figures.end()) {
        rows.back().emplace_back("-");
        continue;
      }
      const std::vector<Percentile>& percentiles = of->second.percentiles;
      rows.back().push_back(figure.text(percentiles[1].value) + " / " +
                            figure.text(percentiles[2].value));
    }
    if (i + 1 < merged.groups.size() && merged.groups[i + 1].variable == group.variable) continue;
    page.table(rows, "By " + group.variable);
    rows.clear();
  }
}

/// A row for each sampled number, a column for each figure.
Rows correlation_rows(const std::vector<ShownFigure>& figures) {
  Rows rows = {{"sampled"}};
  for (const ShownFigure& figure : figures) rows[0].emplace_back(figure.title);
  std::map<std::string, std::map<std::string, double>> by_sampled;
  for (const ShownFigure& figure : figures)
    for (const auto& [sampled, value] : figure.merged->correlations)
      by_sampled[sampled][figure.name] = value;
  for (const auto& [sampled, values] : by_sampled) {
    rows.push_back({sampled});
    for (const ShownFigure& figure : figures) {
      const auto found = values.find(figure.name);
      if (found == values.end())
        rows.back().emplace_back("-");
      else
        rows.back().push_back(
            format("%+.2f%s", found->second,
                   is_strong(found->second, figure.merged->summary.count) ? " strong" : ""));
    }
  }
  return rows;
}

void add_correlations(report::HtmlPage& page, const std::vector<ShownFigure>& figures,
                      const Merged& merged) {
  const Rows rows = correlation_rows(figures);
  if (rows.size() == 1) return;
  page.heading("Correlations");
  page.table(rows,
             "Spearman's rank correlation of sampled numbers and figures; \"-\": one of the "
             "two never changes");
  struct Strong {
    const ShownFigure* figure;
    std::string sampled;
    double value;
  };
  std::vector<Strong> strong;
  for (const ShownFigure& figure : figures)
    for (const auto& [sampled, value] : figure.merged->correlations)
      if (is_strong(value, figure.merged->summary.count))
        strong.push_back({&figure, sampled, value});
  std::stable_sort(strong.begin(), strong.end(), [](const Strong& a, const Strong& b) {
    return std::abs(a.value) > std::abs(b.value);
  });
  std::string text = std::string(kStrongRule) + " ";
  text +=
      strong.empty() ? "None is." : "Each strong one has a chart with a dot for each completed run";
  if (strong.size() > kMaxScatters)
    text += format("; the strongest %zu of %zu are shown", kMaxScatters, strong.size());
  page.paragraph(text + (strong.empty() ? "" : "."));
  strong.resize(std::min(strong.size(), kMaxScatters));
  for (const Strong& one : strong)
    page.figure(correlation_chart(*one.figure, one.sampled, one.value, merged),
                std::string(one.figure->title) + " against " + one.sampled);
}

Rows worst_rows(const ShownFigure& figure, const Merged& merged) {
  Rows rows = {
      {"value [" + std::string(figure.unit) + "]", "run", "seed", "sampled", "to drive it again"}};
  for (const auto& [index, value] : figure.merged->worst) {
    const MergedRun& run = merged.run(index);
    rows.push_back({figure.text(value), std::to_string(index), std::to_string(run.seed),
                    sampled_text(run), command(index)});
  }
  return rows;
}

void add_worst(report::HtmlPage& page, const std::vector<ShownFigure>& figures,
               const Merged& merged) {
  page.heading("Worst completed runs");
  page.paragraph(
      std::string("The largest values of each figure") +
      (merged.failed().empty() ? "" : "; worse than these are the failed runs, above") +
      ". The commands drive a run again in this folder, and record it for tp100d report.");
  for (const ShownFigure& figure : figures) page.table(worst_rows(figure, merged), figure.title);
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

}  // namespace

std::string merge_page(const Merged& merged, const std::string& spec_text,
                       const std::vector<std::pair<std::string, std::string>>& facts) {
  report::HtmlPage page("Campaign");
  page.verdict(all_completed(merged), completion(merged));
  page.facts({facts.begin(), facts.end()});
  page.paragraph(
      "Figures are those of completed runs, against the emulated body's exact pose; in brackets 95 "
      "% intervals. Every figure is in merged.json, every run in runs.csv.");
  add_failed(page, merged);
  const std::vector<ShownFigure> figures = shown_figures(merged);
  page.heading("Figures");
  page.table(figure_rows(figures), "Over all completed runs");
  add_spreads(page, figures, merged);
  add_groups(page, merged, figures);
  add_correlations(page, figures, merged);
  add_worst(page, figures, merged);
  if (const Rows rows = refused_rows(merged); rows.size() > 1) {
    page.heading("Refused");
    page.table(rows, "Runs whose sampled values no robot or configuration can have");
  }
  page.heading("Specification");
  page.folded("spec.toml", spec_text);
  return page.text();
}

}  // namespace tp100::sim
