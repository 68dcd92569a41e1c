#pragma once
// A two-phase encoder on a track.

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "core/time.h"
#include "course/robot_file.h"

namespace tp100::sim {

// Edges of an encoder at a pin.

/// One encoder edge. Channels: 0 left A, 1 left B, 2 right A, 3 right B.
struct EncoderEdge {
  HostNs at_ns;
  std::uint8_t channel;
  bool level;
};

/// Converts track travel into timed edges of phases A and B; A leads when the track moves forward.
class QuadratureEncoder {
 public:
  /// `first_channel`: 0 for the left track, 2 for the right one (EncoderEdge).
  QuadratureEncoder(const course::EmulatedEncoder& values, std::uint8_t first_channel,
                    std::uint64_t seed);

  /// The track moves `travel_m` evenly between `from_ns` and `to_ns`; edges are appended in time
  /// order.
  void move(double travel_m, HostNs from_ns, HostNs to_ns, std::vector<EncoderEdge>& edges);

  /// Edges forward minus edges backward.
  std::int64_t counts() const { return counts_; }

 private:
  double boundary(std::int64_t count) const;
  void emit(std::int64_t count, HostNs at_ns, std::vector<EncoderEdge>& edges);

  double counts_per_metre_;
  std::uint8_t first_channel_;
  std::array<double, 4> offsets_{};  // position errors of the four edges of a cycle, in edges
  double position_ = 0.5;            // in edges; the start lies between two of them
  std::int64_t counts_ = 0;
};

}  // namespace tp100::sim
