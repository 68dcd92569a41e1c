#pragma once
// Bytes from one thread to another, in bounded memory.

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <span>

#include "core/bytes.h"

namespace tp100::record {

class RecordQueue {
 public:
  /// Holds up to `capacity` bytes. `patient`: put() waits for room instead of refusing.
  RecordQueue(std::size_t capacity, bool patient) : capacity_(capacity), patient_(patient) {}

  /// False: no room, nothing was put. After end() it is ignored.
  bool put(std::span<const std::uint8_t> bytes) {
    std::unique_lock lock(mutex_);
    if (patient_) room_.wait(lock, [&] { return fits(bytes.size()) || ended_; });
    if (ended_) return true;
    if (!fits(bytes.size())) return false;
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    // Who is late is woken at once; else the taker looks now and then by itself.
    if (waiting_.size() > capacity_ / 4) some_.notify_one();
    return true;
  }
  /// A few bytes that always find room and are taken at once.
  void mark(std::span<const std::uint8_t> bytes) {
    const std::lock_guard lock(mutex_);
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    hurry_ = true;
    some_.notify_one();
  }
  /// Nothing more will be put, or taken.
  void end() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    some_.notify_one();
    room_.notify_one();
  }
  /// Replaces `out` by all that waits, after `patience` at the latest. False: ended, and this was
  /// the last.
  template <class Duration>
  bool take(Bytes& out, Duration patience) {
    out.clear();
    std::unique_lock lock(mutex_);
    some_.wait_for(lock, patience,
                   [&] { return ended_ || hurry_ || waiting_.size() > capacity_ / 4; });
    hurry_ = false;
    std::swap(out, waiting_);
    room_.notify_one();
    return !ended_;
  }

 private:
  bool fits(std::size_t size) const { return waiting_.size() + size <= capacity_; }

  std::mutex mutex_;
  std::condition_variable some_, room_;
  Bytes waiting_;
  std::size_t capacity_;
  bool patient_;
  bool ended_ = false, hurry_ = false;
};

}  // namespace tp100::record
