#pragma once
// The firmware image on an emulated ATmega2560: the same bytes that a programmer writes into a real
// board. Edges, bytes and the ends of quanta occur at their exact cycles. The same inputs give the
// same bytes.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/time.h"
#include "sim/board/avr_i2c.h"
#include "sim/board/board.h"

namespace tp100::sim {

/// One board.
struct AvrBoardSettings {
  std::string image{};         ///< ELF or HEX; empty: the one built with this program
  bool bootloader = false;     ///< Arduino's bootloader runs first and waits for a second
  bool blank = false;          ///< no firmware yet: `image` is not read
  std::uint64_t seed = 1;      ///< seed of EEPROM, SRAM at power-on and the ADC's noise
  double clock_ppm = 0.0;      ///< error of the resonator; positive runs fast
  std::uint32_t start_us = 0;  ///< device clock at each boot, in steps of 1024; needs an ELF
  HostNs reset_hold_ns = 0;    ///< from reset() to the first instruction
  std::uint32_t run_cycle_limit = 16000;  ///< see AvrCore; affects only the emulator's speed
};

/// Counts since construction.
struct AvrBoardCounters {
  std::uint64_t rx_overruns = 0;      ///< bytes that found the receiver full
  std::uint64_t rx_while_off = 0;     ///< bytes that arrived while the receiver was off
  std::uint64_t watchdog_resets = 0;  ///< resets by the chip's own watchdog
  std::uint64_t cycles = 0;
  std::uint64_t slept_cycles = 0;
  std::uint64_t i2c_bytes = 0;
};

class AvrBoard final : public Board {
 public:
  /// `imu` answers at I2C address 0x68; null: no device answers. It must outlive the board. The
  /// board has no power until the first reset(). Throws SetupError.
  AvrBoard(const AvrBoardSettings& settings, I2cSlave* imu);
  ~AvrBoard() override;
  AvrBoard(AvrBoard&&) noexcept;
  AvrBoard& operator=(AvrBoard&&) noexcept;

  void reset(PowerUp cause, HostNs now_ns) override;
  void advance(HostNs until_ns, std::span<const EncoderEdge> edges,
               std::span<const TimedByte> received) override;
  std::vector<TimedByte> take_sent() override;
  MotorDuty motor_duty() const override;
  void set_battery(double volts) override;
  void set_supply(double volts) override;

  void set_i2c_fault(I2cFault fault);
  /// From its next sleep until a reset, the main loop hangs in one place while interrupts continue.
  void hang_main_loop();
  AvrBoardCounters counters() const;
  /// Duration from START to STOP.
  CpuCycles longest_i2c_transfer() const;
  /// For measurements and tests.
  AvrCore& core();
  const AvrImage& image() const;

 private:
  struct Machine;
  std::unique_ptr<Machine> machine_;
};

}  // namespace tp100::sim
