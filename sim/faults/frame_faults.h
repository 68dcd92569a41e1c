#pragma once
// One direction of a cable on which whole frames are changed, repeated, delayed or forged, with
// valid checksums.

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "core/time.h"
#include "sim/board/board.h"
#include "sim/faults/fault.h"
#include "wire/frame.h"

namespace tp100::sim {

class FrameFaults {
 public:
  explicit FrameFaults(const std::vector<PlannedFault>& faults);

  /// Sends `bytes` (in order of time) from the near end; all times count from the opening of the
  /// port. Returns the bytes that reach the far end by `until_ns`: whole frames, each once its end
  /// has passed, and bytes outside frames unchanged. Without faults nothing is delayed.
  std::vector<TimedByte> pass(std::span<const TimedByte> bytes, HostNs until_ns);

 private:
  struct Held {
    HostNs due_ns;
    std::vector<TimedByte> frame;
  };
  struct Planned {
    PlannedFault fault;
    bool began = false;
    std::uint16_t first_sequence = 0;
  };

  void finish(wire::DecodeResult received, std::vector<TimedByte>& out);
  /// Changes the payload of the current frame.
  void edit(Planned& planned, std::uint8_t type, std::vector<std::uint8_t>& payload);
  static std::vector<TimedByte> coded(std::uint8_t type, std::span<const std::uint8_t> payload,
                                      HostNs at_ns);

  std::vector<Planned> faults_;
  wire::FrameDecoder decoder_;
  std::vector<TimedByte> frame_;
  std::deque<std::vector<TimedByte>> sent_;  ///< the last frames, for replay
  std::vector<Held> held_;
};

}  // namespace tp100::sim
