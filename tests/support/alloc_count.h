#pragma once
// Counts heap calls of the calling thread during the lifetime of an AllocCount, by replacing malloc
// and its family. Sanitizers bring their own malloc: there counting() is false and the counts stay
// zero.

#include <cstdint>

namespace tp100::test {

/// True if this build counts heap calls.
bool counting();

/// Counts from construction to destruction, in this thread.
class AllocCount {
 public:
  AllocCount();
  ~AllocCount();
  AllocCount(const AllocCount&) = delete;
  AllocCount& operator=(const AllocCount&) = delete;
  /// Heap calls so far.
  std::uint64_t calls() const;
};

}  // namespace tp100::test
