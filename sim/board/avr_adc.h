#pragma once
// What the ADC of the emulated Mega sees: the cells behind a divider to a third on A0, the noise of
// an open pin on A7, and the board's supply as its reference. simavr's bandgap has 1.1 V.

#include <cstdint>

#include "sim/board/avr_core.h"

struct avr_irq_t;

namespace tp100::sim {

class AvrAdc {
 public:
  AvrAdc(AvrCore& core, std::uint64_t seed);
  /// At the divider's upper end.
  void set_battery(double volts) { volts_ = volts; }
  void set_supply(double volts);

 private:
  static void on_conversion(avr_irq_t*, std::uint32_t channel, void* adc);
  void put(int channel, std::uint32_t steps);

  AvrCore& core_;
  std::uint64_t noise_;
  double volts_ = 0.0;
};

}  // namespace tp100::sim
