#pragma once
// One direction of a cable that corrupts, delays and loses bytes.

#include <cstdint>
#include <deque>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include "core/time.h"
#include "sim/board/board.h"
#include "sim/faults/fault.h"

namespace tp100::sim {

class ByteFaults {
 public:
  /// `spacing_ns`: least interval between bytes at the far end; 0: bursts. The same seed gives the
  /// same faults.
  ByteFaults(const std::vector<PlannedFault>& faults, HostNs spacing_ns, std::uint64_t seed);

  /// Sends `bytes` from the near end and returns those that reach the far end by `until_ns`, both
  /// in order of time. All times count from the opening of the port.
  std::vector<TimedByte> pass(std::span<const TimedByte> bytes, HostNs until_ns);

 private:
  struct Planned {
    PlannedFault fault;
    HostNs next_ns;  ///< when the fault itself sends bytes next
    bool hits_frame = false;
  };

  void carry(TimedByte byte);
  void speak(HostNs until_ns);
  /// False: the byte is lost.
  bool corruption(Planned& planned, TimedByte& byte);
  HostNs late(const Planned& planned, HostNs at_ns) const;
  void put(TimedByte byte);
  double random_share();
  std::uint8_t random_byte() { return static_cast<std::uint8_t>(random_() >> 56); }

  std::vector<Planned> faults_;
  HostNs spacing_ns_;
  std::mt19937_64 random_;
  std::deque<TimedByte> on_the_way_;
  HostNs last_ns_ = 0;
  HostNs frame_late_ns_ = 0;
  std::size_t in_frame_ = 0;  ///< bytes of this frame so far
};

}  // namespace tp100::sim
