#include "messages/prometheus.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "core/faults.h"
#include "core/link_state.h"
#include "core/run_state.h"
#include "text/format.h"

namespace tp100::messages {
namespace {

constexpr double kSPerUs = 1e-6;

using Labels = std::vector<std::pair<std::string_view, std::string_view>>;

/// Builds the text: a family first, then its samples.
class Exposition {
 public:
  void family(std::string_view name, std::string_view type, std::string_view help) {
    name_ = "tp100_" + std::string(name);
    text_ += "# HELP " + name_ + ' ' + std::string(help) + "\n# TYPE " + name_ + ' ' +
             std::string(type) + '\n';
  }
  void sample(double value, const Labels& labels = {}, std::string_view suffix = {}) {
    text_ += name_;
    text_ += suffix;
    char separator = '{';
    for (const auto& [label, content] : labels) {
      text_ += std::exchange(separator, ',');
      text_ += label;
      text_ += "=\"";
      escape(content);
      text_ += '"';
    }
    if (!labels.empty()) text_ += '}';
    text_ += ' ' + text::shortest(value) + '\n';
  }
  void gauge(std::string_view name, std::string_view help, double value) {
    family(name, "gauge", help);
    sample(value);
  }
  void counter(std::string_view name, std::string_view help, std::uint64_t value) {
    family(name, "counter", help);
    sample(static_cast<double>(value));
  }
  std::string take() { return std::move(text_); }

 private:
  void escape(std::string_view content) {
    for (const char c : content) {
      if (c == '\\' || c == '"') text_ += '\\';
      if (c == '\n')
        text_ += "\\n";
      else
        text_ += c;
    }
  }

  std::string name_, text_;
};

void write_run(Exposition& out, const StateFigures& state, const RunContext& run_context) {
  out.family("info", "gauge", "What is in force: version, course, robot and set-up.");
  out.sample(1.0, {{"version", run_context.version},
                   {"course", run_context.course == nullptr ? "" : run_context.course->name},
                   {"robot", run_context.robot.name},
                   {"setup", run_context.setup}});
  out.family("run_state", "gauge", "1 for the state of the run.");
  for (std::uint8_t i = 0; to_string(RunState{i}) != "unknown"; ++i)
    out.sample(RunState{i} == state.run ? 1.0 : 0.0, {{"state", to_string(RunState{i})}});
  out.family("session_state", "gauge", "1 for the state of the link's session.");
  for (const auto& [session, name] : kSessionStateNames)
    out.sample(session == state.session ? 1.0 : 0.0, {{"state", name}});
  out.gauge("motors_on", "1 if the robot is armed or its motors are driven.",
            state.motors_on ? 1.0 : 0.0);
  out.gauge("stop_latched", "1 from a STOP to the next start.", state.stop.latched ? 1.0 : 0.0);
  out.counter("stops_total", "STOPs requested.", state.stop.count);
  out.gauge("progress_meters", "Distance driven along the course.", state.progress_m);
  if (state.battery_v) out.gauge("battery_volts", "Voltage of the battery.", *state.battery_v);
  out.family("fault", "gauge", "1 for a fault that robot or daemon has latched.");
  FaultMask all = ~FaultMask{0};
  while (const auto fault = first_fault(all)) {
    all &= ~fault_bit(*fault);
    const FaultText& row = describe(*fault);
    if (row.fault != *fault) continue;
    out.sample((state.faults & fault_bit(*fault)) != 0 ? 1.0 : 0.0, {{"fault", row.name}});
  }
}

void write_loop(Exposition& out, const LoopFigures& loop) {
  out.counter("loop_cycles_total", "Cycles of the real-time loop.", loop.cycles);
  out.counter("loop_overruns_total", "Cycles that ended after the next one was due.",
              loop.overruns);
  out.counter("loop_missed_total", "Cycles left out because an earlier one took too long.",
              loop.missed);
  out.counter("loop_lost_records_total", "Steps that no consumer took in time.", loop.lost_records);
  out.counter("loop_lost_events_total", "Events that no consumer took in time.", loop.lost_events);
  out.family("loop_lateness_seconds", "histogram", "How late cycles began.");
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < kLatenessEdgesUs.size(); ++i) {
    below += loop.lateness_counts[i];
    const std::string edge = text::number_text(kLatenessEdgesUs[i] * kSPerUs);
    out.sample(static_cast<double>(below), {{"le", edge}}, "_bucket");
  }
  const double all = static_cast<double>(below + loop.lateness_counts.back());
  out.sample(all, {{"le", "+Inf"}}, "_bucket");
  out.sample(loop.lateness.mean_us * kSPerUs * all, {}, "_sum");
  out.sample(all, {}, "_count");
  const auto summary = [&](std::string_view name, std::string_view help, const Durations& of) {
    out.family(name, "summary", help);
    out.sample(of.p50_us * kSPerUs, {{"quantile", "0.5"}});
    out.sample(of.p99_us * kSPerUs, {{"quantile", "0.99"}});
    out.sample(of.p999_us * kSPerUs, {{"quantile", "0.999"}});
    const auto count = static_cast<double>(of.count);
    out.sample(of.mean_us * kSPerUs * count, {}, "_sum");
    out.sample(count, {}, "_count");
  };
  summary("loop_work_seconds", "Time from the start of a cycle's work to its end.", loop.work);
  summary("loop_compute_seconds", "Part of the work that computes.", loop.compute);
  summary("sample_age_seconds", "Time from a sample's measurement to the start of its step.",
          loop.sample_age);
}

void write_link(Exposition& out, const LinkFigures& link) {
  each_counter(link.counters, [&](const char* name, std::uint64_t count) {
    out.counter("link_" + std::string(name) + "_total",
                "Counter " + std::string(name) + " of the link, see channel /link.", count);
  });
  if (!link.clock.valid) return;
  out.gauge("clock_drift_ratio", "Rate of the host's clock over the robot's, minus 1.",
            link.clock.drift);
  out.gauge("clock_uncertainty_seconds", "Uncertainty of the relation between both clocks.",
            link.clock.uncertainty_us * kSPerUs);
}

}  // namespace

std::string prometheus_text(const DaemonMetrics& metrics, const RunContext& run_context) {
  Exposition out;
  write_run(out, metrics.state, run_context);
  write_loop(out, metrics.loop);
  write_link(out, metrics.link);
  out.gauge("recording_active", "1 while a recording is written.",
            metrics.recording.active ? 1.0 : 0.0);
  out.gauge("recording_bytes", "Size of the recording.",
            static_cast<double>(metrics.recording.bytes));
  out.gauge("recording_dropped", "Messages that the recording lacks.",
            static_cast<double>(metrics.recording.dropped));
  out.gauge("viewers", "Connected viewers.", static_cast<double>(metrics.clients.clients.size()));
  out.counter("viewer_messages_dropped_total", "Messages that slow viewers did not get.",
              metrics.clients.dropped_total);
  return out.take();
}

}  // namespace tp100::messages
