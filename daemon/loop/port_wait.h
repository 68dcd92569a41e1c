#pragma once
// Waits for a port's bytes, and tells when a read would not block.

#include "core/descriptor.h"
#include "core/time.h"

namespace tp100::loop {

/// Waits for a port's bytes until a deadline. poll() and read() of a terminal without bytes wait
/// for the kernel's worker that may be about to deliver some. It runs at ordinary priority, and on
/// a busy machine blocks a real-time thread for hundreds of milliseconds. Therefore a terminal
/// announces bytes by SIGIO to this thread, which waits for the signal instead.
///
/// The timer is set in advance: where a hypervisor provides the clock, setting one takes as long as
/// a whole reply, and before the thread sleeps the kernel may not transmit what was just written.
/// Therefore it already runs when bytes are awaited, and is set again as soon as it expires.
///
/// Call everything except the constructor from one thread, in which SIGIO becomes blocked; nothing
/// here allocates, locks or logs.
class PortWait {
 public:
  /// `spare_ns`: the timer expires by itself this long after a deadline that was met. With half a
  /// period, it expires between two samples. Throws UserError if the system provides no timer.
  explicit PortWait(HostNs spare_ns);

  /// The port to wait for from now on, non-blocking.
  void watch(int fd);
  /// True: the port has bytes, an end or an error. False: `until` has come, or an earlier timer
  /// expired, or bytes were announced that have been read: check the time and call again. The end
  /// of a terminal is detected only at the deadline, by may_read().
  bool readable(HostNs until);
  /// Whether to read now. A terminal is only to be read if it has bytes or has hung up.
  bool may_read();

 private:
  void set(HostNs at);
  bool take_signal();

  HostNs spare_ns_;
  Descriptor timer_, signals_;
  int fd_ = -1;
  bool by_signal_ = false;  // the port is a terminal
  HostNs rings_ns_ = 0;     // expiration of the timer; 0: never
};

}  // namespace tp100::loop
