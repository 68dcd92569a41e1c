#include "live/live_cycle.h"

#include <utility>

namespace tp100::live {
namespace {

constexpr HostNs kStatusPeriodNs = 100 * kNsPerMs;

}  // namespace

LiveCycle::LiveCycle(const link::SessionSettings& settings, const bridge::Parameters& parameters,
                     std::shared_ptr<const course::Course> course, bool leave_silent_port)
    : cycle_(settings, parameters, std::move(course)), leave_silent_port_(leave_silent_port) {}

// Counted first: a consent from before this STOP, still in the queue, does not count any more.
void LiveCycle::stop() {
  consents_.press_stop();
  stop_asked_.store(true, std::memory_order_release);
}

bool LiveCycle::request(OperatorRequest request, const Consent& consent) {
  const std::lock_guard lock(asking_);
  return requests_.push({request, consent});
}

bool LiveCycle::change(const ParameterChange& change) {
  const std::lock_guard lock(asking_);
  return changes_.push(change);
}

bool LiveCycle::velocity(const VelocityInput& input) {
  const std::lock_guard lock(asking_);
  return velocities_.push(input);
}

bool LiveCycle::take_status(LiveStatus& status) {
  bool any = false;
  while (statuses_.pop(status)) any = true;
  return any;
}

bool LiveCycle::received(std::span<const std::uint8_t> bytes, HostNs now) {
  cycle_.session().receive(bytes, now);
  received_ns_ = now;
  return cycle_.session().has_samples();
}

void LiveCycle::step(HostNs now) {
  const bool pressed = take_inputs(now);
  // A STOP that nobody pressed: an external world's, or of motors that run unasked.
  if (cycle_.step(now).request == RobotRequest::kStop && !pressed) consents_.press_stop();
}

void LiveCycle::wrote(HostNs) {
  if (first_records_ != nullptr) record(*first_records_);
}

void LiveCycle::after_write(HostNs now) {
  // Before anybody can read the record.
  shown_places_.store(cycle_.outputs().snapshot.start_places, std::memory_order_release);
  time_sample(now);
  if (!record(records_)) lost_records_.fetch_add(1, std::memory_order_relaxed);
  pass_events();
  pass_run_state(now);
  publish(now);
}

void LiveCycle::pass_run_state(HostNs now) {
  const Snapshot& snapshot = cycle_.outputs().snapshot;
  const bool changed = snapshot.run_state != run_state_;
  const FaultMask more = snapshot.faults & ~kRobotFaults & ~faults_;
  faults_ = snapshot.faults & ~kRobotFaults;
  const StartRefusal refused = cycle_.outputs().refused;
  const bool more_faults = more != 0 && run_state_ == RunState::kAborted;
  if (!changed && !more_faults && refused == StartRefusal::kNone) return;
  if (changed) {
    consents_.set_ran();
    shown_run_state_.store(snapshot.run_state, std::memory_order_release);
  }
  push(RunChange{.at_ns = now,
                 .from = std::exchange(run_state_, snapshot.run_state),
                 .to = snapshot.run_state,
                 .faults = changed ? snapshot.faults : more,
                 .refused = refused,
                 .place = snapshot.world,
                 .progress_m = snapshot.progress_m});
}

void LiveCycle::time_sample(HostNs now) {
  if (cycle_.inputs().samples.empty()) return;
  const HostNs measured_ns = cycle_.inputs().samples.back().measured_ns;
  sample_latency_.wire.add(received_ns_ - measured_ns);
  sample_latency_.wait.add(now - received_ns_);
  sample_latency_.age.add(now - measured_ns);
}

bool LiveCycle::record(loop::SlotRing<StepRecord>& ring) {
  StepRecord* slot = ring.free_slot();
  if (slot == nullptr) return false;
  cycle_.record(*slot);
  ring.publish();
  return true;
}

// Before the requests of the same step, and never in a step that has any: a start that was pressed
// for the old course must not begin the new one.
void LiveCycle::take_setup(HostNs now) {
  SetupRequest* request = setup_asked_.load(std::memory_order_acquire);
  if (request == nullptr) return;
  const bool given_up = shutting_down_ || under_way(run_state_) || now > request->until_ns;
  if (!given_up) {
    if (requests_.read_available() > 0 || stop_asked_.load(std::memory_order_acquire)) return;
    if (!cycle_.change_setup(request->change, now)) return;
    request->made = true;
    request->step = cycle_.steps() + 1;
    consents_.set_changed(now);
    // From now on only a person can start; nothing starts by itself.
    if (request->change.step) consents_.set_ran();
  }
  setup_asked_.store(nullptr, std::memory_order_relaxed);
  setup_done_.store(request, std::memory_order_release);
}

void LiveCycle::take_requests(HostNs now) {
  QueuedRequest queued;
  bool begins = !under_way(run_state_);
  while (requests_.pop(queued)) {
    if (shutting_down_) continue;
    if (!moves(queued.request)) {
      cycle_.request(queued.request);
      // Whoever looked before does not know that it was held or paused.
      consents_.set_changed(now);
      begins = begins || queued.request == OperatorRequest::kHold;
      continue;
    }
    const ConsentLoss loss = consents_.judge(queued.consent, now);
    if (loss != ConsentLoss::kNone) {
      push(RequestDropped{now, queued.request, queued.consent.by, loss});
      continue;
    }
    cycle_.request(queued.request);
    if (std::exchange(begins, false)) begins_ = queued;
  }
  give_up_arming(now);
}

// A robot that gets ready only after the consent's life must not start then.
void LiveCycle::give_up_arming(HostNs now) {
  if (run_state_ != RunState::kArming) return;
  if (now - begins_.consent.acted_ns <= begins_.consent.life_ns) return;
  cycle_.request(OperatorRequest::kHold);
  push(RequestDropped{now, begins_.request, begins_.consent.by, ConsentLoss::kTooOld,
                      cycle_.outputs().waits_for});
}

bool LiveCycle::take_inputs(HostNs now) {
  take_setup(now);
  take_requests(now);
  ParameterChange change;
  for (std::size_t i = 0; i < StepInputs::Changes::kCapacity && changes_.pop(change); ++i)
    cycle_.change(change);
  VelocityInput velocity;
  while (velocities_.pop(velocity)) cycle_.velocity(velocity);
  CameraSample seen;
  for (std::size_t i = 0; i < StepInputs::Camera::kCapacity && camera_.pop(seen); ++i)
    cycle_.camera(seen);
  WorldSample received;
  for (std::size_t i = 0; i < kWaitingWorld && world_.pop(received); ++i) cycle_.world(received);
  // Last, so that no other request of the same step can undo it.
  const bool stop = stop_asked_.exchange(false, std::memory_order_acq_rel);
  if (stop) cycle_.request(OperatorRequest::kStop);
  return stop;
}

void LiveCycle::pass_events() {
  for (const link::SessionEvent& event : cycle_.session().take_events()) {
    push(SessionReport{event, cycle_.session().hello()});
    const link::Silence* silence = link::as<link::Silence>(event);
    if (silence == nullptr) continue;
    const bool answered = silence->state != SessionState::kListening;
    drop_port_ = drop_port_ || answered || leave_silent_port_;
  }
}

void LiveCycle::push(const LiveEvent& event) {
  if (!events_.push(event)) lost_events_.fetch_add(1, std::memory_order_relaxed);
}

void LiveCycle::publish(HostNs now) {
  if (now < next_status_ns_ && !shutting_down_) return;
  next_status_ns_ = now + kStatusPeriodNs;
  const link::Session& session = cycle_.session();
  statuses_.push({session.state(), session.counters(), session.clock(), session.hello(),
                  cycle_.outputs().snapshot});
}

bool LiveCycle::take_port_drop() {
  const bool asked = give_up_port_.exchange(false, std::memory_order_acq_rel);
  if (asked && !under_way(run_state_) && !motors_on(cycle_.outputs().snapshot.sample)) {
    consents_.set_ran();
    drop_port_ = true;
  }
  return std::exchange(drop_port_, false);
}

bool LiveCycle::shut_down(HostNs now) {
  if (!std::exchange(shutting_down_, true)) cycle_.disarm(now);
  return !cycle_.request_pending();
}

}  // namespace tp100::live
