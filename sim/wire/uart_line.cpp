#include "sim/wire/uart_line.h"

#include <algorithm>

namespace tp100::sim {

void UartLine::send(std::span<const std::uint8_t> bytes, std::int64_t now_ns) {
  for (const std::uint8_t value : bytes) {
    free_ns_ = std::max(free_ns_, now_ns) + byte_ns_;
    bytes_.push_back({free_ns_, value});
  }
}

const std::vector<TimedByte>& UartLine::take(std::int64_t until_ns) {
  taken_.clear();
  while (!bytes_.empty() && bytes_.front().at_ns <= until_ns) {
    taken_.push_back(bytes_.front());
    bytes_.pop_front();
  }
  return taken_;
}

}  // namespace tp100::sim
