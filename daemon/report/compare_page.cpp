#include <cmath>
#include <functional>

#include "core/arithmetic.h"
#include "report/html_page.h"
#include "report/metrics.h"
#include "report/page_parts.h"
#include "report/report_page.h"
#include "text/format.h"

namespace tp100::report {
namespace {

/// The runs and the errors of each.
struct Compared {
  const std::vector<ComparedRun>& runs;
  const std::vector<std::optional<RunFigures>>& judged;
};

/// One figure of every run. Smaller is better, except for figures without a direction.
struct FigureOfRuns {
  std::string name, unit;
  int places = 2;
  bool has_direction = true;
  std::function<double(const RecordedRun&, const std::optional<RunFigures>&)> value;
};
using Figures = std::vector<FigureOfRuns>;

void add_pose_figures(Figures& figures, PoseSource source) {
  const std::string name(to_string(source));
  const struct {
    const char *what, *unit;
    double PoseErrors::*error;
    double scale;
  } kinds[] = {{": largest error", "cm", &PoseErrors::max_position_error_m, kCmPerM},
               {": mean error", "cm", &PoseErrors::mean_position_error_m, kCmPerM},
               {": rms error", "cm", &PoseErrors::rms_position_error_m, kCmPerM},
               {": error at the end", "cm", &PoseErrors::final_position_error_m, kCmPerM},
               {": largest yaw error", "deg", &PoseErrors::max_yaw_error_rad, kDegPerRad}};
  for (const auto& kind : kinds)
    figures.push_back({name + kind.what, kind.unit, 2, true,
                       [=](const RecordedRun&, const std::optional<RunFigures>& judged) {
                         const bool known = judged && judged->estimates[source];
                         return known ? (*judged->estimates[source]).*kind.error * kind.scale
                                      : std::nan("");
                       }});
}

void add_tracking_figures(Figures& figures) {
  const struct {
    const char *what, *unit;
    double TrackingErrors::*error;
    double scale;
  } kinds[] = {
      {"tracking: truth farthest from the path", "cm", &TrackingErrors::max_cross_track_m, kCmPerM},
      {"tracking: truth from the path, rms", "cm", &TrackingErrors::rms_cross_track_m, kCmPerM},
      {"tracking: largest yaw error of the truth", "deg", &TrackingErrors::max_yaw_error_rad,
       kDegPerRad}};
  for (const auto& kind : kinds)
    figures.push_back({kind.what, kind.unit, 2, true,
                       [=](const RecordedRun&, const std::optional<RunFigures>& judged) {
                         return judged ? judged->tracking.*kind.error * kind.scale : std::nan("");
                       }});
  const auto begun = [](const RecordedRun& run, double value) {
    return run.runs > 0 && run.run_context.course != nullptr ? value : std::nan("");
  };
  figures.push_back({"steering pose farthest from the path, as the controller saw it", "cm", 2,
                     true, [=](const RecordedRun& run, const std::optional<RunFigures>&) {
                       return begun(run, run.estimated.max_cross_track_m * kCmPerM);
                     }});
  figures.push_back({"steering pose from the path, rms", "cm", 2, true,
                     [=](const RecordedRun& run, const std::optional<RunFigures>&) {
                       return begun(run, run.estimated.rms_cross_track_m * kCmPerM);
                     }});
}

/// All figures that are known for at least one run.
Figures all_figures(const Compared& all) {
  Figures figures = {
      {"duration", "s", 2, false, [](const RecordedRun& run, const std::optional<RunFigures>&) {
         return run.result.duration_s;
       }}};
  for (const PoseSource source : kPoseSources) add_pose_figures(figures, source);
  add_tracking_figures(figures);
  figures.push_back(
      {"frames lost", "", 0, true, [](const RecordedRun& run, const std::optional<RunFigures>&) {
         return static_cast<double>(run.result.link.lost);
       }});
  figures.push_back(
      {"jitter, 99 %", "us", 1, true, [](const RecordedRun& run, const std::optional<RunFigures>&) {
         return in_real_time(run) ? run.jitter.p99_us : std::nan("");
       }});
  std::erase_if(figures, [&](const FigureOfRuns& figure) {
    for (std::size_t i = 0; i < all.runs.size(); ++i)
      if (std::isfinite(figure.value(all.runs[i].run, all.judged[i]))) return false;
    return true;
  });
  return figures;
}

/// Value minus that of the base run, with sign and unit, marked if it is better.
Cell difference(const FigureOfRuns& figure, double value, double base) {
  if (!std::isfinite(value) || !std::isfinite(base)) return "-";
  const double unit = std::pow(10.0, -figure.places);
  if (std::abs(value - base) < unit / 2.0) return "0 same";
  const std::string text = text::format("%+.*f", figure.places, value - base) +
                           (figure.unit.empty() ? "" : " " + figure.unit);
  if (!figure.has_direction) return text;
  return value < base ? Cell(text + " better", Mark::kBetter)
                      : Cell(text + " worse", Mark::kMissed);
}

Rows difference_rows(const Compared& all) {
  Rows rows = {{"figure", "base: " + plain(all.runs[0].name)}};
  for (std::size_t i = 1; i < all.runs.size(); ++i) {
    rows[0].emplace_back(plain(all.runs[i].name));
    rows[0].emplace_back("difference to base");
  }
  for (const FigureOfRuns& figure : all_figures(all)) {
    const double base = figure.value(all.runs[0].run, all.judged[0]);
    rows.push_back({figure.name + (figure.unit.empty() ? "" : " [" + figure.unit + "]"),
                    decimals(base, figure.places)});
    for (std::size_t i = 1; i < all.runs.size(); ++i) {
      const double value = figure.value(all.runs[i].run, all.judged[i]);
      rows.back().emplace_back(decimals(value, figure.places));
      rows.back().push_back(difference(figure, value, base));
    }
  }
  return rows;
}

/// Names of the runs whose course or set-up differs from that of the base run.
std::string unlike_base(const Compared& all) {
  std::string names;
  for (const ComparedRun& one : all.runs)
    if (one.run.result.course != all.runs[0].run.result.course ||
        one.run.result.setup != all.runs[0].run.result.setup)
      names += (names.empty() ? "" : ", ") + plain(one.name);
  return names;
}

Rows outcome_rows(const std::vector<ComparedRun>& runs) {
  Rows rows = {
      {"run", "outcome", "course, robot, set-up", "seed", "steered by", "driven", "driven with"}};
  for (const auto& [name, run] : runs)
    rows.push_back({plain(name), outcome(run), title_of(run),
                    run.facts.contains("seed") ? std::to_string(run.result.seed) : "-",
                    std::string(to_string(run.run_context.steering)), date_of(run),
                    program_of(run)});
  return rows;
}

}  // namespace

std::string compare_page(const std::vector<ComparedRun>& runs,
                         const std::vector<std::optional<RunFigures>>& judged,
                         const std::vector<Figure>& figures) {
  const Compared all{runs, judged};
  HtmlPage page("Runs compared");
  std::size_t completed = 0;
  for (const ComparedRun& one : runs) completed += std::size_t{one.run.result.completed};
  page.verdict(completed == runs.size(),
               text::format("%zu of %zu runs completed.", completed, runs.size()));
  page.table(outcome_rows(runs), "The runs; the first is the base of all differences");
  page.heading("Differences to the base run");
  if (const std::string names = unlike_base(all); !names.empty())
    page.paragraph("Driven on another course or in another set-up than the base run: " + names +
                   ". Part of their differences comes from that.");
  page.paragraph(
      "Errors are against the truth, those of the model piece by piece between disturbances; "
      "\"-\": not known, as without truth, or of a run that never began. One run each: a "
      "difference may be chance; a campaign (tp100-sim campaign) shows the spread of runs.");
  page.table(difference_rows(all),
             "A difference is the run minus the base run; of all figures but the duration, smaller "
             "is better");
  Rows baselines = {kPoseHead}, jitter = {kDurationHead};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (judged[i]) add_baselines(baselines, plain(runs[i].name) + ": ", *judged[i]);
    if (in_real_time(runs[i].run))
      jitter.push_back(duration_row(plain(runs[i].name), runs[i].run.jitter));
  }
  add_figures(page, figures);
  if (baselines.size() > 1) {
    page.heading("Forms of the model");
    page.table(baselines, kBaselinesCaption);
  }
  if (jitter.size() > 1) {
    page.heading("Loop");
    page.table(jitter, "Jitter: time between two steps against the period, of runs in real time");
  }
  return page.text();
}

}  // namespace tp100::report
