#pragma once
// What an encoder does to a pin.

#include <cstdint>

namespace tp100::sim {

/// One encoder edge. Channels: 0 left A, 1 left B, 2 right A, 3 right B.
struct Edge {
  std::int64_t at_ns;
  std::uint8_t channel;
  bool level;
};

}  // namespace tp100::sim
