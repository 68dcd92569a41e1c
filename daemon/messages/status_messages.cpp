#include "messages/status_messages.h"

#include "text/json_writer.h"

namespace tp100::messages {
namespace {

// Above this fraction of bad or lost samples in a second, the link is poor.
constexpr double kPoorShare = 0.01;

void write_durations(text::JsonWriter& json, std::string_view name, const Durations& durations) {
  json.key(name).begin_object();
  durations.each([&](const char* key, auto value) { json.field(key, value); });
  json.end_object();
}

void write_counters(text::JsonWriter& json, const LinkCounters& link) {
  json.key("counters").begin_object();
  visit_fields([&](auto name, std::uint64_t count) { json.field(name, count); }, link);
  json.end_object();
}

void write_faults(text::JsonWriter& json, FaultMask faults, FaultMask of_robot) {
  json.key("faults").begin_array();
  while (const auto fault = first_fault(faults)) {
    const FaultText& text = describe(*fault);
    json.begin_object()
        .field("name", text.name)
        .field("cause", text.cause)
        .field("fix", text.fix)
        .field("from", (fault_bit(*fault) & of_robot) != 0 ? "robot" : "daemon")
        .end_object();
    faults &= ~fault_bit(*fault);
  }
  json.end_array();
}

/// A pose on the ground, or nothing.
void write_place(text::JsonWriter& json, std::string_view name, const std::optional<Pose>& pose) {
  if (!pose) return;
  json.key(name)
      .begin_object()
      .field("x_m", pose->x_m)
      .field("y_m", pose->y_m)
      .field("yaw_rad", pose->yaw_rad)
      .end_object();
}

void write_stop(text::JsonWriter& json, const StopFigures& stop, const PublishClock& clock) {
  json.key("stop")
      .begin_object()
      .field("count", stop.count)
      .field("latched", stop.latched)
      .field("by", stop.by);
  if (stop.count != 0) json.field("requested_t_s", clock.t_s(stop.requested_ns));
  json.field("status", to_string(stop.status));
  if (stop.status == StopFigures::Status::kAcknowledged)
    json.field("acknowledged_ms", stop.acknowledged_ms);
  json.end_object();
}

}  // namespace

const char* to_string(StopFigures::Status status) {
  switch (status) {
    case StopFigures::Status::kNone:
      return "none";
    case StopFigures::Status::kPending:
      return "pending";
    case StopFigures::Status::kAcknowledged:
      return "acknowledged";
    case StopFigures::Status::kNotAcknowledged:
      break;
  }
  return "not_acknowledged";
}

const char* link_quality(const LinkFigures& link) {
  if (link.session != SessionState::kReady && link.session != SessionState::kSyncing) return "lost";
  return link.lost_hz + link.bad_hz > kPoorShare * (link.samples_hz + link.lost_hz) ? "poor"
                                                                                    : "good";
}

std::string link_message(double t_s, const LinkFigures& link) {
  std::string text;
  text::JsonWriter json(text);
  json.begin_object()
      .field("t_s", t_s)
      .field("session", to_string(link.session))
      .field("quality", link_quality(link))
      .field("port", link.port.path)
      .field("note", link.port.note);
  if (!link.port.firmware.empty())
    json.field("kind", to_string(link.port.kind)).field("firmware", link.port.firmware);
  json.field("samples_hz", link.samples_hz)
      .field("lost_hz", link.lost_hz)
      .field("bad_hz", link.bad_hz)
      .field("in_bytes_ps", link.in_bytes_ps)
      .field("out_bytes_ps", link.out_bytes_ps);
  if (link.clock.valid) json.field("round_trip_us", 2.0 * link.clock.uncertainty_us);
  json.key("clock")
      .begin_object()
      .field("valid", link.clock.valid)
      .field("drift_ppm", link.clock.drift * 1e6)
      .field("uncertainty_us", link.clock.uncertainty_us)
      .end_object();
  write_durations(json, "sample_age_us", link.sample_age);
  write_counters(json, link.counters);
  json.end_object();
  return text;
}

std::string loop_message(double t_s, const LoopFigures& loop, const RunContext& run_context) {
  std::string text;
  text::JsonWriter json(text);
  json.begin_object()
      .field("t_s", t_s)
      .field("rate_hz", run_context.rate_hz)
      .field("pacing", run_context.pacing)
      .field("cycles", loop.cycles)
      .field("overruns", loop.overruns)
      .field("missed", loop.missed)
      .field("frame_timeouts", loop.frame_timeouts);
  loop.each_time([&](const char* name, const Durations& durations) {
    write_durations(json, name, durations);
  });
  json.key("histogram").begin_object().key("edges_us").begin_array();
  for (const int edge : kLatenessEdgesUs) json.value(edge);
  json.end_array().key("lateness").begin_array();
  for (const std::uint64_t count : loop.lateness_counts) json.value(count);
  json.end_array().end_object().key("privileges").begin_object();
  for (const auto& [name, granted] : loop.privileges) json.field(name, granted);
  json.end_object()
      .field("lost_records", loop.lost_records)
      .field("lost_events", loop.lost_events)
      .end_object();
  return text;
}

std::string state_message(HostNs now, const PublishClock& clock, const StateFigures& state,
                          const RunContext& run_context) {
  std::string text;
  text.reserve(1024);
  text::JsonWriter json(text);
  json.begin_object()
      .field("t_s", clock.t_s(now))
      .field("run", to_string(state.run))
      .field("session", to_string(state.session));
  if (state.robot) json.field("robot_state", to_string(*state.robot));
  json.field("motors_on", state.motors_on)
      .field("run_s", state.run_s)
      .field("progress_m", state.progress_m)
      .field("length_m", state.length_m)
      .field("course", run_context.course == nullptr ? "" : run_context.course->name)
      .field("robot", run_context.robot.name)
      .field("setup", run_context.setup)
      .field("steering", to_string(state.steering))
      .field("world", run_context.world)
      .field("battery_v", state.battery_v);
  write_place(json, "pose", state.pose);
  json.key("can")
      .begin_object()
      .field("start", state.can_start)
      .field("drive", state.why_not_drive.empty())
      .field("pause", state.run == RunState::kRunning)
      .field("resume", state.pause_left_s > 0.0)
      .field("hold", true)
      .field("stop", true)
      .field("record", state.can_record)
      .end_object();
  if (state.pause_left_s > 0.0) json.field("pause_left_s", state.pause_left_s);
  write_place(json, "go_on_from", state.go_on_from);
  json.field("why_not_start", state.why_not_start)
      .field("why_not_drive", state.why_not_drive)
      .field("confirm_start", state.confirm_start)
      .field("watch", run_context.stop_unwatched);
  if (!state.driver.by.empty()) {
    json.key("driver")
        .begin_object()
        .field("by", state.driver.by)
        .field("fresh", state.driver.fresh);
    if (!state.driver.asked_by.empty()) json.field("asked_by", state.driver.asked_by);
    json.end_object();
  }
  write_faults(json, state.faults, state.robot_faults);
  write_stop(json, state.stop, clock);
  json.end_object();
  return text;
}

std::string recording_message(const RecordingFigures& recording) {
  std::string text;
  text::JsonWriter(text)
      .begin_object()
      .field("available", recording.available)
      .field("active", recording.active)
      .field("run", recording.run)
      .field("file", recording.file)
      .field("elapsed_s", recording.elapsed_s)
      .field("bytes", recording.bytes)
      .field("dropped", recording.dropped)
      .field("warning", recording.warning)
      .end_object();
  return text;
}

std::string clients_message(const ClientsFigures& clients) {
  std::string text;
  text::JsonWriter json(text);
  json.begin_object().key("clients").begin_array();
  for (const ClientFigures& client : clients.clients) {
    json.begin_object()
        .field("id", client.id)
        .field("address", client.address)
        .field("agent", client.agent)
        .field("subscriptions", client.subscriptions)
        .field("sent", client.sent)
        .field("dropped", client.dropped)
        .field("queued", client.queued)
        .field("connected_s", client.connected_s)
        .end_object();
  }
  json.end_array()
      .field("dropped_total", clients.dropped_total)
      .field("refused_total", clients.refused_total)
      .field("closed_total", clients.closed_total)
      .field("queue_limit", clients.queue_limit)
      .end_object();
  return text;
}

}  // namespace tp100::messages
