#pragma once
// When the next turn of the loop is due, and waiting for it.

#include "core/time.h"

namespace tp100::loop {

/// What happens to turns whose time has passed before the one before them was over.
enum class OverrunPolicy {
  kSkipMissed,  ///< they are left out; the next turn is on the old grid
  kShiftPhase,  ///< the next turn is one period from now: a new grid
};

/// Absolute deadlines on a grid. Pure: fed with times.
class Schedule {
 public:
  Schedule(HostNs period_ns, OverrunPolicy policy, HostNs now)
      : period_ns_(period_ns), policy_(policy), deadline_ns_(now + period_ns) {}

  HostNs deadline() const { return deadline_ns_; }
  HostNs period() const { return period_ns_; }

  /// A turn is over at `now`: moves to the next deadline. Returns how many turns were missed.
  std::uint64_t advance(HostNs now);
  /// The turn came from outside (a frame of the robot): the next deadline is `ahead_ns` from now.
  void restart(HostNs now, HostNs ahead_ns) { deadline_ns_ = now + ahead_ns; }

 private:
  HostNs period_ns_;
  OverrunPolicy policy_;
  HostNs deadline_ns_;
};

/// Sleeps until `deadline`; returns at once if it has passed.
void sleep_until(HostNs deadline);
/// Busy until `deadline`: only for the last tens of microseconds.
void spin_until(HostNs deadline);

}  // namespace tp100::loop
