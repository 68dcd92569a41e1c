#pragma once
// A bare emulated ATmega2560 at 16 MHz: simavr, with its defects worked around. The rest of the
// board is connected to its pins and registers.

#include <cstdint>
#include <functional>
#include <memory>

#include "sim/board/avr_image.h"

struct avr_io_t;
struct avr_t;

namespace tp100::sim {

/// Cycles since the core was created; continues over resets.
using CpuCycles = std::uint64_t;

class AvrCore {
 public:
  static constexpr std::uint32_t kHz = 16'000'000;
  static constexpr CpuCycles kNever = ~CpuCycles{0};

  /// Throws UserError.
  explicit AvrCore(const AvrImage& image);
  ~AvrCore();
  AvrCore(const AvrCore&) = delete;
  AvrCore& operator=(const AvrCore&) = delete;

  /// Called between two instructions at the cycle that the last call returned (kNever: at the next
  /// run_until()); does what is due and returns the cycle of its next call.
  std::function<CpuCycles(CpuCycles now)> on_event;
  /// Called after each reset, the chip's own included: restores the state of the pins.
  std::function<void()> on_reset;

  /// Writes another program into the flash, for instance a bootloader.
  void program(const AvrImage& image);
  /// First instruction after a reset.
  void set_reset_address(std::uint32_t address);
  /// Resets, with these bits of MCUSR set.
  void reset(std::uint8_t mcusr);
  /// Runs until the first instruction boundary at or after `cycle`.
  void run_until(CpuCycles cycle);

  CpuCycles cycle() const;
  /// Number of resets by the chip's own watchdog.
  std::uint64_t own_resets() const { return own_resets_; }
  /// Registers, I/O and SRAM by data address.
  std::uint8_t* data() const;
  std::uint8_t* flash() const;
  /// Byte address of the next instruction.
  std::uint32_t program_counter() const;
  bool asleep() const;
  avr_t* chip() const { return avr_; }
  /// The chip's module of that kind ("uart", "port", ...) that `is` accepts. Throws UserError.
  avr_io_t* module(
      const char* kind,
      const std::function<bool(avr_io_t*)>& is = [](avr_io_t*) { return true; }) const;

 private:
  static void on_chip_reset(avr_t* avr);
  static CpuCycles on_timer(avr_t* avr, CpuCycles when, void* core);
  void repair_timers();
  void free_what_terminate_leaves();
  void arm();

  avr_t* avr_;
  void (*chip_reset_)(avr_t*) = nullptr;
  CpuCycles offset_ = 0;  // cycle() minus simavr's own count
  CpuCycles until_ = 0;
  CpuCycles next_ = kNever;
  bool reached_ = true;
  bool was_reset_ = false;
  std::uint64_t own_resets_ = 0;
};

}  // namespace tp100::sim
