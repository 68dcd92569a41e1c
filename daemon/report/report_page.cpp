#include "report/report_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/angle.h"
#include "course/path.h"
#include "report/html_page.h"
#include "report/report_figures.h"
#include "report/run_metrics.h"
#include "text/toml_document.h"

namespace tp100::report {
namespace {

using Row = Rows::value_type;

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
               {"steered by", std::string(to_string(run.run_context.steering))},
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

Row pose_row(PoseSource source, const PoseErrors& errors) {
  return pose_row(std::string(to_string(source)), errors);
}

const Row kPoseHead = {"", "max [cm]", "mean [cm]", "rms [cm]", "final [cm]", "yaw max [deg]"};

constexpr const char* kBaselinesCaption =
    "Simpler forms of the model on the same counts against the truth, piece by piece between "
    "disturbances: what slip compensation brings, and the extension beyond eqs 1-5";

/// A row for each form that was judged.
void add_baselines(Rows& rows, const std::string& run, const RunFigures& judged) {
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i)
    if (judged.baselines[i])
      rows.push_back(pose_row(run + std::string(model::kBaselines[i].key), *judged.baselines[i]));
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
          .push_back(pose_row(source, *judged->estimates[source]));
    }
    page.table(model,
               "Model: on encoder counts (the extended model; or as model.mode says) against the "
               "truth, piece by piece between disturbances");
    page.table(estimates, "Estimates against the truth, from start to end");
    Rows baselines = {kPoseHead};
    add_baselines(baselines, {}, *judged);
    if (baselines.size() > 1) page.table(baselines, kBaselinesCaption);
    Rows tracking = {{"", "max [cm]", "rms [cm]", "yaw max [deg]"},
                     {"tracking", number(judged->tracking.max_cross_track_m * kCmPerM, 2),
                      number(judged->tracking.rms_cross_track_m * kCmPerM, 2),
                      number(judged->tracking.max_yaw_error_rad * kDegPerRad, 2)}};
    page.table(tracking, "Tracking: the truth against the path");
    std::string recovery;
    for (const auto& time : judged->tracking.recovery_s)
      recovery += (recovery.empty() ? "" : ", ") + (time ? number(*time, 2) + " s" : "never");
    if (!recovery.empty())
      page.paragraph("Recovered from the disturbances after " + recovery + ".");
  } else {
    page.paragraph(run.has_truth
                       ? "There was no course to judge the run by."
                       : "Nobody measured where the robot truly was: neither the model, nor the "
                         "estimates, nor the tracking can be judged. What follows are differences "
                         "between estimates and what the controller estimated.");
    const Difference difference = model_from_odometry(run);
    page.table({{"", "max [cm]", "at the end [cm]"},
                {"model from odometry", number(difference.max_m * kCmPerM, 2),
                 number(difference.final_m * kCmPerM, 2)}},
               "Difference of two estimates; no error of either");
  }
  if (run.run_context.course == nullptr) return;
  page.table({{"", "max [cm]", "rms [cm]", "heading max [deg]"},
              {"estimated", number(run.estimated.max_cross_track_m * kCmPerM, 2),
               number(run.estimated.rms_cross_track_m * kCmPerM, 2),
               number(run.estimated.max_heading_error_rad * kDegPerRad, 2)}},
             "The steering pose against the path: what the controller saw, not what was true");
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
                 number(1e6 / run.run_context.rate_hz, 0) + " us; percentiles to 5 %");
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
    rows.push_back({number(event.t_s, 3), {plain(event.text), event.bad}, plain(event.fix)});
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

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxFrames = 2000;

double rounded(double value) { return std::round(value * 1e5) / 1e5; }

Json place(double x_m, double y_m, double z_m) {
  return Json::array({rounded(x_m), rounded(y_m), rounded(z_m)});
}

Json json_of(const Pose& pose) {
  return Json::array({rounded(pose.x_m), rounded(pose.y_m), rounded(pose.z_m),
                      rounded(pose.roll_rad), rounded(pose.pitch_rad), rounded(pose.yaw_rad)});
}

Json robot_of(const course::Robot& robot) {
  return {{"length", robot.shape.length_m},
          {"gauge", robot.shape.gauge_m},
          {"track", robot.emulated.body.shoe_width_m},
          {"height", robot.shape.height_m},
          {"radius", robot.shape.wheel_radius_m}};
}

Json frames_of(const RecordedRun& run) {
  Json frames = {{"t", Json::array()},
                 {"robot", Json::array()},
                 {"left", Json::array()},
                 {"right", Json::array()},
                 {"truth", Json::array()}};
  const std::vector<TrajectoryPoint>& points = run.result.points;
  const std::size_t every = points.size() / kMaxFrames + 1;
  double left_m = 0.0, right_m = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const TrajectoryPoint& point = points[i];
    const RunMoment& moment = run.moments[i];
    const double dt_s = i > 0 ? point.t_s - points[i - 1].t_s : 0.0;
    if (std::isfinite(moment.left_mps)) left_m += moment.left_mps * dt_s;
    if (std::isfinite(moment.right_mps)) right_m += moment.right_mps * dt_s;
    if (i % every != 0 && i + 1 != points.size()) continue;
    // Estimates do not contain the floor's height; the world does.
    const double z_m = moment.steering_world.z_m;
    frames["t"].push_back(rounded(point.t_s));
    frames["robot"].push_back(json_of(moment.steering_world));
    frames["left"].push_back(rounded(left_m));
    frames["right"].push_back(rounded(right_m));
    frames["truth"].push_back(run.has_truth ? json_of(point.world) : Json());
    for (const PoseSource source : kPoseSources) {
      const Pose& pose = point.estimates[source];
      frames[to_string(source)].push_back(place(pose.x_m, pose.y_m, z_m));
    }
  }
  return frames;
}

void add_course(const course::Course& course, Json& view) {
  for (const auto& [x_m, y_m] : path_line(course))
    view["path"].push_back(Json::array({rounded(x_m), rounded(y_m)}));
  for (const course::Ramp& r : course.terrain.ramps)
    view["ramps"].push_back({r.place.x_m, r.place.y_m, r.place.heading_rad, r.height_m,
                             r.up_length_m(), r.top_m, r.down_length_m(), r.width_m});
  for (const course::Block& b : course.terrain.blocks)
    view["blocks"].push_back(
        {b.place.x_m, b.place.y_m, b.place.heading_rad, b.height_m, b.depth_m, b.width_m});
  for (const course::Surface& s : course.terrain.surfaces)
    view["surfaces"].push_back(
        {s.place.x_m, s.place.y_m, s.place.heading_rad, s.length_m, s.width_m});
}

/// Adds the centre and the extent of the view.
void add_extent(const RecordedRun& run, Json& view) {
  double low_x = 0.0, high_x = 0.0, low_y = 0.0, high_y = 0.0;
  bool any = false;
  const auto widen = [&](double x_m, double y_m) {
    low_x = any ? std::min(low_x, x_m) : x_m;
    high_x = any ? std::max(high_x, x_m) : x_m;
    low_y = any ? std::min(low_y, y_m) : y_m;
    high_y = any ? std::max(high_y, y_m) : y_m;
    any = true;
  };
  for (const Json& point : view["path"]) widen(point[0], point[1]);
  for (const RunMoment& moment : run.moments)
    widen(moment.steering_world.x_m, moment.steering_world.y_m);
  view["middle"] = {rounded((low_x + high_x) / 2.0), rounded((low_y + high_y) / 2.0)};
  view["size"] = rounded(std::max({high_x - low_x, high_y - low_y, 0.5}));
}

/// A 3-D view of a run, as a part of an HTML page: canvas, controls, script and data; no external
/// references. Shows the robot at the steering pose in the course's world, and its outline at the
/// true pose, if known. At most two thousand instants.
std::string replay_view(const RecordedRun& run) {
  Json view = {{"frames", frames_of(run)},
               {"path", Json::array()},
               {"ramps", Json::array()},
               {"blocks", Json::array()},
               {"surfaces", Json::array()},
               {"robot", robot_of(run.run_context.robot)},
               {"path_histories", Json::array()},
               {"colours", {{"path", kPathColour}, {"truth", kTruthColour}}}};
  for (const PoseSource source : kPoseSources) {
    if (run.result.has_estimate(source)) view["path_histories"].push_back(to_string(source));
    view["colours"][to_string(source)] = colour_of(source);
  }
  if (run.has_truth) view["path_histories"].push_back("truth");
  if (run.run_context.course != nullptr) add_course(*run.run_context.course, view);
  add_extent(run, view);
  return "<figure id='replay'><canvas width='1000' height='520' tabindex='0' "
         "style='width:100%;touch-action:none;border:1px solid #999'></canvas>"
         "<div style='display:flex;gap:.8em;align-items:center'><button type='button'>Play</button>"
         "<input type='range' min='0' step='0.01' value='0' aria-label='time' style='flex:1'>"
         "<output></output><select aria-label='speed'><option value='1'>1 x</option>"
         "<option value='5'>5 x</option><option value='20'>20 x</option></select>"
         "<label><input type='checkbox'>follow</label></div>"
         "<figcaption>Drag to turn, wheel to zoom. The robot is drawn at the steering pose; its "
         "outline on the floor at the true pose, where that is known."
         "</figcaption></figure>\n<script>\n" +
         std::string(kReplayScript) + "tp100Replay(document.getElementById('replay'), " +
         view.dump(-1, ' ', true, Json::error_handler_t::replace) + ");\n</script>\n";
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
  PerSource<Rows> estimates = same_for_all(Rows{kPoseHead});
  Rows tracking = {{"", "max [cm]", "rms [cm]", "yaw max [deg]"}}, estimated = tracking;
  Rows baselines = {kPoseHead};
  Rows jitter = {kDurationHead};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RecordedRun& run = runs[i].run;
    const std::string name = plain(runs[i].name);
    const auto version = run.facts.find("version");
    outcomes.push_back({name, title_of(run), outcome(run), number(run.result.duration_s, 2),
                        count(run.result.link.lost),
                        version == run.facts.end() ? "" : plain(version->second)});
    if (run.runs > 0)
      estimated.push_back({name, number(run.estimated.max_cross_track_m * kCmPerM, 2),
                           number(run.estimated.rms_cross_track_m * kCmPerM, 2),
                           number(run.estimated.max_heading_error_rad * kDegPerRad, 2)});
    jitter.push_back(duration_row(name, run.jitter));
    if (!judged[i]) continue;
    for (const PoseSource source : kPoseSources) {
      const std::optional<PoseErrors>& errors = judged[i]->estimates[source];
      if (errors) estimates[source].push_back(pose_row(name, *errors));
    }
    add_baselines(baselines, name + ": ", *judged[i]);
    tracking.push_back({name, number(judged[i]->tracking.max_cross_track_m * kCmPerM, 2),
                        number(judged[i]->tracking.rms_cross_track_m * kCmPerM, 2),
                        number(judged[i]->tracking.max_yaw_error_rad * kDegPerRad, 2)});
  }
  page.table(outcomes, "The runs");
  page.heading("Errors");
  page.paragraph(
      "Runs whose truth is not known are only in the last table, runs that never began in none.");
  for (const PoseSource source : kPoseSources) {
    if (estimates[source].size() == 1 && needs_camera(source)) continue;
    page.table(estimates[source],
               "The pose '" + std::string(to_string(source)) + "' against the truth" +
                   (blind_to_disturbances(source) ? ", piece by piece between disturbances" : ""));
  }
  if (baselines.size() > 1) page.table(baselines, kBaselinesCaption);
  page.table(tracking, "Tracking: the truth against the path");
  page.table(estimated, "The steering pose against the path: what the controller saw");
  add_figures(page, figures);
  page.heading("Loop");
  page.table(jitter, "Jitter: time between two steps against the period");
  return page.text();
}

}  // namespace tp100::report
