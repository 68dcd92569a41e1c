#include "live/stats_file.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/arithmetic.h"
#include "core/board.h"
#include "core/error.h"
#include "core/fields.h"
#include "live/live_events.h"
#include "text/atomic_file.h"
#include "text/format.h"

namespace tp100::live {
namespace {

using Json = nlohmann::ordered_json;

Json loop_figures(const messages::LoopFigures& loop) {
  Json json = {{"cycles", loop.cycles},
               {"overruns", loop.overruns},
               {"missed", loop.missed},
               {"frame_timeouts", loop.frame_timeouts},
               {"lost_records", loop.lost_records},
               {"lost_events", loop.lost_events}};
  loop.each_time([&](const char* name, const messages::Durations& of) { json[name] = of; });
  Json privileges = Json::object();
  for (const auto& [name, granted] : loop.privileges) privileges[name] = granted;
  json["privileges"] = std::move(privileges);
  return json;
}

Json pose(const Pose& pose) {
  return {{"x_m", pose.x_m}, {"y_m", pose.y_m}, {"yaw_rad", pose.yaw_rad}};
}

Json camera_figures(const CameraFigures& camera, const FilterFigures& fused) {
  Json json = object_of<Json>(camera.detections);
  json.update({{"used", fused.camera_used},
               {"rejected", fused.camera_rejected},
               {"recoveries", fused.recoveries},
               {"nis_mean", fused.nis_mean},
               {"images", object_of<Json>(camera.images)}});
  return json;
}

Json recording_figures(const messages::RecordingFigures& recording, double cpu_s) {
  return {{"file", recording.file},           {"active", recording.active},
          {"elapsed_s", recording.elapsed_s}, {"bytes", recording.bytes},
          {"dropped", recording.dropped},     {"cpu_s", cpu_s},
          {"warning", recording.warning}};
}

Json world_figures(const WorldFigures& world) {
  Json json = {{"kind", world.udp ? "udp" : "files"}};
  if (world.udp) {
    json["udp"] = object_of<Json>(*world.udp);
    json["udp"]["strangers"] = world.strangers;
  }
  if (world.files) json["files"] = object_of<Json>(*world.files);
  return json;
}

Json fault_list(FaultMask faults) {
  Json names = Json::array();
  each_fault(faults, [&](Fault fault) { names.push_back(describe(fault).name); });
  return names;
}

std::string stats_json(const DaemonFigures& figures) {
  const LiveStatus& status = figures.status;
  const Snapshot& snapshot = status.snapshot;
  Json json = {
      {"result", figures.result},
      {"completed", figures.result == "completed"},
      {"duration_s", figures.duration_s},
      {"course", figures.run->course()},
      {"robot", figures.run->loaded.setup.robot.name},
      {"setup", bridge::to_string(figures.run->loaded.setup.parameters.setup)},
      {"port", figures.port},
      {"page", figures.page},
      {"faults", fault_list(figures.faults)},
      {"session", to_string(status.session)},
      {"run", to_string(snapshot.run_state)},
      {"firmware", firmware_text(status.hello)},
      {"progress_m", snapshot.progress_m},
      {"battery_v", snapshot.sample.battery_v},
      {"link", object_of<Json>(status.counters)},
      {"clock",
       {{"valid", status.clock.valid},
        {"drift_ppm", status.clock.drift * 1e6},
        {"uncertainty_us", status.clock.uncertainty_us}}},
      {"loop", loop_figures(figures.loop)},
  };
  for (const PoseSource source : kPoseSources)
    json[to_string(source)] = pose(snapshot.estimates[source].pose);
  const auto& [camera, world] = figures.inputs;
  if (camera) json["camera"] = camera_figures(*camera, snapshot.filter);
  if (world.udp || world.files) json["world"] = world_figures(world);
  if (!figures.recording.file.empty())
    json["recording"] = recording_figures(figures.recording, figures.recording_cpu_s);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

void StatsFile::write(const DaemonFigures& figures) {
  if (path_.empty()) return;
  std::string text = stats_json(figures);
  if (!std::exchange(begun_, true)) return text::write_file(path_, text, text::Flush::kNo);
  const std::lock_guard lock(state_->mutex);
  state_->text = std::move(text);
  if (state_->writing) return;
  const auto write_newest = [path = path_, state = state_] {
    for (;;) {
      std::unique_lock lock_inside(state->mutex);
      const std::optional<std::string> next = std::exchange(state->text, std::nullopt);
      state->writing = next.has_value();
      if (!next) return;
      lock_inside.unlock();
      text::write_file(path, *next, text::Flush::kNo);
    }
  };
  // A disk that fills up during a run does not end the run.
  const auto failed = [state = state_, &events = events_](const std::string& why) {
    const std::lock_guard lock_inside(state->mutex);
    state->writing = false;
    if (!std::exchange(state->failed, true)) events.note(why);
  };
  state_->writing = disk_.post(write_newest, failed);
}

std::string summary_text(const DaemonFigures& figures) {
  const Snapshot& snapshot = figures.status.snapshot;
  const Pose& pose = snapshot.estimates[PoseSource::kOdometry].pose;
  const LinkCounters& link = figures.status.counters;
  const std::string course = figures.run->course();
  std::string lines =
      (course.empty() ? "no course" : course) + ": " + figures.result +
      text::format(" after %.1f s at x %.3f m, y %.3f m, yaw %.1f deg; %s, %llu lost",
                   figures.duration_s, pose.x_m, pose.y_m, pose.yaw_rad * kDegPerRad,
                   text::counted(link.samples, "sample").c_str(),
                   static_cast<unsigned long long>(link.lost));
  if (!figures.recording.file.empty())
    lines += "\nrecording: " + figures.recording.file +
             text::format(", %.1f MB", static_cast<double>(figures.recording.bytes) * 1e-6);
  if (figures.faults != 0) lines += "\nfaults: " + fault_names(figures.faults);
  return lines;
}

}  // namespace tp100::live
