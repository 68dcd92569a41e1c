#pragma once
// The cycle in the real-time thread: connects the loop with session and step, and passes plain
// records to the other thread through lock-free rings. Never logs, allocates or waits.

#include <atomic>
#include <cstdint>
#include <mutex>
#include <span>
#include <variant>

#include "bridge/cycle.h"
#include "core/consent.h"
#include "core/histogram.h"
#include "core/step_record.h"
#include "loop/fixed_rate_loop.h"
#include "loop/rings.h"

namespace tp100::live {

/// An event of a session.
struct SessionReport {
  link::SessionEvent event{};
  wire::Hello hello{};  ///< as far as received
};
/// A change of the run state, or more faults after an abort.
struct RunChange {
  HostNs at_ns = 0;
  RunState from = RunState::kIdle;
  RunState to = RunState::kIdle;               ///< `from` again if more faults were found
  FaultMask faults = 0;                        ///< active at the change, or the additional ones
  StartRefusal refused = StartRefusal::kNone;  ///< why a start did not begin
  Pose place{};             ///< where the robot is estimated to be, in the course's world
  double progress_m = 0.0;  ///< ... along the course
};
/// A request that was dropped because its consent does not count any more.
struct RequestDropped {
  HostNs at_ns = 0;
  OperatorRequest request = OperatorRequest::kStart;
  Requester by{};
  ConsentLoss loss = ConsentLoss::kNone;
  StartRefusal waited_for = StartRefusal::kNone;  ///< while its consent grew too old
};
/// Something that happened, for log and daemon.
using LiveEvent = std::variant<SessionReport, RunChange, RequestDropped>;

/// Current state, published about ten times a second.
struct LiveStatus {
  SessionState session = SessionState::kClosed;
  LinkCounters counters{};
  ClockState clock{};
  wire::Hello hello{};
  Snapshot snapshot{};
};

/// Latencies of the newest sample at each step that received one [ns]: measured, read, used. One
/// writer, any reader.
struct SampleLatency {
  Histogram wire;  ///< measured to read: wire, USB and the kernel
  Histogram wait;  ///< read to step
  Histogram age;   ///< sum of both
};

/// An operator's change of the set-up on its way through the loop.
struct SetupRequest {
  bridge::SetupChange change{};
  HostNs until_ns = 0;  ///< after this time the change is not made
  // Written by the loop:
  bool made = false;
  std::uint64_t step = 0;  ///< the first with the change, by StepRecord::step
};

class LiveCycle : public loop::LoopClient {
 public:
  /// Steps that may wait for the other thread: half a second at 1 kHz, 5 MB.
  static constexpr std::size_t kWaitingRecords = 512;
  /// Messages of an external world that may wait for a step.
  static constexpr std::size_t kWaitingWorld = 64;

  /// `leave_silent_port`: gives up a port on which nothing was ever received, so that another can
  /// be tried.
  LiveCycle(const link::SessionSettings& settings, const bridge::Parameters& parameters,
            std::shared_ptr<const course::Course> course, bool leave_silent_port);

  // Other threads.
  /// The rule for all consents; every STOP is counted there.
  const ConsentRule& consents() const { return consents_; }
  /// STOP: counted, and carried out by the next step. Cannot be refused. Any thread.
  void stop();
  /// Any thread but the real-time one. A request that moves() needs a consent, which must still
  /// count when the step takes the request, and until the robot is armed; otherwise it is dropped,
  /// which is an event. False: too many requests are waiting.
  bool request(OperatorRequest request, const Consent& consent = kNobody);
  /// Any thread but the real-time one. False: too many changes are waiting.
  bool change(const ParameterChange& change);
  /// Any thread but the real-time one. False: too many inputs are waiting.
  bool velocity(const VelocityInput& input);
  /// Gives the port back like a silent one, unless the robot is armed; then nothing happens.
  /// Afterwards only a person can start; nothing starts by itself. Any thread.
  void give_up_port() { give_up_port_.store(true, std::memory_order_release); }
  /// The run state as of the last step. Any thread.
  RunState run_state() const { return shown_run_state_.load(std::memory_order_acquire); }
  /// ... and why a start is refused for where the robot stands.
  StartPlaces start_places() const { return shown_places_.load(std::memory_order_acquire); }
  /// Passes a change to the loop, which makes it when the robot stands still, unless a run begins
  /// first. The loop owns it until setup_done() returns it; only then pass the next one.
  void offer_setup(SetupRequest& request) {
    setup_asked_.store(&request, std::memory_order_release);
  }
  /// The request that the loop has finished with, whether made or not; null: none. It is returned
  /// before the record of its first step can be taken.
  SetupRequest* setup_done() const { return setup_done_.load(std::memory_order_acquire); }
  void release_setup() { setup_done_.store(nullptr, std::memory_order_relaxed); }
  // One other thread.
  /// Passes on an overhead camera's sample. False: too many are waiting.
  bool camera(const CameraSample& seen) { return camera_.push(seen); }
  /// Passes on a sample of an external world; from one thread. False: too many are waiting.
  bool world(const WorldSample& received) { return world_.push(received); }
  bool take_event(LiveEvent& event) { return events_.pop(event); }
  /// Gets the newest status, once; false if there is no new one.
  bool take_status(LiveStatus& status);
  /// The oldest step not released yet, valid until release; null: none.
  const StepRecord* front_record() const { return records_.front(); }
  void release_record() { records_.release(); }
  /// Also writes each step to this ring, before the other one; while the ring is full, it misses
  /// steps. It must outlive the loop. Call it before the loop starts.
  void record_first(loop::SlotRing<StepRecord>& ring) { first_records_ = &ring; }
  /// Steps dropped because the ring was full; StepRecord::step has a gap there.
  std::uint64_t lost_records() const { return lost_records_.load(std::memory_order_relaxed); }
  /// Events dropped because the ring was full.
  std::uint64_t lost_events() const { return lost_events_.load(std::memory_order_relaxed); }
  const SampleLatency& sample_latency() const { return sample_latency_; }

  // Real-time thread.
  void opened(HostNs now) override { cycle_.session().open(now); }
  void closed(HostNs now) override { cycle_.session().close(now); }
  bool received(std::span<const std::uint8_t> bytes, HostNs now) override;
  void step(HostNs now) override;
  void wrote(HostNs now) override;
  void after_write(HostNs now) override;
  std::span<const std::uint8_t> output() override { return cycle_.session().output(); }
  void written(std::size_t n) override { cycle_.session().written(n); }
  void drop_output() override { cycle_.session().drop_output(); }
  bool expects_reply(HostNs now) override { return cycle_.session().expects_reply(now); }
  bool take_port_drop() override;
  bool shut_down(HostNs now) override;

 private:
  static constexpr Consent kNobody{.life_ns = -1};
  struct QueuedRequest {
    OperatorRequest request = OperatorRequest::kHold;
    Consent consent{};
  };

  /// Whether STOP was among them.
  bool take_inputs(HostNs now);
  void take_requests(HostNs now);
  void give_up_arming(HostNs now);
  void take_setup(HostNs now);
  void time_sample(HostNs now);
  void pass_events();
  void pass_run_state(HostNs now);
  void push(const LiveEvent& event);
  bool record(loop::SlotRing<StepRecord>& ring);
  void publish(HostNs now);

  bridge::Cycle cycle_;
  std::mutex asking_;  // among requesting threads; the real-time thread never takes it
  loop::SpscQueue<QueuedRequest, 16> requests_;
  loop::SpscQueue<ParameterChange, StepInputs::Changes::kCapacity> changes_;
  loop::SpscQueue<VelocityInput, 32> velocities_;
  std::atomic<SetupRequest*> setup_asked_{nullptr};
  std::atomic<SetupRequest*> setup_done_{nullptr};
  ConsentRule consents_;
  std::atomic<bool> stop_asked_{false};
  std::atomic<bool> give_up_port_{false};
  loop::SpscQueue<CameraSample, 32> camera_;  ///< one second of images
  loop::SpscQueue<WorldSample, kWaitingWorld> world_;
  loop::SpscQueue<LiveEvent, 256> events_;
  loop::SpscQueue<LiveStatus, 4> statuses_;
  loop::SlotRing<StepRecord> records_{kWaitingRecords};
  loop::SlotRing<StepRecord>* first_records_ = nullptr;
  SampleLatency sample_latency_;
  QueuedRequest begins_{};  // the last motion that was passed to the step
  HostNs received_ns_ = 0;  // last read that returned bytes
  std::atomic<std::uint64_t> lost_events_{0};
  std::atomic<std::uint64_t> lost_records_{0};
  RunState run_state_ = RunState::kIdle;
  std::atomic<RunState> shown_run_state_{RunState::kIdle};
  std::atomic<StartPlaces> shown_places_{StartPlaces{}};
  static_assert(std::atomic<StartPlaces>::is_always_lock_free);
  FaultMask faults_ = 0;  // those that only the daemon latches, as last reported
  HostNs next_status_ns_ = 0;
  bool leave_silent_port_;
  bool drop_port_ = false;
  bool shutting_down_ = false;
};

}  // namespace tp100::live
