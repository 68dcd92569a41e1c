#include "live/live_cycle.h"

#include <utility>

namespace tp100::live {
namespace {

constexpr HostNs kStatusPeriodNs = 100 * kNsPerMs;

}  // namespace

LiveCycle::LiveCycle(const link::SessionSettings& settings, const bridge::Parameters& parameters,
                     std::shared_ptr<const course::Course> course, bool leave_silent_port)
    : cycle_(settings, parameters, std::move(course)), leave_silent_port_(leave_silent_port) {}

bool LiveCycle::request(OperatorRequest request) {
  if (request == OperatorRequest::kStop) {
    stop_asked_.store(true, std::memory_order_release);
    return true;
  }
  const std::lock_guard lock(asking_);
  return requests_.push({request, false});
}

bool LiveCycle::request_first_start() {
  const std::lock_guard lock(asking_);
  return requests_.push({OperatorRequest::kStart, true});
}

bool LiveCycle::change(const ParameterChange& change) {
  const std::lock_guard lock(asking_);
  return changes_.push(change);
}

bool LiveCycle::take_status(LiveStatus& status) {
  bool any = false;
  while (statuses_.pop(status)) any = true;
  return any;
}

bool LiveCycle::received(std::span<const std::uint8_t> bytes, HostNs now) {
  cycle_.receive(bytes, now);
  received_ns_ = now;
  return cycle_.session().has_samples();
}

void LiveCycle::step(HostNs now) {
  take_inputs();
  cycle_.step(now);
}

void LiveCycle::settle(HostNs now) {
  time_sample(now);
  record();
  pass_events();
  pass_run_state(now);
  publish(now);
}

void LiveCycle::pass_run_state(HostNs now) {
  const Snapshot& snapshot = cycle_.outputs().snapshot;
  const bool changed = snapshot.run_state != run_state_;
  const FaultMask more = snapshot.faults & ~kRobotFaults & ~faults_;
  faults_ = snapshot.faults & ~kRobotFaults;
  if (!changed && (more == 0 || run_state_ != RunState::kAborted)) return;
  if (changed) has_run_.store(true, std::memory_order_release);
  LiveEvent event;
  event.kind = LiveEvent::Kind::kRunState;
  event.at_ns = now;
  event.from = std::exchange(run_state_, snapshot.run_state);
  event.to = run_state_;
  event.faults = changed ? snapshot.faults : more;
  event.refused = cycle_.outputs().refused;
  push(event);
}

void LiveCycle::time_sample(HostNs now) {
  if (cycle_.samples().empty()) return;
  const HostNs measured_ns = cycle_.samples().back().measured_ns;
  sample_times_.wire.add(received_ns_ - measured_ns);
  sample_times_.wait.add(now - received_ns_);
  sample_times_.age.add(now - measured_ns);
}

void LiveCycle::record() {
  if (StepRecord* slot = records_.free_slot()) {
    cycle_.record(*slot);
    records_.publish();
  } else {
    lost_records_.fetch_add(1, std::memory_order_relaxed);
  }
}

void LiveCycle::take_inputs() {
  Asked asked;
  while (requests_.pop(asked)) {
    if (winding_up_ || (asked.only_first && has_run())) continue;
    cycle_.request(asked.request);
  }
  ParameterChange change;
  for (std::size_t i = 0; i < bridge::Cycle::kMaxChanges && changes_.pop(change); ++i)
    cycle_.change(change);
  CameraSample seen;
  for (std::size_t i = 0; i < bridge::Cycle::kMaxCamera && camera_.pop(seen); ++i)
    cycle_.camera(seen);
  WorldSample said;
  for (std::size_t i = 0; i < kWaitingWorld && world_.pop(said); ++i) cycle_.world(said);
  // Last: nothing that was asked in the same step may undo it.
  if (stop_asked_.exchange(false, std::memory_order_acq_rel))
    cycle_.request(OperatorRequest::kStop);
}

void LiveCycle::pass_events() {
  for (const link::SessionEvent& session : cycle_.take_events()) {
    LiveEvent event;
    event.at_ns = session.at_ns;
    event.session = session;
    event.hello = cycle_.session().hello();
    push(event);
    if (session.kind != link::SessionEvent::Kind::kTimeout) continue;
    const bool spoke = session.a != static_cast<std::int32_t>(SessionState::kListening);
    hang_up_ = hang_up_ || spoke || leave_silent_port_;
  }
}

void LiveCycle::push(const LiveEvent& event) {
  if (!events_.push(event)) lost_events_.fetch_add(1, std::memory_order_relaxed);
}

void LiveCycle::publish(HostNs now) {
  if (now < next_status_ns_ && !winding_up_) return;
  next_status_ns_ = now + kStatusPeriodNs;
  const link::Session& session = cycle_.session();
  statuses_.push({session.state(), session.counters(), session.clock(), session.hello(),
                  cycle_.outputs().snapshot});
}

bool LiveCycle::take_hang_up() { return std::exchange(hang_up_, false); }

bool LiveCycle::wind_up(HostNs now) {
  if (!std::exchange(winding_up_, true)) cycle_.disarm(now);
  return !cycle_.request_pending();
}

}  // namespace tp100::live
