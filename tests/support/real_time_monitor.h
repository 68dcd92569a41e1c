#pragma once
// Counts what a real-time thread must not do: heap calls (see alloc_count.h), system calls and
// locks of the calling thread.

#include <cstdint>

#include "support/alloc_count.h"

namespace tp100::test {

/// True if this kernel can report a thread's system calls (Linux 5.11, x86-64).
bool watches_system_calls();

/// Violations counted.
struct RealTimeViolations {
  std::uint64_t heap = 0;       ///< calls
  std::uint64_t locks = 0;      ///< mutexes and read-write locks that were taken or tried
  long first_system_call = -1;  ///< its number (sys/syscall.h); -1 if there was none
};

/// Monitors this thread during its lifetime; only one monitor may exist at a time. System calls are
/// not executed meanwhile.
class RealTimeMonitor {
 public:
  /// Adds its result to `count` in the destructor; `count` must outlive the monitor.
  explicit RealTimeMonitor(RealTimeViolations& count);
  ~RealTimeMonitor();
  RealTimeMonitor(const RealTimeMonitor&) = delete;
  RealTimeMonitor& operator=(const RealTimeMonitor&) = delete;

 private:
  RealTimeViolations& count_;
  AllocCount heap_;
};

}  // namespace tp100::test
