#pragma once
// Waiting for a port's bytes under a deadline, with a timer that is set ahead.

#include "core/time.h"

namespace tp100::loop {

/// Setting a timer takes as long as a whole answer where a hypervisor keeps the clock, and before
/// the thread sleeps the kernel may not get round to carrying what it has just written. So the
/// timer always runs already when bytes are awaited: when it rings, it is set again at once. One
/// thread; nothing here allocates, locks or logs.
class PortWait {
 public:
  /// `spare_ns`: how long after a deadline that was reached the timer rings again by itself. Half a
  /// period is between two samples. Throws SetupError if the system gives no timer.
  explicit PortWait(HostNs spare_ns);
  ~PortWait();
  PortWait(const PortWait&) = delete;
  PortWait& operator=(const PortWait&) = delete;

  /// True: `fd` has bytes, an end or an error. False: `until` has come, or a timer of before rang:
  /// look at the time and ask again.
  bool readable(int fd, HostNs until);

 private:
  void set(HostNs at);

  HostNs spare_ns_;
  int timer_;
  HostNs rings_ns_ = 0;  // 0: never
};

}  // namespace tp100::loop
