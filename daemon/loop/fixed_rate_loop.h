#pragma once
// The real-time thread: owns the descriptor while it works and makes one turn per period:
// read → received → step → write → settle, the last of it after a pause if a robot paces it. Ports
// come and go through lock-free queues; nothing here wakes another thread.

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "loop/driven.h"
#include "loop/histogram.h"
#include "loop/pacing.h"
#include "loop/port_wait.h"
#include "loop/real_time.h"
#include "loop/spsc_queue.h"

namespace tp100::loop {

struct LoopSettings {
  HostNs period_ns = 5 * kNsPerMs;
  bool robot_paced =
      false;  ///< a turn begins with the robot's sample; the period is then the deadline's base
  HostNs spin_ns = 60 * kNsPerUs;  ///< last part of the wait; not for a robot's sample
  OverrunPolicy overrun = OverrunPolicy::kSkipMissed;  ///< a robot's samples keep no grid
  ThreadRequest thread{};
};

/// A descriptor that the loop may use until it reports it as lost. It stays the giver's property.
struct OfferedPort {
  int fd = -1;
  std::uint32_t id = 0;
};

/// Why a port was given back.
enum class PortEnd : std::uint8_t {
  kHungUp,  ///< end of file or an input/output error: unplugged, or the emulator is gone
  kSilent,  ///< the session gave it up
};

struct LostPort {
  std::uint32_t id = 0;
  PortEnd end = PortEnd::kHungUp;
  int error = 0;  ///< errno, 0: end of file
};

/// One writer (the loop), any reader.
struct LoopStatistics {
  Histogram lateness;  ///< start of a turn after its deadline [ns]
  Histogram work;      ///< duration of a turn [ns]
  Histogram compute;   ///< Driven::step, up to the bytes to write [ns]
  Histogram write;     ///< the port's write, in turns that had something to write [ns]
  std::atomic<std::uint64_t> turns{0};
  std::atomic<std::uint64_t> overruns{0};  ///< turns that ended after the next one's deadline
  std::atomic<std::uint64_t> missed{0};    ///< turns left out because of that
  std::atomic<std::uint64_t> without_frame{
      0};  ///< turns paced by the robot that began without a sample
};

class FixedRateLoop {
 public:
  /// Bytes taken from the port in one read; a flooding peer costs no more per turn.
  static constexpr std::size_t kReadSize = 4096;

  /// `driven` must outlive the loop. Throws SetupError if the system gives no timer.
  FixedRateLoop(const LoopSettings& settings, Driven& driven);
  ~FixedRateLoop();

  /// Starts the thread; returns once it has asked for its privileges. Throws SetupError if the
  /// system gives no thread.
  void start();
  /// Winds up (see Driven::wind_up, at most 300 ms) and ends the thread. Any thread.
  void request_stop() { stop_.store(true, std::memory_order_relaxed); }
  bool ended() const { return ended_.load(std::memory_order_acquire); }
  void join();

  /// From one other thread. False: the queue is full.
  bool offer(const OfferedPort& port) { return offered_.push(port); }
  bool take_lost(LostPort& port) { return lost_.pop(port); }

  const LoopStatistics& statistics() const { return statistics_; }
  /// What the thread asked for and got; after start().
  const std::vector<Grant>& grants() const { return grants_; }

 private:
  void run();
  void adopt();
  void settle();
  bool wait(Schedule& schedule);
  bool read(HostNs& now);
  void write(HostNs now);
  void lose(PortEnd end, int error, HostNs now);

  LoopSettings settings_;
  Driven& driven_;
  PortWait port_wait_;
  LoopStatistics statistics_;
  SpscQueue<OfferedPort, 8> offered_;
  SpscQueue<LostPort, 8> lost_;
  std::vector<Grant> grants_;
  std::thread thread_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> ready_{false};
  std::atomic<bool> ended_{false};

  OfferedPort port_{};
  HostNs stuck_since_ns_ = 0;
  HostNs last_turn_ns_ = 0;
  HostNs turn_ns_ = 0;       // what the last turn took without settling
  HostNs unsettled_ns_ = 0;  // its time, until it has been settled
};

}  // namespace tp100::loop
