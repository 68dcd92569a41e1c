#include "report/report_page.h"

#include <filesystem>

#include "core/arithmetic.h"
#include "report/html_page.h"
#include "report/page_parts.h"
#include "report/report_figures.h"
#include "report/result_text.h"
#include "text/file_name.h"

namespace tp100::report {
namespace {

using Facts = std::vector<std::pair<std::string, Cell>>;

std::string count(std::uint64_t value) { return std::to_string(value); }

std::string page_title(const RecordedRun& run) {
  return run.result.course.empty() ? "Run without a course"
                                   : "Run on course " + plain(run.result.course);
}

void add_verdict(HtmlPage& page, const RecordedRun& run) {
  if (run.result.completed)
    page.verdict(true, "Completed in " + decimals(run.result.duration_s, 1) + " s.");
  else
    page.verdict(false, "Not completed: " + plain(run.result.cause) + ".");
}

/// The largest error of each estimate.
std::string largest_errors(const RunFigures& judged) {
  std::string out;
  for (const PoseSource source : kPoseSources)
    if (const auto& errors = judged.estimates[source])
      out += (out.empty() ? "" : ", ") + std::string(to_string(source)) + " " +
             decimals(errors->max_position_error_m * kCmPerM, 2) + " cm";
  return out;
}

/// Where the run is allowed to be.
std::string fence_of(const RecordedRun& run) {
  if (run.run_context.course == nullptr) return "none";
  const course::Course& course = *run.run_context.course;
  const course::Fence& fence = course.fence;
  return (fence.corners.empty()
              ? "x " + decimals(fence.min_x_m, 2) + " to " + decimals(fence.max_x_m, 2) + " m, y " +
                    decimals(fence.min_y_m, 2) + " to " + decimals(fence.max_y_m, 2) + " m"
              : "a polygon of " + count(fence.corners.size()) + " corners") +
         (fence.keep_out.empty() ? "" : ", " + count(fence.keep_out.size()) + " keep-out areas");
}

Facts summary(const RecordedRun& run, const std::optional<RunFigures>& judged) {
  Facts facts = {{"driven", date_of(run)},
                 {"course", run.result.course.empty() ? "none" : plain(run.result.course)},
                 {"robot", plain(run.result.robot)},
                 {"set-up", plain(run.result.setup)},
                 {"board", run.result.board.empty() ? "not known" : plain(run.result.board)},
                 {"seed", run.facts.contains("seed") ? count(run.result.seed)
                          : run.result.board.starts_with("emulated")
                              ? "not known: the emulator was another program"
                              : "none: no emulated robot"},
                 {"fence", fence_of(run)},
                 {"steered by", std::string(to_string(run.run_context.steering)) + " pose"},
                 {"driven with", program_of(run)},
                 {"duration", decimals(run.result.duration_s, 2) + " s"},
                 {"truth", run.has_truth ? "known" : "not known"}};
  const RunNotes& notes = run.run_context.notes;
  for (const auto& [what, text] : {std::pair("name", &notes.name), std::pair("tags", &notes.tags),
                                   std::pair("note", &notes.note)})
    if (!text->empty()) facts.emplace_back(what, plain(*text));
  if (judged) {
    facts.emplace_back("largest position errors", largest_errors(*judged));
    facts.emplace_back("farthest from the path",
                       decimals(judged->tracking.max_cross_track_m * kCmPerM, 2) + " cm");
    for (const PoseSource source : kPoseSources)
      if (const auto& within = judged->within_2_sd[source])
        facts.emplace_back("true pose within 2 sd of " + std::string(to_string(source)),
                           decimals(100.0 * within->position, 0) + " % of x and y, " +
                               decimals(100.0 * within->yaw, 0) + " % of yaw" +
                               (source == PoseSource::kModel && !run.result.disturbances.empty()
                                    ? ", up to the first disturbance"
                                    : ""));
  }
  facts.emplace_back("recording", plain(run.path));
  facts.emplace_back("steps", Cell(count(run.steps) + ", " + count(run.missing_steps) + " missing",
                                   run.missing_steps > 0));
  if (run.runs > 1)
    facts.emplace_back("runs in the recording", count(run.runs) + ", the last is shown");
  if (!run.whole)
    facts.emplace_back("cut off",
                       Cell("the file ends early; the report covers everything before that", true));
  if (run.every > 1) facts.emplace_back("points", "every " + count(run.every) + "th is used");
  if (run.implausible > 0)
    facts.emplace_back("points left out",
                       Cell(count(run.implausible) + ": their values are impossible", true));
  return facts;
}

void add_errors(HtmlPage& page, const RecordedRun& run, const std::optional<RunFigures>& judged) {
  page.heading("Errors");
  if (run.runs == 0) {
    page.paragraph(
        "The run never began: there is nothing to judge. What follows is of the whole "
        "recording.");
    return;
  }
  if (judged) {
    Rows model = {kPoseHead}, estimates = {kPoseHead};
    for (const PoseSource source : kPoseSources) {
      if (!judged->estimates[source]) continue;
      (blind_to_disturbances(source) ? model : estimates)
          .push_back(pose_row(std::string(to_string(source)), *judged->estimates[source]));
    }
    page.table(model,
               "Model: on encoder counts (the extended model; or as model.mode says) against the "
               "truth, piece by piece between disturbances");
    page.table(estimates, "Estimates against the truth, from start to end");
    Rows baselines = {kPoseHead};
    add_baselines(baselines, {}, *judged);
    if (baselines.size() > 1) page.table(baselines, kBaselinesCaption);
    Rows tracking = {{"", "max [cm]", "rms [cm]", "yaw max [deg]"},
                     {"tracking", decimals(judged->tracking.max_cross_track_m * kCmPerM, 2),
                      decimals(judged->tracking.rms_cross_track_m * kCmPerM, 2),
                      decimals(judged->tracking.max_yaw_error_rad * kDegPerRad, 2)}};
    page.table(tracking, "Tracking: the truth against the path");
    std::string recovery;
    for (const DisturbanceResponse& one : judged->tracking.recovery)
      recovery += (recovery.empty() ? "" : ", ") +
                  (one.settling_s ? decimals(*one.settling_s, 2) + " s" : "never");
    if (!recovery.empty())
      page.paragraph("Recovered from the disturbances after " + recovery + ".");
  } else {
    page.paragraph(run.has_truth
                       ? "The run had no course, so that tracking is not judged."
                       : "The true pose was not measured: neither the model, nor the "
                         "estimates, nor the tracking can be judged. What follows are differences "
                         "between estimates and what the controller estimated.");
    const Difference difference = model_from_odometry(run);
    page.table({{"", "max [cm]", "at the end [cm]"},
                {"model from odometry", decimals(difference.max_m * kCmPerM, 2),
                 decimals(difference.final_m * kCmPerM, 2)}},
               "Difference of two estimates, which is not the error of either");
  }
  if (run.run_context.course == nullptr) return;
  page.table({{"", "max [cm]", "rms [cm]", "heading max [deg]"},
              {"estimated", decimals(run.estimated.max_cross_track_m * kCmPerM, 2),
               decimals(run.estimated.rms_cross_track_m * kCmPerM, 2),
               decimals(run.estimated.max_heading_error_rad * kDegPerRad, 2)}},
             "The steering pose against the path: what the controller saw, which is not the truth");
}

void add_timing(HtmlPage& page, const RecordedRun& run) {
  page.heading("Loop");
  Rows durations = {kDurationHead};
  if (in_real_time(run)) durations.push_back(duration_row("jitter", run.jitter));
  durations.push_back(duration_row("age of the newest sample", run.sample_age));
  if (run.world_age.count > 0)
    durations.push_back(duration_row("age of the world's newest answer", run.world_age));
  const std::string period = decimals(1e6 / run.run_context.rate_hz, 0) + " us";
  if (!in_real_time(run)) {
    page.table(durations, "Virtual time: every step took exactly the period of " + period +
                              ", so that there is no jitter");
    return;
  }
  page.table(durations, "Jitter: time between two steps against the period of " + period +
                            "; percentiles to 5 %");
  Rows rows = {{"jitter", "steps"}};
  for (std::size_t i = 0; i < run.jitter_counts.size(); ++i) {
    const bool last = i == messages::kLatenessEdgesUs.size();
    if (run.jitter_counts[i] == 0) continue;
    rows.push_back({(last ? "above " : "below ") +
                        std::to_string(messages::kLatenessEdgesUs[last ? i - 1 : i]) + " us",
                    count(run.jitter_counts[i])});
  }
  page.table(rows,
             "Each step counts in the first row that applies; rows without a step are left out");
}

void add_link(HtmlPage& page, const RecordedRun& run) {
  page.heading("Link");
  Rows rows = {{"counter", "since the start"}};
  const auto add = [&](std::string_view name, std::uint64_t value) {
    rows.push_back({name, count(value)});
  };
  visit_fields(add, run.result.link);
  page.table(rows, "Every lost byte or frame is in exactly one of them");
}

void add_events(HtmlPage& page, const RecordedRun& run) {
  page.heading("Events");
  Rows rows = {{"time [s]", "what", "what to do"}};
  for (const RunEvent& event : run.events)
    rows.push_back({decimals(event.t_s, 3), {plain(event.text), event.bad}, plain(event.fix)});
  page.table(rows, "Time counts from the beginning of the run");
  if (run.more_events > 0)
    page.paragraph(std::to_string(run.more_events) + " more are not listed.");
}

void add_settings(HtmlPage& page, const RecordedRun& run) {
  page.heading("Settings");
  for (const auto& [name, text] : run.files)
    page.folded(name, text.empty() ? "(none: all defaults)" : text);
  page.heading("Versions");
  std::vector<std::pair<std::string, Cell>> facts;
  for (const auto& [name, value] : run.facts) facts.emplace_back(plain(name), plain(value));
  page.facts(facts);
}

// The daemon serves a run's folder as /runs/NAME/.
void add_replay(HtmlPage& page, const RecordedRun& run) {
  page.heading("Replay");
  const std::string name = std::filesystem::path(run.path).parent_path().filename();
  page.paragraph("The page of tp100d replays this run in the course's world: tab Runs.");
  page.insert("<p><a href=\"../../#replay=" + text::percent_encoded(name) +
              "\">Replay it</a>, if that page shows this report.</p>\n");
}

}  // namespace

std::string report_page(const RecordedRun& run, const std::optional<RunFigures>& judged,
                        const std::vector<Figure>& figures) {
  HtmlPage page(page_title(run));
  add_verdict(page, run);
  page.facts(summary(run, judged));
  add_errors(page, run, judged);
  add_replay(page, run);
  add_figures(page, figures);
  add_timing(page, run);
  add_link(page, run);
  add_events(page, run);
  add_settings(page, run);
  return page.text();
}

}  // namespace tp100::report
