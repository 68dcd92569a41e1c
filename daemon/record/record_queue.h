#pragma once
// Passes the entries of recordings as bytes from one thread to another, and keeps the last of them,
// both in bounded memory.

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <span>
#include <utility>

#include "core/bytes.h"
#include "core/time.h"

namespace tp100::record {

class RecordQueue {
 public:
  /// Holds up to `capacity` bytes. `blocking`: put() waits for room instead of refusing.
  RecordQueue(std::size_t capacity, bool blocking) : capacity_(capacity), blocking_(blocking) {}

  /// False: no room, nothing was added. After end() it is ignored.
  bool put(std::span<const std::uint8_t> bytes) {
    std::unique_lock lock(mutex_);
    if (blocking_) room_.wait(lock, [&] { return fits(bytes.size()) || ended_; });
    if (ended_) return true;
    if (!fits(bytes.size())) return false;
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    // A reader that falls behind is woken at once; otherwise it polls.
    if (waiting_.size() > capacity_ / 4) some_.notify_one();
    return true;
  }
  /// Adds a few bytes that always have room and are read at once.
  void mark(std::span<const std::uint8_t> bytes) {
    const std::lock_guard lock(mutex_);
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    hurry_ = true;
    some_.notify_one();
  }
  /// Nothing more will be added or read.
  void end() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    some_.notify_one();
    room_.notify_one();
  }
  /// Replaces `out` by everything waiting, after `patience` at the latest. False: ended, and this
  /// was the last.
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
  bool blocking_;
  bool ended_ = false, hurry_ = false;
};

enum class EntryKind : std::uint8_t { kRequest, kStep, kTruth, kMessage };

struct Entry {
  HostNs at_ns;  ///< of the newest step when it was taken
  EntryKind kind;
  Bytes payload;
};

/// The last entries that were taken from the queue, for a recording that looks back. One thread.
class RecentEntries {
 public:
  /// Keeps those of the last `span_ns`; 0: none.
  explicit RecentEntries(HostNs span_ns) : span_ns_(span_ns) {}

  void add(HostNs at_ns, EntryKind kind, std::span<const std::uint8_t> payload) {
    if (span_ns_ == 0) return;
    entries_.push_back({at_ns, kind, {payload.begin(), payload.end()}});
    bytes_ += payload.size();
    while (entries_.front().at_ns < at_ns - span_ns_ || bytes_ > kMaxBytes) {
      bytes_ -= entries_.front().payload.size();
      entries_.pop_front();
    }
  }
  /// All of them, oldest first; the list is then empty.
  std::deque<Entry> take() {
    bytes_ = 0;
    return std::exchange(entries_, {});
  }

 private:
  static constexpr std::size_t kMaxBytes = std::size_t{32} << 20;

  HostNs span_ns_;
  std::deque<Entry> entries_;
  std::size_t bytes_ = 0;
};

}  // namespace tp100::record
