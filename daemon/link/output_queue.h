#pragma once
// Frames waiting for the port, in the order in which they were queued. Fixed size, no allocation.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/link_state.h"
#include "wire/fields.h"
#include "wire/frame.h"

namespace tp100::link {

/// Bytes of a session that may wait for the port.
inline constexpr std::size_t kMaxOut = 1024;

template <std::size_t kCapacity>
class OutputQueue {
 public:
  /// `counters` must outlive the queue.
  explicit OutputQueue(LinkCounters& counters) : counters_(counters) {}

  /// Forgets everything without counting it (a new port). The next frame starts with a delimiter,
  /// so that it cannot be joined to half a frame of an earlier writer.
  void reset() {
    begin_ = end_ = 0;
    leads_ = true;
    cut_ = false;
  }

  /// Queues one frame, or drops and counts it if there is no room. Returns the frame's size on the
  /// wire, 0 if it was dropped.
  template <class Message>
  std::size_t push(const Message& message) {
    static_assert(Message::kSize <= wire::kMaxPayload);
    std::uint8_t payload[Message::kSize];
    wire::write_payload(message, payload);
    std::uint8_t frame[wire::kMaxFrame];
    const std::size_t size = wire::encode_frame(static_cast<std::uint8_t>(Message::kType), payload,
                                                Message::kSize, frame);
    if (kCapacity - end_ < size + 1) compact();
    if (kCapacity - end_ < size + 1) {
      ++counters_.unwritten;
      return 0;
    }
    if (leads_ && begin_ == end_) bytes_[end_++] = wire::kDelimiter;
    for (std::size_t i = 0; i < size; ++i) bytes_[end_ + i] = frame[i];
    end_ += size;
    return size;
  }

  /// Queues up to `n` spare delimiters, which a receiver ignores: later frames leave later. Returns
  /// how many had room.
  std::size_t pad(std::size_t n) {
    if (kCapacity - end_ < n) compact();
    n = std::min(n, kCapacity - end_);
    std::fill_n(bytes_.begin() + static_cast<std::ptrdiff_t>(end_), n, wire::kDelimiter);
    end_ += n;
    return n;
  }

  std::span<const std::uint8_t> bytes() const { return {bytes_.data() + begin_, end_ - begin_}; }

  /// The port took the first `n` bytes.
  void written(std::size_t n) {
    if (n > end_ - begin_) n = end_ - begin_;
    if (n == 0) return;
    counters_.frames_out += frame_ends(n);
    counters_.bytes_out += n;
    cut_ = bytes_[begin_ + n - 1] != wire::kDelimiter;
    leads_ = false;
    begin_ += n;
    if (begin_ == end_) begin_ = end_ = 0;
  }

  /// Drops what the port did not accept and counts its frames.
  void drop() {
    counters_.unwritten += frame_ends(end_ - begin_);
    leads_ = leads_ || cut_;
    cut_ = false;
    begin_ = end_ = 0;
  }

 private:
  // Counts the frames that end within the first `n` bytes. A delimiter after another ends none.
  std::size_t frame_ends(std::size_t n) const {
    std::size_t count = 0;
    bool in_frame = cut_;
    for (std::size_t i = begin_; i < begin_ + n; ++i) {
      const bool ends = bytes_[i] == wire::kDelimiter;
      if (ends && in_frame) ++count;
      in_frame = !ends;
    }
    return count;
  }
  void compact() {
    for (std::size_t i = begin_; i < end_; ++i) bytes_[i - begin_] = bytes_[i];
    end_ -= begin_;
    begin_ = 0;
  }

  LinkCounters& counters_;
  std::array<std::uint8_t, kCapacity> bytes_{};
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  bool leads_ =
      true;           // the bytes sent so far may end inside a frame, and nothing was written since
  bool cut_ = false;  // the port's last byte did not end a frame
};

}  // namespace tp100::link
