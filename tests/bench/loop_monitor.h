#pragma once
// Duration of a cycle of the firmware's main loop, measured by its watchdog kicks.

#include <algorithm>
#include <cstdint>

#include "sim/board/avr_core.h"

struct avr_io_t;

namespace tp100::sim {

/// Only one instance may exist at a time.
class LoopMonitor {
 public:
  explicit LoopMonitor(AvrCore& core);
  ~LoopMonitor();
  LoopMonitor(const LoopMonitor&) = delete;
  LoopMonitor& operator=(const LoopMonitor&) = delete;

  /// Processor cycles of the longest loop cycle, without sleep.
  CpuCycles longest() const { return longest_; }
  std::uint64_t cycles() const { return cycles_; }
  void clear() { began_ = longest_ = cycles_ = 0; }

 private:
  static int on_ioctl(avr_io_t* io, std::uint32_t control, void* parameter);
  void cycle();

  AvrCore& core_;
  avr_io_t* watchdog_ = nullptr;
  int (*next_)(avr_io_t*, std::uint32_t, void*) = nullptr;
  CpuCycles began_ = 0;
  CpuCycles longest_ = 0;
  std::uint64_t cycles_ = 0;
};

}  // namespace tp100::sim
