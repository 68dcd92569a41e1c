#include "messages/status_messages.h"

#include "text/json_writer.h"

namespace tp100::messages {
namespace {

// Above this fraction of bad or lost samples in a second, the link is poor.
constexpr double kPoorShare = 0.01;

void write_durations(text::JsonWriter& json, std::string_view name, const Durations& durations) {
  json.object(
      name, [&] { durations.each([&](const char* key, auto value) { json.field(key, value); }); });
}

void write_faults(text::JsonWriter& json, FaultMask faults, FaultMask of_robot) {
  json.key("faults").begin_array();
  each_fault(faults, [&](Fault fault) {
    const FaultText& text = describe(fault);
    json.begin_object()
        .field("name", text.name)
        .field("cause", text.cause)
        .field("fix", text.fix)
        .field("from", (fault_bit(fault) & of_robot) != 0 ? "robot" : "daemon")
        .end_object();
  });
  json.end_array();
}

/// A pose on the ground, or nothing.
void write_place(text::JsonWriter& json, std::string_view name, const std::optional<Pose>& pose) {
  if (!pose) return;
  json.object(name, [&] { json.floor_pose(*pose); });
}

void write_stop(text::JsonWriter& json, const StopFigures& stop, const PublishClock& clock) {
  json.field("count", stop.count).field("latched", stop.latched).field("by", stop.by);
  if (stop.count != 0) json.field("requested_t_s", clock.t_s(stop.requested_ns));
  json.field("status", name_in(kStopStatusNames, stop.status));
  if (stop.status == StopFigures::Status::kAcknowledged)
    json.field("acknowledged_ms", stop.acknowledged_ms);
}

}  // namespace

const char* link_quality(const LinkFigures& link) {
  if (link.session != SessionState::kReady && link.session != SessionState::kSyncing) return "lost";
  return link.lost_hz + link.bad_hz > kPoorShare * (link.samples_hz + link.lost_hz) ? "poor"
                                                                                    : "good";
}

std::string link_message(double t_s, const LinkFigures& link) {
  return text::json_object([&](text::JsonWriter& json) {
    json.field("t_s", t_s)
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
    json.object("clock", [&] {
      json.field("valid", link.clock.valid)
          .field("drift_ppm", link.clock.drift * 1e6)
          .field("uncertainty_us", link.clock.uncertainty_us);
    });
    write_durations(json, "sample_age_us", link.sample_age);
    json.object("counters", [&] { json.fields(link.counters); });
  });
}

std::string loop_message(double t_s, const LoopFigures& loop, const RunContext& run_context) {
  return text::json_object([&](text::JsonWriter& json) {
    json.field("t_s", t_s)
        .field("rate_hz", run_context.rate_hz)
        .field("pacing", run_context.pacing)
        .field("cycles", loop.cycles)
        .field("overruns", loop.overruns)
        .field("missed", loop.missed)
        .field("frame_timeouts", loop.frame_timeouts);
    loop.each_time([&](const char* name, const Durations& durations) {
      write_durations(json, name, durations);
    });
    json.object("histogram", [&] {
      json.values("edges_us", kLatenessEdgesUs).values("lateness", loop.lateness_counts);
    });
    json.object("privileges", [&] {
      for (const auto& [name, granted] : loop.privileges) json.field(name, granted);
    });
    json.field("lost_records", loop.lost_records).field("lost_events", loop.lost_events);
  });
}

std::string state_message(HostNs now, const PublishClock& clock, const StateFigures& state,
                          const RunContext& run_context) {
  return text::json_object([&](text::JsonWriter& json) {
    json.field("t_s", clock.t_s(now))
        .field("run", to_string(state.run))
        .field("session", to_string(state.session));
    if (state.robot) json.field("robot_state", to_string(*state.robot));
    json.field("motors_on", state.motors_on)
        .field("run_s", state.run_s)
        .field("largest_m", state.largest_m)
        .field("progress_m", state.progress_m)
        .field("length_m", state.length_m)
        .field("course", run_context.course == nullptr ? "" : run_context.course->name)
        .field("robot", run_context.robot.name)
        .field("setup", run_context.setup)
        .field("steering", to_string(state.steering))
        .field("world", run_context.world)
        .field("battery_v", state.battery_v);
    write_place(json, "pose", state.pose);
    json.object("can", [&] {
      json.field("start", state.can_start)
          .field("drive", state.why_not_drive.empty())
          .field("pause", state.run == RunState::kRunning)
          .field("resume", state.pause_left_s > 0.0)
          .field("hold", true)
          .field("stop", true)
          .field("record", state.can_record);
    });
    if (state.pause_left_s > 0.0) json.field("pause_left_s", state.pause_left_s);
    if (state.start_places.asks())
      json.object("continue_from", [&] {
        json.floor_pose(*state.pose)
            .field("progress_m", state.onward_m)
            .field("why_not_placed", to_string(state.start_places.placed))
            .field("why_not_here", to_string(state.start_places.here));
      });
    json.field("why_not_start", state.why_not_start)
        .field("why_not_drive", state.why_not_drive)
        .field("confirm_start", state.confirm_start)
        .field("watch", run_context.stop_unwatched);
    if (!state.driver.by.empty())
      json.object("driver", [&] {
        json.field("by", state.driver.by).field("fresh", state.driver.fresh);
        if (!state.driver.asked_by.empty()) json.field("asked_by", state.driver.asked_by);
      });
    write_faults(json, state.faults, state.robot_faults);
    json.object("stop", [&] { write_stop(json, state.stop, clock); });
  });
}

std::string recording_message(const RecordingFigures& recording) {
  return text::json_object([&](text::JsonWriter& json) { json.fields(recording); });
}

std::string clients_message(const ClientsFigures& clients) {
  return text::json_object([&](text::JsonWriter& json) {
    json.objects("clients", clients.clients,
                 [&](const ClientFigures& client) { json.fields(client); });
    json.field("dropped_total", clients.dropped_total)
        .field("refused_total", clients.refused_total)
        .field("closed_total", clients.closed_total)
        .field("queue_limit", clients.queue_limit);
  });
}

}  // namespace tp100::messages
