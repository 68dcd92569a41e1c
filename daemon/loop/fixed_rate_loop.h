#pragma once
// The real-time thread: uses the port's descriptor until it is lost, and makes one cycle per
// period: read → received → step → write → wrote → deferred work; the last after a pause if the
// robot paces the loop. Ports are passed through lock-free queues; nothing here wakes another
// thread.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <thread>
#include <vector>

#include "core/histogram.h"
#include "loop/pacing.h"
#include "loop/port_wait.h"
#include "loop/real_time.h"
#include "loop/rings.h"

namespace tp100::loop {

struct LoopSettings {
  HostNs period_ns = 5 * kNsPerMs;
  /// A cycle begins with the robot's sample; the period is then the deadline's base.
  bool robot_paced = false;
  HostNs spin_ns = 60 * kNsPerUs;  ///< last part of the wait; not when waiting for a robot's sample
  ThreadRequest thread{};
};

/// A descriptor that the loop may use until it reports it as lost. Its owner remains responsible
/// for it.
struct OfferedPort {
  int fd = -1;
  std::uint32_t id = 0;
};

/// Why a port was given back.
enum class PortEnd : std::uint8_t {
  kHungUp,  ///< end of file or an input/output error: unplugged, or the emulator is gone
  kSilent,  ///< the session gave up on it
};

struct LostPort {
  std::uint32_t id = 0;
  PortEnd end = PortEnd::kHungUp;
  int error = 0;  ///< errno, 0: end of file
};

/// One writer (the loop), any reader.
struct LoopStatistics {
  Histogram lateness;  ///< delay of a cycle's start after its deadline [ns]
  Histogram work;      ///< duration of a cycle [ns]
  Histogram compute;   ///< LoopClient::step, up to the bytes to write [ns]
  Histogram write;     ///< the port's write, in cycles that had something to write [ns]
  std::atomic<std::uint64_t> cycles{0};
  std::atomic<std::uint64_t> overruns{0};  ///< cycles that ended after the next one's deadline
  std::atomic<std::uint64_t> missed{0};    ///< cycles skipped because of that
  std::atomic<std::uint64_t> frame_timeouts{
      0};  ///< cycles paced by the robot that began without a sample
};

/// What the loop drives. Every call comes from the real-time thread: no allocation, lock, log or
/// blocking call.
class LoopClient {
 public:
  virtual ~LoopClient() = default;

  /// The port was opened, or is gone.
  virtual void opened(HostNs now) = 0;
  virtual void closed(HostNs now) = 0;
  /// Bytes were read; `now` is right after the read. True: they contain a sample, so that a cycle
  /// paced by the robot may begin.
  virtual bool received(std::span<const std::uint8_t> bytes, HostNs now) = 0;
  /// One cycle, up to the bytes to write.
  virtual void step(HostNs now) = 0;
  /// Right after the write, in every cycle: a few microseconds at most, because the kernel may need
  /// the processor to transmit what was written. `now` as in step().
  virtual void wrote(HostNs now) { (void)now; }
  /// The rest of the cycle, after the write: work that the robot does not wait for. If the robot
  /// paces the loop, up to half a period later, but before the next read or step. `now` as in
  /// step().
  virtual void after_write(HostNs now) = 0;

  /// Bytes to write, in order.
  virtual std::span<const std::uint8_t> output() = 0;
  virtual void written(std::size_t n) = 0;
  /// The port did not accept the bytes in time: they are to be dropped.
  virtual void drop_output() = 0;

  /// True while bytes should be read as soon as they arrive, because their time of arrival matters.
  virtual bool expects_reply(HostNs now) = 0;
  /// True once if the port should be closed and reopened: its peer is silent.
  virtual bool take_port_drop() = 0;
  /// The program is ending: called every cycle from then on; true when finished.
  virtual bool shut_down(HostNs now) = 0;
};

class FixedRateLoop {
 public:
  /// Most bytes read from the port at once; a flooding peer costs no more per cycle.
  static constexpr std::size_t kReadSize = 4096;

  /// `client` must outlive the loop. Throws UserError if the system provides no timer.
  FixedRateLoop(const LoopSettings& settings, LoopClient& loop_client);
  ~FixedRateLoop();

  /// Starts the thread; returns once it has requested its privileges. Throws UserError if the
  /// system provides no thread.
  void start();
  /// Shuts down (see LoopClient::shut_down, at most 300 ms) and ends the thread. Any thread.
  void request_stop() { stop_.store(true, std::memory_order_relaxed); }
  bool ended() const { return ended_.load(std::memory_order_acquire); }
  void join();

  /// From one other thread. False: the queue is full.
  bool offer(const OfferedPort& port) { return offered_.push(port); }
  bool take_lost(LostPort& port) { return lost_.pop(port); }

  const LoopStatistics& statistics() const { return statistics_; }
  /// The privileges that the thread requested; after start().
  const std::vector<Privilege>& privileges() const { return privileges_; }

 private:
  void run();
  void adopt();
  void after_write();
  bool wait(Schedule& schedule);
  bool read(HostNs& now);
  void write(HostNs now);
  void lose(PortEnd end, int error, HostNs now);

  LoopSettings settings_;
  LoopClient& client_;
  PortWait port_wait_;
  LoopStatistics statistics_;
  SpscQueue<OfferedPort, 8> offered_;
  SpscQueue<LostPort, 8> lost_;
  std::vector<Privilege> privileges_;
  std::thread thread_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> ready_{false};
  std::atomic<bool> ended_{false};

  OfferedPort port_{};
  HostNs stuck_since_ns_ = 0;
  HostNs last_cycle_ns_ = 0;
  HostNs cycle_ns_ = 0;    // duration of the last cycle without deferred work
  HostNs pending_ns_ = 0;  // time of the cycle whose deferred work is pending
};

}  // namespace tp100::loop
