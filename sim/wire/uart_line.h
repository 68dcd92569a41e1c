#pragma once
// One direction of a serial cable: bytes leave one after the other, each taking a byte time.

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "sim/board/board.h"

namespace tp100::sim {

/// 8N1: a byte is ten bit times.
class UartLine {
 public:
  explicit UartLine(std::uint32_t baud) : byte_ns_(10'000'000'000LL / baud) {}

  /// `bytes` are handed to the sending UART at `now_ns`.
  void send(std::span<const std::uint8_t> bytes, std::int64_t now_ns);
  /// The bytes whose stop bits end at or before `until_ns`, in order.
  const std::vector<TimedByte>& take(std::int64_t until_ns);
  /// Bytes on their way.
  std::size_t pending() const { return bytes_.size(); }
  /// The cable is cut: what was on its way is gone.
  void clear() { bytes_.clear(); }

 private:
  std::int64_t byte_ns_;
  std::int64_t free_ns_ = 0;
  std::deque<TimedByte> bytes_;
  std::vector<TimedByte> taken_;
};

}  // namespace tp100::sim
