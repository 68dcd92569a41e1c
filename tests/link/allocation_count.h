#pragma once
// Counts heap calls of the calling thread while armed. Off under sanitizers, which bring their own
// heap.

#include <cstdint>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TP100_COUNTS_ALLOCATIONS 0
#else
#define TP100_COUNTS_ALLOCATIONS 1
#endif

namespace tp100 {

/// Heap calls of this thread between construction and now.
class AllocationCount {
 public:
  AllocationCount();
  ~AllocationCount();
  std::uint64_t calls() const;
};

}  // namespace tp100
