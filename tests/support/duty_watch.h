#pragma once
// Counts what a real-time thread must not do: heap calls (see alloc_count.h), system calls and
// locks of the calling thread.

#include <cstdint>

#include "support/alloc_count.h"

namespace tp100::test {

/// True if this kernel can tell a thread of its system calls (Linux 5.11, x86-64).
bool watches_system_calls();

/// What was done against it.
struct DutyCount {
  std::uint64_t heap = 0;       ///< calls
  std::uint64_t locks = 0;      ///< mutexes and read-write locks taken, or tried
  long first_system_call = -1;  ///< its number (sys/syscall.h); -1: there was none
};

/// Watches from construction to destruction, in this thread; one at a time. System calls are not
/// carried out meanwhile.
class DutyWatch {
 public:
  /// Adds to `count`, which must outlive it, when it ends.
  explicit DutyWatch(DutyCount& count);
  ~DutyWatch();
  DutyWatch(const DutyWatch&) = delete;
  DutyWatch& operator=(const DutyWatch&) = delete;

 private:
  DutyCount& count_;
  AllocCount heap_;
};

}  // namespace tp100::test
