#pragma once
// The encoders on the external-interrupt pins of the emulated Mega (firmware/WIRING.md): left A
// PE4, left B PE5, right A PD3, right B PD2.

#include <array>
#include <cstdint>

#include "sim/board/avr_core.h"

struct avr_ioport_t;
struct avr_irq_t;

namespace tp100::sim {

class AvrEncoderPins {
 public:
  explicit AvrEncoderPins(AvrCore& core);

  /// Channels as in Edge. The pin changes now.
  void set(std::uint8_t channel, bool level);
  /// The pins keep their levels over a reset of the chip.
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

}  // namespace tp100::sim
