#pragma once
// Lock-free rings between two threads, one writing and one reading. Fixed memory.

#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tp100::loop {

/// For small values, which are copied in and out.
template <class T, std::size_t kCapacity>
using SpscQueue = boost::lockfree::spsc_queue<T, boost::lockfree::capacity<kCapacity>>;

/// For large records: the writer fills a slot in place and the reader reads it in place, so that
/// nothing is copied twice. One thread writes, another one reads. The memory is allocated and
/// touched at construction; nothing else allocates or waits.
template <class T>
class SlotRing {
 public:
  explicit SlotRing(std::size_t capacity) : slots_(capacity) {}

  // Writer.
  /// The next free slot, with its previous content; null: the ring is full.
  T* free_slot() {
    const std::uint64_t head = head_.load(std::memory_order_relaxed);
    if (head - tail_.load(std::memory_order_acquire) >= slots_.size()) return nullptr;
    return &slots_[head % slots_.size()];
  }
  /// Passes the slot of the last free_slot() to the reader.
  void publish() {
    head_.store(head_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }

  // Reader.
  /// The oldest published record not yet released; null: none.
  const T* front() const {
    const std::uint64_t tail = tail_.load(std::memory_order_relaxed);
    if (tail == head_.load(std::memory_order_acquire)) return nullptr;
    return &slots_[tail % slots_.size()];
  }
  /// Returns the slot of front() to the writer.
  void release() {
    tail_.store(tail_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }

  std::size_t capacity() const { return slots_.size(); }

 private:
  std::vector<T> slots_;
  alignas(64) std::atomic<std::uint64_t> head_{0};
  alignas(64) std::atomic<std::uint64_t> tail_{0};
};

}  // namespace tp100::loop
