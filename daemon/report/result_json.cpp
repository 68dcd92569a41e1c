#include "report/result_json.h"

#include <nlohmann/json.hpp>

namespace tp100::report {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const PoseErrors& errors) {
  return {{"max_position_error_m", errors.max_position_error_m},
          {"mean_position_error_m", errors.mean_position_error_m},
          {"rms_position_error_m", errors.rms_position_error_m},
          {"final_position_error_m", errors.final_position_error_m},
          {"mse_x_m2", errors.mse_x_m2},
          {"mse_y_m2", errors.mse_y_m2},
          {"mse_yaw_rad2", errors.mse_yaw_rad2},
          {"max_yaw_error_rad", errors.max_yaw_error_rad}};
}

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json json_of(const Recovery& recovery) {
  return {{"begin_s", recovery.begin_s},
          {"detection_s", json_of(recovery.detection_s)},
          {"peak_cross_track_m", recovery.peak_cross_track_m},
          {"peak_yaw_error_rad", recovery.peak_yaw_error_rad},
          {"settling_s", json_of(recovery.settling_s)},
          {"overshoot_m", recovery.overshoot_m},
          {"shortcut_m", recovery.shortcut_m}};
}

Json json_of(const TrackingErrors& errors) {
  Json recovery = Json::array();
  for (const std::optional<double>& time : errors.recovery_s) recovery.push_back(json_of(time));
  Json details = Json::array();
  for (const Recovery& one : errors.recovery) details.push_back(json_of(one));
  return {{"max_cross_track_m", errors.max_cross_track_m},
          {"rms_cross_track_m", errors.rms_cross_track_m},
          {"max_yaw_error_rad", errors.max_yaw_error_rad},
          {"recovery_s", recovery},
          {"recovery", details},
          {"false_alarms", errors.false_alarms}};
}

const char* name_of(Slope slope) {
  return slope == Slope::kFlat ? "flat" : slope == Slope::kUp ? "up" : "down";
}

Json json_of(const SlopeFigures& slope) {
  Json changes = Json::array();
  for (const SlopeChange& change : slope.changes)
    changes.push_back(
        {{"at_s", change.at_s}, {"to", name_of(change.to)}, {"found_s", json_of(change.found_s)}});
  return {{"ramp_pitch_max_error_rad", slope.ramp_pitch_max_error_rad},
          {"ramp_pitch_rms_error_rad", slope.ramp_pitch_rms_error_rad},
          {"changes", changes},
          {"false_changes", slope.false_changes},
          {"obstacles", slope.obstacles},
          {"mistaken", slope.mistaken}};
}

Json json_of(const CameraFigures& camera) {
  const double expected = CameraFigures::kNisDegrees;
  const double band = camera.nis_half_band();
  return {{"used", camera.used},
          {"rejected", camera.rejected},
          {"recoveries", camera.recoveries},
          {"nis_mean", camera.nis_mean},
          {"nis_expected", {expected - band, expected + band}}};
}

Json json_of(const LinkCounters& link) {
  Json json;
  each_counter(link, [&](const char* name, std::uint64_t count) { json[name] = count; });
  return json;
}

}  // namespace

std::string result_json(const RunResult& run, const RunFigures& figures) {
  Json json = {{"course", run.course}, {"board", run.board}, {"robot", run.robot},
               {"setup", run.setup},   {"seed", run.seed},   {"completed", run.completed}};
  if (!run.completed) json["cause"] = run.cause;
  json["duration_s"] = run.duration_s;
  json["realtime_factor"] = run.realtime_factor;
  json["model"] = json_of(figures.model);
  json["odometry"] = json_of(figures.odometry);
  if (figures.fused) json["fused"] = json_of(*figures.fused);
  json["tracking"] = json_of(figures.tracking);
  json["slope"] = json_of(figures.slope);
  if (run.has_camera) json["camera"] = json_of(run.camera);
  json["link"] = json_of(run.link);
  json["loop"] = Json::object();
  for (const auto& [name, value] : run.loop) json["loop"][name] = value;
  // Names of files may hold any bytes.
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace tp100::report
