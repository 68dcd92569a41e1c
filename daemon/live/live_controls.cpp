#include "live/live_controls.h"

#include <utility>

#include "live/parameter_list.h"

namespace tp100::live {
namespace {

constexpr const char* kBusy = "too many requests wait; try again";

}  // namespace

messages::Durations durations(const loop::Histogram& histogram) {
  const auto us = [&](double fraction) {
    return static_cast<double>(histogram.percentile(fraction)) * 1e-3;
  };
  return {.count = histogram.count(),
          .mean_us = histogram.mean() * 1e-3,
          .p50_us = us(0.5),
          .p99_us = us(0.99),
          .p999_us = us(0.999),
          .max_us = static_cast<double>(histogram.max()) * 1e-3};
}

std::string LiveControls::start() {
  const std::lock_guard lock(mutex_);
  if (ending_) return "the daemon ends";
  return cycle_.request(OperatorRequest::kStart) ? std::string() : kBusy;
}

std::string LiveControls::hold() {
  return cycle_.request(OperatorRequest::kHold) ? std::string() : kBusy;
}

void LiveControls::stop() { cycle_.request(OperatorRequest::kStop); }

std::string LiveControls::set(const messages::ParameterText& parameter,
                              const messages::ParameterValue& value) {
  const auto change = change_for(parameter, value);
  if (!change) return parameter.name + " cannot be changed while the daemon runs";
  return cycle_.change(*change) ? std::string() : kBusy;
}

// Viewers need not know where the runs lie.
messages::RecordingFigures LiveControls::recording() {
  messages::RecordingFigures figures = recording_.figures();
  const std::size_t folder = figures.file.rfind(figures.run + '/');
  if (figures.run.empty() || folder == std::string::npos) return figures;
  const std::string before = figures.file.substr(0, folder);
  if (figures.warning.starts_with(before)) figures.warning.erase(0, folder);
  figures.file.erase(0, folder);
  return figures;
}

// The answers may come when these controls are gone, but never after the recording.
void LiveControls::record_start(const std::string& name, RecordAnswer answer) {
  recording_.start(name, [&recording = recording_, answer](const std::string& why) {
    answer(why, recording.figures());
  });
}

void LiveControls::record_stop(RecordAnswer answer) {
  recording_.stop(0, [&recording = recording_, answer](const std::string& why) {
    answer(why, recording.figures());
  });
}

messages::LoopFigures LiveControls::loop() {
  const loop::LoopStatistics& statistics = loop_.statistics();
  messages::LoopFigures out;
  out.turns = statistics.turns.load();
  out.overruns = statistics.overruns.load();
  out.missed = statistics.missed.load();
  out.without_frame = statistics.without_frame.load();
  out.lateness = durations(statistics.lateness);
  out.work = durations(statistics.work);
  out.compute = durations(statistics.compute);
  out.write = durations(statistics.write);
  out.sample_wire = durations(cycle_.sample_times().wire);
  out.sample_wait = durations(cycle_.sample_times().wait);
  out.sample_age = durations(cycle_.sample_times().age);
  out.lost_records = cycle_.lost_records();
  out.lost_events = cycle_.lost_events();
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < messages::kLatenessEdgesUs.size(); ++i) {
    const auto edge_ns = static_cast<std::uint64_t>(messages::kLatenessEdgesUs[i]) * 1000U;
    const std::uint64_t upto = std::max(below, statistics.lateness.count_below(edge_ns));
    out.lateness_counts[i] = upto - std::exchange(below, upto);
  }
  const std::uint64_t all = statistics.lateness.count();
  out.lateness_counts.back() = all > below ? all - below : 0;
  const std::lock_guard lock(mutex_);
  out.privileges = privileges_;
  return out;
}

messages::PortFigures LiveControls::port() {
  const std::lock_guard lock(mutex_);
  return port_;
}

void LiveControls::set_port(messages::PortFigures port) {
  const std::lock_guard lock(mutex_);
  port_ = std::move(port);
}

void LiveControls::set_start(const StartFacts& facts) {
  const std::lock_guard lock(mutex_);
  start_ = facts;
}

StartConsent LiveControls::start_consent() {
  const std::lock_guard lock(mutex_);
  StartFacts facts = start_;
  facts.has_run = cycle_.has_run();
  return tp100::start_consent(facts);
}

void LiveControls::set_grants(const std::vector<loop::Grant>& grants) {
  const std::lock_guard lock(mutex_);
  for (const loop::Grant& grant : grants) privileges_.emplace_back(grant.what, grant.granted);
}

void LiveControls::end() {
  const std::lock_guard lock(mutex_);
  ending_ = true;
}

}  // namespace tp100::live
