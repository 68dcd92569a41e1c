#pragma once
// Computes when the next cycle of the loop is due, and waits for it.

#include "core/time.h"

namespace tp100::loop {

/// Absolute deadlines on a grid. Pure: times are passed in.
class Schedule {
 public:
  Schedule(HostNs period_ns, HostNs now) : period_ns_(period_ns), deadline_ns_(now + period_ns) {}

  HostNs deadline() const { return deadline_ns_; }
  HostNs period() const { return period_ns_; }

  /// A cycle ended at `now`: moves to the next deadline on the grid. Returns how many cycles fell
  /// due meanwhile; they are skipped.
  std::uint64_t advance(HostNs now);
  /// The robot's frame began the cycle: the next deadline is `ahead_ns` from now.
  void restart(HostNs now, HostNs ahead_ns) { deadline_ns_ = now + ahead_ns; }

 private:
  HostNs period_ns_;
  HostNs deadline_ns_;
};

/// Sleeps until `deadline`; returns at once if it has passed.
void sleep_until(HostNs deadline);
/// Spins until `deadline`: only for the last tens of microseconds.
void spin_until(HostNs deadline);

}  // namespace tp100::loop
