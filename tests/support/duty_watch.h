#pragma once
// Counts what a real-time thread must not do, besides allocating (see alloc_count.h): system calls
// and locks of the calling thread.

#include <cstdint>

namespace tp100::test {

/// True if this kernel can tell a thread of its system calls (Linux 5.11, x86-64).
bool watches_system_calls();

/// Watches from construction to destruction, in this thread; one at a time.
class DutyWatch {
 public:
  DutyWatch();
  ~DutyWatch();
  DutyWatch(const DutyWatch&) = delete;
  DutyWatch& operator=(const DutyWatch&) = delete;
  /// Number of the first system call (sys/syscall.h); -1: there was none. It is not carried out.
  long first_system_call() const;
  /// Mutexes and read-write locks taken, or tried.
  std::uint64_t locks() const;
};

}  // namespace tp100::test
