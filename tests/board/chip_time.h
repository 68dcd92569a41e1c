#pragma once
// Measures how long routines of the firmware take on the emulated chip.

#include <algorithm>
#include <cstdint>

#include "sim/board/avr_core.h"

struct avr_io_t;
struct avr_irq_t;
struct avr_t;

namespace tp100::sim {

/// Duration of the routine of one interrupt, from the interrupt to the end of its RETI.
class InterruptTime {
 public:
  /// Cycles from an interrupt to the first instruction of its routine; simavr does not count them.
  static constexpr CpuCycles kEntryCycles = 5;
  static constexpr std::uint8_t kAny = 0xFF;

  /// Must outlive the core's last run.
  InterruptTime(AvrCore& core, std::uint8_t vector);

  CpuCycles longest() const { return longest_; }
  std::uint64_t runs() const { return runs_; }

 private:
  static void on_running(avr_irq_t*, std::uint32_t running, void* self);

  AvrCore& core_;
  CpuCycles began_ = 0;
  CpuCycles longest_ = 0;
  std::uint64_t runs_ = 0;
};

/// Duration of a pass of the main loop without sleep, measured between its watchdog kicks, and the
/// sleep. Only one instance may exist at a time.
class LoopTime {
 public:
  explicit LoopTime(AvrCore& core);
  ~LoopTime();
  LoopTime(const LoopTime&) = delete;
  LoopTime& operator=(const LoopTime&) = delete;

  CpuCycles longest() const { return longest_; }
  CpuCycles slept() const { return slept_; }
  void clear() { began_ = longest_ = 0; }

 private:
  static int on_ioctl(avr_io_t* io, std::uint32_t control, void* parameter);
  static void on_sleep(avr_t*, CpuCycles cycles);
  void kicked();

  AvrCore& core_;
  avr_io_t* watchdog_ = nullptr;
  int (*next_)(avr_io_t*, std::uint32_t, void*) = nullptr;
  void (*sleep_)(avr_t*, CpuCycles) = nullptr;
  CpuCycles began_ = 0;
  CpuCycles longest_ = 0;
  CpuCycles slept_ = 0;
};

}  // namespace tp100::sim
