#include "report/report_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/angle.h"
#include "report/html_page.h"
#include "report/replay_view.h"
#include "report/run_metrics.h"
#include "text/toml_document.h"

namespace tp100::report {
namespace {

using Row = Rows::value_type;

constexpr double kCmPerM = 100.0;
constexpr std::size_t kLongestFact = 200;

std::string number(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string plain(const std::string& text) { return text::one_line(text, kLongestFact); }

std::string count(std::uint64_t value) { return std::to_string(value); }

std::string title_of(const RecordedRun& run) {
  const std::string course = run.result.course.empty() ? "no course" : run.result.course;
  return plain(course) + ", " + plain(run.result.robot) + ", " + plain(run.result.setup);
}

Cell outcome(const RecordedRun& run) {
  if (run.result.completed) return "completed";
  return {"not completed: " + plain(run.result.cause), true};
}

Rows summary(const RecordedRun& run) {
  Rows rows = {{"", ""},
               {"outcome", outcome(run)},
               {"duration", number(run.result.duration_s, 2) + " s"},
               {"steered by", std::string(to_string(run.subject.steering))},
               {"truth", run.has_truth ? "known" : "not known"},
               {"recording", plain(run.path)},
               {"steps", count(run.steps) + ", " + count(run.missing_steps) + " missing"}};
  if (run.runs > 1)
    rows.push_back({"runs in the recording", count(run.runs) + ", the last is shown"});
  if (!run.whole) rows.push_back({"recording", {"cut off; everything up to there is here", true}});
  if (run.every > 1) rows.push_back({"points", "every " + count(run.every) + "th is looked at"});
  if (run.implausible > 0)
    rows.push_back(
        {"points left out", {count(run.implausible) + ": their values are impossible", true}});
  return rows;
}

Row pose_row(const std::string& name, const PoseErrors& e) {
  return {name,
          number(e.max_position_error_m * kCmPerM, 2),
          number(e.mean_position_error_m * kCmPerM, 2),
          number(e.rms_position_error_m * kCmPerM, 2),
          number(e.final_position_error_m * kCmPerM, 2),
          number(e.max_yaw_error_rad * kDegPerRad, 2)};
}

const Row kPoseHead = {"", "max [cm]", "mean [cm]", "rms [cm]", "final [cm]", "yaw max [deg]"};

void add_errors(HtmlPage& page, const RecordedRun& run, const std::optional<RunFigures>& judged) {
  page.heading("Errors");
  if (judged) {
    page.table({kPoseHead, pose_row("model", judged->model)},
               "Model: on encoder counts (extended: eqs 1-5 and seven constants of ours; or as "
               "model.mode says) against the truth, piece by piece between shoves");
    Rows estimates = {kPoseHead, pose_row("odometry", judged->odometry)};
    if (judged->fused) estimates.push_back(pose_row("fused", *judged->fused));
    page.table(estimates, "Estimates against the truth, from start to end");
    Rows tracking = {{"", "max [cm]", "rms [cm]", "yaw max [deg]"},
                     {"tracking", number(judged->tracking.max_cross_track_m * kCmPerM, 2),
                      number(judged->tracking.rms_cross_track_m * kCmPerM, 2),
                      number(judged->tracking.max_yaw_error_rad * kDegPerRad, 2)}};
    page.table(tracking, "Tracking: the truth against the path");
    std::string recovery;
    for (const auto& time : judged->tracking.recovery_s)
      recovery += (recovery.empty() ? "" : ", ") + (time ? number(*time, 2) + " s" : "never");
    if (!recovery.empty()) page.paragraph("Recovered from the shoves after " + recovery + ".");
  } else {
    page.paragraph(run.has_truth
                       ? "There was no course to judge the run by."
                       : "Nobody measured where the robot truly was: neither the model, nor the "
                         "estimates, nor the tracking can be judged. What follows are differences "
                         "between estimates and what the controller believed.");
    const Difference difference = model_from_odometry(run);
    page.table({{"", "max [cm]", "at the end [cm]"},
                {"model from odometry", number(difference.max_m * kCmPerM, 2),
                 number(difference.final_m * kCmPerM, 2)}},
               "Difference of two estimates; no error of either");
  }
  if (run.subject.course == nullptr) return;
  page.table({{"", "max [cm]", "rms [cm]", "heading max [deg]"},
              {"believed", number(run.believed.max_cross_track_m * kCmPerM, 2),
               number(run.believed.rms_cross_track_m * kCmPerM, 2),
               number(run.believed.max_heading_error_rad * kDegPerRad, 2)}},
             "The pose that steered against the path: what the controller saw, not what was true");
}

Row duration_row(const std::string& name, const messages::Durations& d) {
  return {name,
          count(d.count),
          number(d.mean_us, 1),
          number(d.p50_us, 1),
          number(d.p99_us, 1),
          number(d.p999_us, 1),
          number(d.max_us, 1)};
}

const Row kDurationHead = {"[us]", "count", "mean", "50 %", "99 %", "99.9 %", "max"};

void add_timing(HtmlPage& page, const RecordedRun& run) {
  page.heading("Loop");
  page.table({kDurationHead, duration_row("jitter", run.jitter),
              duration_row("age of the newest sample", run.sample_age)},
             "Jitter: time between two steps against the period of " +
                 number(1e6 / run.subject.rate_hz, 0) + " us; percentiles to 5 %");
  Rows rows = {{"jitter", "steps"}};
  for (std::size_t i = 0; i < run.jitter_counts.size(); ++i) {
    const bool last = i == messages::kLatenessEdgesUs.size();
    rows.push_back({(last ? "above " : "below ") +
                        std::to_string(messages::kLatenessEdgesUs[last ? i - 1 : i]) + " us",
                    count(run.jitter_counts[i])});
  }
  page.table(rows, "Each row without those above it");
}

void add_link(HtmlPage& page, const RecordedRun& run) {
  page.heading("Link");
  Rows rows = {{"counter", "since the start"}};
  for (const auto& [name, value] : counters_of(run.result.link))
    rows.push_back({name, count(value)});
  page.table(rows, "Every lost byte or frame is in exactly one of them");
}

void add_events(HtmlPage& page, const RecordedRun& run) {
  page.heading("Events");
  Rows rows = {{"time [s]", "what", "what to do"}};
  for (const RunEvent& event : run.events)
    rows.push_back({number(event.t_s, 3), {plain(event.text), event.bad}, plain(event.remedy)});
  page.table(rows, "Time counts from the beginning of the run");
  if (run.more_events > 0) page.paragraph(count(run.more_events) + " more are not listed.");
}

void add_settings(HtmlPage& page, const RecordedRun& run) {
  page.heading("Settings");
  for (const auto& [name, text] : run.files)
    page.folded(name, text.empty() ? "(none: all defaults)" : text);
  page.heading("Versions");
  Rows rows = {{"", ""}};
  for (const auto& [name, value] : run.facts) rows.push_back({plain(name), plain(value)});
  page.table(rows, "As the recording says");
}

void add_figures(HtmlPage& page, const std::vector<Figure>& figures) {
  page.heading("Figures");
  for (std::size_t i = 0; i < figures.size(); i += 2) {
    std::vector<std::string> svgs = {figures[i].svg};
    std::string caption = figures[i].caption;
    if (i + 1 < figures.size()) {
      svgs.push_back(figures[i + 1].svg);
      caption += " " + figures[i + 1].caption;
    }
    page.figures(svgs, caption);
  }
}

}  // namespace

std::string report_page(const RecordedRun& run, const std::optional<RunFigures>& judged,
                        const std::vector<Figure>& figures) {
  HtmlPage page(title_of(run));
  page.table(summary(run), "The run");
  add_errors(page, run, judged);
  page.heading("Replay");
  page.insert(replay_view(run));
  add_figures(page, figures);
  add_timing(page, run);
  add_link(page, run);
  add_events(page, run);
  add_settings(page, run);
  return page.text();
}

std::string compare_page(const std::vector<ComparedRun>& runs,
                         const std::vector<std::optional<RunFigures>>& judged,
                         const std::vector<Figure>& figures) {
  HtmlPage page("Runs compared");
  Rows outcomes = {{"run", "course, robot, set-up", "outcome", "duration [s]", "lost", "version"}};
  Rows model = {kPoseHead}, odometry = {kPoseHead}, fused = {kPoseHead};
  Rows tracking = {{"", "max [cm]", "rms [cm]", "yaw max [deg]"}}, believed = tracking;
  Rows jitter = {kDurationHead};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RecordedRun& run = runs[i].run;
    const std::string name = plain(runs[i].name);
    const auto version = run.facts.find("version");
    outcomes.push_back({name, title_of(run), outcome(run), number(run.result.duration_s, 2),
                        count(run.result.link.lost),
                        version == run.facts.end() ? "" : plain(version->second)});
    believed.push_back({name, number(run.believed.max_cross_track_m * kCmPerM, 2),
                        number(run.believed.rms_cross_track_m * kCmPerM, 2),
                        number(run.believed.max_heading_error_rad * kDegPerRad, 2)});
    jitter.push_back(duration_row(name, run.jitter));
    if (!judged[i]) continue;
    model.push_back(pose_row(name, judged[i]->model));
    odometry.push_back(pose_row(name, judged[i]->odometry));
    if (judged[i]->fused) fused.push_back(pose_row(name, *judged[i]->fused));
    tracking.push_back({name, number(judged[i]->tracking.max_cross_track_m * kCmPerM, 2),
                        number(judged[i]->tracking.rms_cross_track_m * kCmPerM, 2),
                        number(judged[i]->tracking.max_yaw_error_rad * kDegPerRad, 2)});
  }
  page.table(outcomes, "The runs");
  page.heading("Errors");
  page.paragraph("Runs whose truth is not known are only in the last table.");
  page.table(model, "Model against the truth, piece by piece between shoves");
  page.table(odometry, "Odometry (estimate) against the truth");
  if (fused.size() > 1) page.table(fused, "Fused (estimate) against the truth");
  page.table(tracking, "Tracking: the truth against the path");
  page.table(believed, "The pose that steered against the path: what the controller saw");
  add_figures(page, figures);
  page.heading("Loop");
  page.table(jitter, "Jitter: time between two steps against the period");
  return page.text();
}

}  // namespace tp100::report
