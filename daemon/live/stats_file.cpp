#include "live/stats_file.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/arithmetic.h"
#include "core/error.h"
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

Json link_figures(const LinkCounters& link) {
  Json json;
  visit_fields([&](auto name, std::uint64_t count) { json[name] = count; }, link);
  return json;
}

Json intake_figures(const link::CameraCounters& intake) {
  return {
      {"received", intake.received}, {"accepted", intake.accepted}, {"malformed", intake.malformed},
      {"late", intake.late},         {"early", intake.early},       {"foreign", intake.foreign},
      {"missing", intake.missing},   {"dropped", intake.dropped},   {"streams", intake.streams}};
}

Json camera_figures(const CameraFigures& camera, const FilterFigures& fused) {
  Json json = intake_figures(camera.detections);
  json.update({{"used", fused.camera_used},
               {"rejected", fused.camera_rejected},
               {"recoveries", fused.recoveries},
               {"nis_mean", fused.nis_mean},
               {"images", intake_figures(camera.images)}});
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
    const worlds::PeerCounters& udp = *world.udp;
    json["udp"] = {{"hellos", udp.hellos},
                   {"poses", udp.poses},
                   {"answered", udp.answered},
                   {"received", udp.received},
                   {"accepted", udp.accepted},
                   {"malformed", udp.malformed},
                   {"wrong_version", udp.wrong_version},
                   {"foreign", udp.foreign},
                   {"strangers", world.strangers},
                   {"reordered", udp.reordered},
                   {"back_in_time", udp.back_in_time},
                   {"unknown_ack", udp.unknown_ack},
                   {"missing", udp.missing},
                   {"unknown_surface", udp.unknown_surface},
                   {"dropped", udp.dropped},
                   {"sessions", udp.sessions},
                   {"losses", udp.losses},
                   {"round_trip_ms", udp.round_trip_ms},
                   {"mean_round_trip_ms", udp.mean_round_trip_ms},
                   {"max_round_trip_ms", udp.max_round_trip_ms}};
  }
  if (world.files) {
    json["files"] = {{"written", world.files->written},
                     {"write_errors", world.files->write_errors},
                     {"read", world.files->read},
                     {"rejected", world.files->rejected},
                     {"dropped", world.files->dropped}};
  }
  return json;
}

Json fault_list(FaultMask faults) {
  Json names = Json::array();
  while (const auto fault = first_fault(faults)) {
    names.push_back(describe(*fault).name);
    faults &= ~fault_bit(*fault);
  }
  return names;
}

}  // namespace

std::string stats_json(const DaemonFigures& figures) {
  const LiveStatus& status = figures.status;
  const Snapshot& snapshot = status.snapshot;
  Json json = {
      {"result", figures.result},
      {"completed", figures.result == "completed"},
      {"duration_s", figures.duration_s},
      {"course", figures.course},
      {"robot", figures.robot},
      {"setup", figures.setup},
      {"port", figures.port},
      {"page", figures.page},
      {"faults", fault_list(figures.faults)},
      {"session", to_string(status.session)},
      {"run", to_string(snapshot.run_state)},
      {"firmware", std::to_string(status.hello.firmware[0]) + "." +
                       std::to_string(status.hello.firmware[1]) + "." +
                       std::to_string(status.hello.firmware[2])},
      {"progress_m", snapshot.progress_m},
      {"battery_v", snapshot.sample.battery_v},
      {"link", link_figures(status.counters)},
      {"clock",
       {{"valid", status.clock.valid},
        {"drift_ppm", status.clock.drift * 1e6},
        {"uncertainty_us", status.clock.uncertainty_us}}},
      {"loop", loop_figures(figures.loop)},
  };
  for (const PoseSource source : kPoseSources)
    json[to_string(source)] = pose(snapshot.estimates[source].pose);
  if (figures.camera) json["camera"] = camera_figures(*figures.camera, snapshot.filter);
  if (figures.world.udp || figures.world.files) json["world"] = world_figures(figures.world);
  if (!figures.recording.file.empty())
    json["recording"] = recording_figures(figures.recording, figures.recording_cpu_s);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

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
  std::string lines =
      (figures.course.empty() ? "no course" : figures.course) + ": " + figures.result +
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
