#pragma once
// Privileges of the real-time thread: each is requested, checked and reported; none is required.

#include <string>
#include <vector>

#include "core/descriptor.h"

namespace tp100::loop {

/// SCHED_FIFO priority of what a robot waits for besides the loop: before ordinary programs.
inline constexpr int kBelowTheLoop = 1;

/// One requested privilege.
struct Privilege {
  std::string what;  ///< e.g. "SCHED_FIFO 80"
  bool granted = false;
  std::string fix;  ///< how to get it; empty if granted
};

/// Privileges for the whole process.
struct ProcessRequest {
  bool lock_memory = true;       ///< threads that begin then have stacks of 1 MB
  bool hold_cpu_latency = true;  ///< keep the processor out of deep sleep: halves the wake-up time
  /// Schedule the kernel's unbound workers before ordinary programs (kBelowTheLoop), if
  /// CAP_SYS_NICE permits it; a refusal is not reported. They carry the bytes of every tty, also of
  /// a pty, to its reader: beside a browser they waited for 200 ms and more, which ends a run, and
  /// at nice -20 still for 90 ms (Linux 6.18).
  bool raise_kernel_workers = true;
};

/// Privileges for one thread.
struct ThreadRequest {
  int priority = 80;  ///< SCHED_FIFO; 0: ordinary scheduling
  int cpu = -1;       ///< -1: any
};

/// Requests on construction; releases the processor latency on destruction. Workers stay raised:
/// another robot of this machine may need them.
class RealTimeProcess {
 public:
  explicit RealTimeProcess(const ProcessRequest& request);

  const std::vector<Privilege>& privileges() const { return privileges_; }
  /// Raises workers that the kernel has made since. Reads /proc, so once a second is enough, and
  /// not in the real-time thread.
  void keep() const;

 private:
  std::vector<Privilege> privileges_;
  Descriptor latency_;
  bool workers_raised_ = false;
};

/// Requests them for the calling thread; also sets its timer slack to 1 ns and touches its stack.
std::vector<Privilege> apply_to_this_thread(const ThreadRequest& request);

}  // namespace tp100::loop
