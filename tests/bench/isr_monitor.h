#pragma once
// Duration of an interrupt routine of the emulated chip.

#include <algorithm>
#include <cstdint>

#include "sim/board/avr_core.h"

struct avr_irq_t;

namespace tp100::sim {

class IsrMonitor {
 public:
  static constexpr std::uint8_t kAny = 0xFF;
  /// Cycles from an interrupt to the first instruction of its routine, on the chip.
  static constexpr CpuCycles kEntryCycles = 5;

  /// Starts to measure; the monitor must outlive the core's last run.
  IsrMonitor(AvrCore& core, std::uint8_t vector);

  /// Time from the interrupt to the end of its RETI. simavr does not count the entry, so
  /// kEntryCycles are added.
  CpuCycles longest() const { return longest_; }
  double mean() const {
    return runs_ == 0 ? 0.0 : static_cast<double>(sum_) / static_cast<double>(runs_);
  }
  std::uint64_t runs() const { return runs_; }
  void clear() { longest_ = sum_ = runs_ = 0; }

 private:
  static void on_running(avr_irq_t*, std::uint32_t running, void* watch);

  AvrCore& core_;
  CpuCycles began_ = 0;
  CpuCycles longest_ = 0;
  CpuCycles sum_ = 0;
  std::uint64_t runs_ = 0;
};

}  // namespace tp100::sim
