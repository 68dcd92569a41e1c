#pragma once
// Parts wired to the emulated Mega's pins (firmware/WIRING.md): battery, encoders, motor driver.

#include <array>
#include <cstdint>

#include "sim/board/avr_core.h"
#include "sim/board/board.h"

struct avr_ioport_t;
struct avr_irq_t;

namespace tp100::sim {

/// Inputs of the ADC: the battery behind a 1:3 divider on A0, the noise of an open pin on A7, and
/// the board's supply as its reference. simavr's bandgap is 1.1 V.
class AvrAdc {
 public:
  AvrAdc(AvrCore& core, std::uint64_t seed);
  /// Voltage at the divider's upper end.
  void set_battery(double volts) { volts_ = volts; }
  void set_supply(double volts);

 private:
  static void on_conversion(avr_irq_t*, std::uint32_t channel, void* adc);
  void put(int channel, std::uint32_t steps);

  AvrCore& core_;
  std::uint64_t noise_;
  double volts_ = 0.0;
};

/// The encoders on the external-interrupt pins: left A PE4, left B PE5, right A PD3,
/// right B PD2.
class AvrEncoderPins {
 public:
  explicit AvrEncoderPins(AvrCore& core);

  /// Sets a pin now. Channels as in EncoderEdge.
  void set(std::uint8_t channel, bool level);
  /// Restores the pins' levels after a reset of the chip.
  void restore();

 private:
  struct Pin {
    avr_ioport_t* port = nullptr;
    avr_irq_t* irq = nullptr;
    std::uint8_t mask = 0;
    bool level = false;
  };
  void hold(const Pin& pin);

  AvrCore& core_;
  std::array<Pin, 4> pins_;
};

/// The L293D: enables on PH3 and PH4, the PWM pins of timer 4; inputs 1 to 4 on PA0 to PA3. Mean
/// voltage at the motors as shares of the supply, from the current registers. A bridge with
/// equal inputs brakes: 0.
MotorDuty motor_drive(const AvrCore& core);

}  // namespace tp100::sim
