#include "report/result_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/arithmetic.h"
#include "core/fields.h"
#include "core/limits.h"
#include "text/format.h"

namespace tp100::report {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const TrackingErrors& errors) {
  Json recovery = Json::array(), details = Json::array();
  for (const DisturbanceResponse& one : errors.recovery) {
    details.push_back(object_of<Json>(one));
    recovery.push_back(details.back()["settling_s"]);
  }
  return {{"max_cross_track_m", errors.max_cross_track_m},
          {"rms_cross_track_m", errors.rms_cross_track_m},
          {"max_yaw_error_rad", errors.max_yaw_error_rad},
          {"recovery_s", recovery},
          {"recovery", details},
          {"false_alarms", errors.false_alarms}};
}

Json json_of(const CameraFigures& camera) {
  const double expected = kNisDegrees;
  const double band = camera.nis_half_band();
  return {{"used", camera.used},
          {"rejected", camera.rejected},
          {"recoveries", camera.recoveries},
          {"nis_mean", camera.nis_mean},
          {"nis_expected", {expected - band, expected + band}}};
}

Json json_of(const RunResult& run, const RunFigures& figures) {
  Json json = {{"course", run.course}, {"board", run.board}, {"robot", run.robot},
               {"setup", run.setup},   {"seed", run.seed},   {"completed", run.completed}};
  if (!run.body.empty()) json["body"] = run.body;
  if (!run.floor.empty()) json["floor"] = run.floor;
  if (!run.completed) json["cause"] = run.cause;
  json["duration_s"] = run.duration_s;
  json["realtime_factor"] = run.realtime_factor;
  for (const PoseSource source : kPoseSources) {
    if (!run.has_estimate(source)) continue;
    const std::optional<PoseErrors>& errors = figures.estimates[source];
    Json& of_source = json[to_string(source)];
    if (!errors || run.points.empty()) continue;
    of_source = object_of<Json>(*errors);
    if (const std::optional<Coverage>& within = figures.within_2_sd[source])
      of_source["within_2_sd"] = {{"position", within->position}, {"yaw", within->yaw}};
  }
  json["baselines"] = Json::object();
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i)
    if (figures.baselines[i])
      json["baselines"][model::kBaselines[i].key] = object_of<Json>(*figures.baselines[i]);
  json["tracking"] = json_of(figures.tracking);
  if (run.points.empty())
    for (const char* name : {"baselines", "tracking"}) json[name] = nullptr;
  if (run.has_camera) json["camera"] = json_of(run.camera);
  json["link"] = object_of<Json>(run.link);
  json["loop"] = Json::object();
  for (const auto& [name, value] : run.loop) json["loop"][name] = value;
  return json;
}

}  // namespace

// File names may contain any bytes.
std::string result_json(const RunResult& run, const RunFigures& figures) {
  return json_of(run, figures).dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::optional<RunFigures> judged(const RecordedRun& run) {
  if (run.runs == 0 || !run.has_truth || run.run_context.course == nullptr) return std::nullopt;
  return figures(run.result, *run.run_context.course);
}

Difference model_from_odometry(const RecordedRun& run) {
  Difference difference;
  for (const TrajectoryPoint& point : run.result.points) {
    const Pose& model = point.estimates[PoseSource::kModel];
    const Pose& odometry = point.estimates[PoseSource::kOdometry];
    difference.final_m = magnitude(model.x_m - odometry.x_m, model.y_m - odometry.y_m);
    difference.max_m = std::max(difference.max_m, difference.final_m);
  }
  return difference;
}

std::string metrics_json(const RecordedRun& run, const std::optional<RunFigures>& figures) {
  Json json = json_of(run.result, figures.value_or(RunFigures{}));
  json.erase("realtime_factor");
  json.erase("loop");
  if (!figures)
    for (const char* name : {"baselines", "tracking"}) json[name] = nullptr;
  json["truth"] = run.has_truth;
  json["steering"] = to_string(run.run_context.steering);
  json["estimated"] = nullptr;
  json["differences"] = nullptr;
  if (run.runs > 0) {
    json["estimated"] = {{"max_cross_track_m", run.estimated.max_cross_track_m},
                         {"rms_cross_track_m", run.estimated.rms_cross_track_m},
                         {"max_heading_error_rad", run.estimated.max_heading_error_rad}};
    const Difference difference = model_from_odometry(run);
    json["differences"] = {
        {"model_from_odometry", {{"max_m", difference.max_m}, {"final_m", difference.final_m}}}};
  }
  json["timing"] = {{"rate_hz", run.run_context.rate_hz},
                    {"jitter_us", run.jitter},
                    {"sample_age_us", run.sample_age},
                    {"world_age_us", run.world_age.count > 0 ? Json(run.world_age) : Json()}};
  json["recording"] = {{"file", run.path},
                       {"whole", run.whole},
                       {"runs", run.runs},
                       {"steps", run.steps},
                       {"missing_steps", run.missing_steps},
                       {"implausible_points", run.implausible},
                       {"points_of_every", run.every}};
  json["versions"] = Json::object();
  for (const char* name : {"program", "version", "start_unix_ns"})
    if (run.facts.contains(name)) json["versions"][name] = run.facts.at(name);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

namespace {

using text::format;

std::string row(const std::string& name, const PoseErrors& e) {
  return format("%-27s%8.2f%8.2f%8.2f%8.2f%11.2e%11.2e%11.2e%8.2f\n", name.c_str(),
                e.max_position_error_m * kCmPerM, e.mean_position_error_m * kCmPerM,
                e.rms_position_error_m * kCmPerM, e.final_position_error_m * kCmPerM, e.mse_x_m2,
                e.mse_y_m2, e.mse_yaw_rad2, e.max_yaw_error_rad * kDegPerRad);
}

std::string seconds(const std::optional<double>& time) {
  return time ? format("%10.2f", *time) : format("%10s", "never");
}

std::string recovery_rows(const TrackingErrors& tracking) {
  if (tracking.recovery.empty()) return {};
  std::string text =
      format("\n%-34s%9s%10s%10s%10s%12s%10s\n", "ours: each disturbance, until back", "noticed",
             "peak", "peak", "back", "overshoot", "shortcut");
  const std::string back = format("inside %.0f cm and %.0f deg for %.1f s", kRecoveredM * kCmPerM,
                                  kRecoveredRad * kDegPerRad, kRecoveredForS);
  text += format("%-33s%10s%10s%10s%10s%12s%10s\n", back.c_str(), "[s]", "[cm]", "[deg]", "[s]",
                 "[cm]", "[cm]");
  for (const DisturbanceResponse& one : tracking.recovery) {
    text += format("  disturbance at %5.1f s%9s", one.begin_s, "") + seconds(one.detection_s);
    text += format("%10.2f%10.1f", one.peak_cross_track_m * kCmPerM,
                   one.peak_yaw_error_rad * kDegPerRad);
    text += seconds(one.settling_s);
    text += format("%12.2f%10.2f\n", one.overshoot_m * kCmPerM, one.shortcut_m * kCmPerM);
  }
  return text;
}

std::string coverage_row(const PerSource<std::optional<Coverage>>& within) {
  std::string text;
  for (const PoseSource source : kPoseSources)
    if (within[source])
      text += (text.empty() ? "" : ", ") + std::string(to_string(source)) +
              format(" %.0f and %.0f %%", 100.0 * within[source]->position,
                     100.0 * within[source]->yaw);
  return text.empty() ? text : "true pose within 2 sd, x and y, and yaw: " + text + "\n";
}

std::string camera_row(const CameraFigures& camera) {
  return "camera: " + text::counted(camera.used, "sample") +
         format(" used, %u refused; normalized innovation squared %.2f of %.0f\n", camera.rejected,
                camera.nis_mean, kNisDegrees);
}

}  // namespace

std::string result_table(const RunResult& run, const RunFigures& figures) {
  std::string text = format("Course %.40s, robot %.40s, set-up %.20s, board %.20s, seed %llu: ",
                            run.course.c_str(), run.robot.c_str(), run.setup.c_str(),
                            run.board.c_str(), static_cast<unsigned long long>(run.seed));
  text += run.completed ? format("completed") : "NOT completed (" + run.cause + ")";
  text +=
      format("\n%.1f s of robot time, %.0f x real time\n\n", run.duration_s, run.realtime_factor);
  if (run.points.empty()) return text + "The run never began: there is nothing to judge.\n";
  text += format("%-27s%32s%33s%8s\n", "", "position error [cm]", "mean squared error", "yaw");
  text += format("%-27s%8s%8s%8s%8s%11s%11s%11s%8s\n", "against the true pose", "max", "mean",
                 "rms", "final", "x [m^2]", "y [m^2]", "[rad^2]", "max deg");
  for (const PoseSource source : kPoseSources) {
    const std::optional<PoseErrors>& errors = figures.estimates[source];
    if (!errors) continue;
    text +=
        row("ours: " + std::string(to_string(source)) + " (" + std::string(inputs_of(source)) + ")",
            *errors);
  }
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i)
    if (figures.baselines[i])
      text += row("form: " + std::string(model::kBaselines[i].key), *figures.baselines[i]);
  const TrackingErrors& tracking = figures.tracking;
  text += format(
      "\nours: true path against the reference [cm, deg]: cross-track max %.2f, rms %.2f, yaw max "
      "%.1f\n",
      tracking.max_cross_track_m * kCmPerM, tracking.rms_cross_track_m * kCmPerM,
      tracking.max_yaw_error_rad * kDegPerRad);
  text += recovery_rows(tracking);
  text += coverage_row(figures.within_2_sd);
  if (run.has_camera) text += camera_row(run.camera);
  text += "link: " + text::counted(run.link.samples, "sample") +
          format(", %llu lost, %llu with a wrong CRC\n\n",
                 static_cast<unsigned long long>(run.link.lost),
                 static_cast<unsigned long long>(run.link.crc_errors));
  if (std::ranges::any_of(figures.baselines, [](const auto& errors) { return errors.has_value(); }))
    text += "Forms are simpler models on the same counts and gyro: daemon/REFERENCE.md.\n";
  if (!run.disturbances.empty())
    text +=
        "Model and forms are judged between the disturbances and reset to the truth after each,\n"
        "because encoders cannot measure them; the model's standard deviations up to the first "
        "one.\n";
  if (run.setup == "stand")
    text +=
        "On a stand nothing moves: the virtual pose stands in for the truth and is judged against "
        "itself.\nOnly completion and tracking are meaningful here.\n";
  if (run.robot == "end-loaded")
    text +=
        "This robot's slip is fitted through its contacts and its tracks make eqs 1-5 nearly "
        "exact;\nthe uniformly loaded robot is the harder test.\n";
  return text;
}

}  // namespace tp100::report
