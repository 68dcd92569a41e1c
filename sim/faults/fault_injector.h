#pragma once
// All faults of one emulated robot: those between its board and cable, encoders, IMU and battery,
// and those of the board as a whole.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/time.h"
#include "sim/faults/byte_faults.h"
#include "sim/faults/fault.h"
#include "sim/faults/frame_faults.h"
#include "sim/faults/sensor_faults.h"

namespace tp100::sim {

class FaultInjector {
 public:
  /// The same faults and seed give the same corruption. `byte_ns`: byte time of the cable.
  FaultInjector(const std::vector<PlannedFault>& faults, HostNs byte_ns, std::uint64_t seed);

  /// The port is open: the faults' times count from here. Call once only.
  void begin(HostNs now_ns);

  /// Bytes that reach the far end by `until_ns`.
  std::vector<TimedByte> to_robot(std::span<const TimedByte> bytes, HostNs until_ns);
  std::vector<TimedByte> to_host(std::span<const TimedByte> bytes, HostNs until_ns);
  /// Edges that reach the pins in the quantum from `from_ns`.
  void edges(std::vector<EncoderEdge>& edges, HostNs from_ns);
  /// Voltage at the divider instead of `volts`.
  double battery(double volts, HostNs now_ns) const;
  /// True if a lasting fault is active now.
  bool active(FaultKind kind, HostNs now_ns) const;
  /// The number of a fault of this kind that occurs now; once per occurrence.
  std::optional<double> take(FaultKind kind, HostNs now_ns);

 private:
  struct Planned {
    PlannedFault fault;
    HostNs next_ns;
  };
  /// Passes `bytes` through both, with times that count from begin().
  std::vector<TimedByte> pass(std::span<const TimedByte> bytes, HostNs until_ns,
                              FrameFaults& frames, ByteFaults& corruption) const;

  std::vector<Planned> faults_;
  FrameFaults frames_to_robot_, frames_to_host_;
  ByteFaults bytes_to_robot_, bytes_to_host_;
  EncoderFaults encoders_;
  std::optional<HostNs> begin_ns_;
};

}  // namespace tp100::sim
