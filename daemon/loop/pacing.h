#pragma once
// Computes when the next cycle of the loop is due, and waits for it or for a port's bytes.

#include "core/time.h"

namespace tp100::loop {

/// What happens to cycles that fell due while a cycle was still running.
enum class OverrunPolicy {
  kSkipMissed,  ///< they are skipped; the next cycle is on the old grid
  kShiftPhase,  ///< the next cycle is one period from now: a new grid
};

/// Absolute deadlines on a grid. Pure: times are passed in.
class Schedule {
 public:
  Schedule(HostNs period_ns, OverrunPolicy policy, HostNs now)
      : period_ns_(period_ns), policy_(policy), deadline_ns_(now + period_ns) {}

  HostNs deadline() const { return deadline_ns_; }
  HostNs period() const { return period_ns_; }

  /// A cycle ended at `now`: moves to the next deadline. Returns how many cycles were missed.
  std::uint64_t advance(HostNs now);
  /// The robot's frame began the cycle: the next deadline is `ahead_ns` from now.
  void restart(HostNs now, HostNs ahead_ns) { deadline_ns_ = now + ahead_ns; }

 private:
  HostNs period_ns_;
  OverrunPolicy policy_;
  HostNs deadline_ns_;
};

/// Sleeps until `deadline`; returns at once if it has passed.
void sleep_until(HostNs deadline);
/// Spins until `deadline`: only for the last tens of microseconds.
void spin_until(HostNs deadline);

/// Waits for a port's bytes until a deadline, with a timer that is set in advance. Where a
/// hypervisor provides the clock, setting a timer takes as long as a whole reply, and before the
/// thread sleeps the kernel may not transmit what was just written. So the timer already runs when
/// bytes are awaited, and is set again as soon as it expires. One thread; nothing here allocates,
/// locks or logs.
class PortWait {
 public:
  /// `spare_ns`: the timer expires by itself this long after a deadline that was met. With half a
  /// period, that is between two samples. Throws SetupError if the system provides no timer.
  explicit PortWait(HostNs spare_ns);
  ~PortWait();
  PortWait(const PortWait&) = delete;
  PortWait& operator=(const PortWait&) = delete;

  /// True: `fd` has bytes, an end or an error. False: `until` has come, or an earlier timer
  /// expired: check the time and call again.
  bool readable(int fd, HostNs until);

 private:
  void set(HostNs at);

  HostNs spare_ns_;
  int timer_;
  HostNs rings_ns_ = 0;  // expiration of the timer; 0: never
};

}  // namespace tp100::loop
