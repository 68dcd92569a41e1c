#pragma once
// Computes when the next cycle of the loop is due, and waits for it.

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

}  // namespace tp100::loop
