#pragma once
// The cycle in the real-time thread: joins the loop with session and step, and passes plain records
// to the other thread through lock-free rings. Nothing here logs, allocates or waits.

#include <atomic>
#include <cstdint>
#include <mutex>
#include <span>

#include "bridge/cycle.h"
#include "core/snapshot.h"
#include "core/step_record.h"
#include "loop/driven.h"
#include "loop/histogram.h"
#include "loop/slot_ring.h"
#include "loop/spsc_queue.h"

namespace tp100::live {

/// Something that happened, for log and supervisor.
struct LiveEvent {
  enum class Kind : std::uint8_t { kSession, kRunState };
  Kind kind = Kind::kSession;
  HostNs at_ns = 0;
  link::SessionEvent session{};
  wire::Hello hello{};              ///< kSession: as far as it is known
  RunState from = RunState::kIdle;  ///< kRunState
  RunState to = RunState::kIdle;    ///< the same as `from`: more faults were found after an abort
  FaultMask faults = 0;             ///< kRunState: in force at the change, or those that are more
  StartRefusal refused = StartRefusal::kNone;  ///< kRunState: why a start did not begin
};

/// State of the moment, about ten times a second.
struct LiveStatus {
  SessionState session = SessionState::kClosed;
  LinkCounters counters{};
  ClockState clock{};
  wire::Hello hello{};
  Snapshot snapshot{};
};

/// Of the newest sample at each step that got one [ns]: measured, read, used. One writer, any
/// reader.
struct SampleTimes {
  loop::Histogram wire;  ///< measured to read: wire, USB and the kernel
  loop::Histogram wait;  ///< read to step
  loop::Histogram age;   ///< both
};

class LiveCycle : public loop::Driven {
 public:
  /// Steps that may wait for the other thread: half a second at 1 kHz, 5 MB.
  static constexpr std::size_t kWaitingRecords = 512;
  /// Messages of an external world that may wait for a step.
  static constexpr std::size_t kWaitingWorld = 64;

  /// `leave_silent_port`: a port on which nobody ever spoke is given back, so that another can be
  /// tried.
  LiveCycle(const link::SessionSettings& settings, const bridge::Parameters& parameters,
            std::shared_ptr<const course::Course> course, bool leave_silent_port);

  // Other threads.
  /// Any thread but the real-time one. False: too many requests wait; a STOP never does.
  bool request(OperatorRequest request);
  /// A start that is carried out only if nothing has run and nobody has pressed STOP until then,
  /// however long it was under way. Any thread but the real-time one. False: as request().
  bool request_first_start();
  /// A run began or somebody pressed STOP. Any thread.
  bool has_run() const { return has_run_.load(std::memory_order_acquire); }
  /// Any thread but the real-time one. False: too many changes wait.
  bool change(const ParameterChange& change);
  // One other thread.
  /// What the overhead camera saw. False: too many wait.
  bool camera(const CameraSample& seen) { return camera_.push(seen); }
  /// What an external world said; from one thread. False: too many wait.
  bool world(const WorldSample& said) { return world_.push(said); }
  bool take_event(LiveEvent& event) { return events_.pop(event); }
  /// The newest status since the last take; false if there is none.
  bool take_status(LiveStatus& status);
  /// The oldest step that was not yet released, valid until then; null: none.
  const StepRecord* front_record() const { return records_.front(); }
  void release_record() { records_.release(); }
  /// Steps that found no room; StepRecord::step has a gap there.
  std::uint64_t lost_records() const { return lost_records_.load(std::memory_order_relaxed); }
  /// Events that found no room.
  std::uint64_t lost_events() const { return lost_events_.load(std::memory_order_relaxed); }
  const SampleTimes& sample_times() const { return sample_times_; }

  // Real-time thread.
  void opened(HostNs now) override { cycle_.open(now); }
  void closed(HostNs now) override { cycle_.close(now); }
  bool received(std::span<const std::uint8_t> bytes, HostNs now) override;
  void step(HostNs now) override;
  void settle(HostNs now) override;
  std::span<const std::uint8_t> output() override { return cycle_.output(); }
  void written(std::size_t n) override { cycle_.written(n); }
  void drop_output() override { cycle_.drop_output(); }
  bool expects_reply(HostNs now) override { return cycle_.session().expects_reply(now); }
  bool take_hang_up() override;
  bool wind_up(HostNs now) override;

 private:
  struct Asked {
    OperatorRequest request = OperatorRequest::kHold;
    bool only_first = false;
  };

  void take_inputs();
  void time_sample(HostNs now);
  void pass_events();
  void pass_run_state(HostNs now);
  void push(const LiveEvent& event);
  void record();
  void publish(HostNs now);

  bridge::Cycle cycle_;
  std::mutex asking_;  // among those who ask; the real-time thread never takes it
  loop::SpscQueue<Asked, 16> requests_;
  loop::SpscQueue<ParameterChange, bridge::Cycle::kMaxChanges> changes_;
  std::atomic<bool> stop_asked_{false};
  std::atomic<bool> has_run_{false};
  loop::SpscQueue<CameraSample, 32> camera_;  ///< a second of pictures
  loop::SpscQueue<WorldSample, kWaitingWorld> world_;
  loop::SpscQueue<LiveEvent, 256> events_;
  loop::SpscQueue<LiveStatus, 4> statuses_;
  loop::SlotRing<StepRecord> records_{kWaitingRecords};
  SampleTimes sample_times_;
  HostNs received_ns_ = 0;  // the last read that brought bytes
  std::atomic<std::uint64_t> lost_events_{0};
  std::atomic<std::uint64_t> lost_records_{0};
  RunState run_state_ = RunState::kIdle;
  FaultMask faults_ = 0;  // the daemon's, told so far
  HostNs next_status_ns_ = 0;
  bool leave_silent_port_;
  bool hang_up_ = false;
  bool winding_up_ = false;
};

}  // namespace tp100::live
