#pragma once
// The firmware image on an emulated ATmega2560: the same bytes that a programmer writes into a real
// board. Edges, bytes and the ends of quanta occur at their exact cycles. The same inputs give the
// same bytes.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/time.h"
#include "sim/board/avr_core.h"
#include "sim/board/avr_i2c.h"
#include "sim/board/avr_image.h"
#include "sim/board/avr_pins.h"
#include "sim/board/avr_uart.h"
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
};

/// Counts since construction.
struct AvrBoardCounters {
  std::uint64_t rx_overruns = 0;      ///< bytes that found the receiver full
  std::uint64_t watchdog_resets = 0;  ///< resets by the chip's own watchdog
};

class AvrBoard final : public Board {
 public:
  /// `imu` answers at I2C address 0x68; null: no device answers. It must outlive the board. The
  /// board has no power until the first reset(). Throws UserError.
  AvrBoard(const AvrBoardSettings& settings, I2cSlave* imu);
  AvrBoard(const AvrBoard&) = delete;
  AvrBoard& operator=(const AvrBoard&) = delete;

  void reset(PowerUp cause, HostNs now_ns) override;
  void advance(HostNs until_ns, std::span<const EncoderEdge> edges,
               std::span<const TimedByte> received) override;
  std::vector<TimedByte> take_sent() override;
  MotorDuty motor_duty() const override { return powered_ ? motor_drive(core_) : MotorDuty{}; }
  void set_battery(double volts) override { adc_.set_battery(volts); }
  void set_supply(double volts) override { adc_.set_supply(volts); }

  void set_i2c_fault(I2cFault fault) { i2c_.set_fault(fault); }
  /// From its next sleep until a reset, the main loop hangs in one place while interrupts continue.
  void hang_main_loop() { hang_wanted_ = true; }
  /// For measurements.
  AvrCore& core() { return core_; }
  AvrBoardCounters counters() const { return {uart_.overruns(), core_.own_resets()}; }

 private:
  void fill_eeprom();
  void preset_clock();
  void set_clock();
  void scramble();
  void restore();
  CpuCycles cycle_at(HostNs at_ns) const;
  HostNs time_at(CpuCycles cycle) const;
  CpuCycles deliver(CpuCycles at);
  void hang();
  void let_go();
  void stamp(HostNs until_ns);

  AvrBoardSettings settings_;
  AvrImage image_;
  AvrCore core_;
  AvrUart uart_;
  AvrEncoderPins encoders_;
  AvrI2c i2c_;
  AvrAdc adc_;
  double cycles_per_ns_;

  bool powered_ = false;
  HostNs now_ns_ = 0;
  HostNs begin_ns_ = 0;
  CpuCycles begin_cycle_ = 0;
  std::span<const EncoderEdge> edges_;
  std::span<const TimedByte> bytes_;
  std::vector<TimedByte> stamped_;
  std::uint64_t power_ups_ = 0;

  std::uint16_t overflow_count_ = 0;
  bool clock_is_set_ = false;

  bool hang_wanted_ = false;
  bool hung_ = false;
  std::uint32_t hung_at_ = 0;
  std::array<std::uint8_t, 2> hung_code_{};
};

}  // namespace tp100::sim
