#pragma once
// The L293D on the emulated Mega's outputs (firmware/WIRING.md): enables on PH3 and PH4, the PWM
// pins of timer 4; inputs 1 to 4 on PA0 to PA3.

#include "sim/board/avr_core.h"
#include "sim/board/board.h"

namespace tp100::sim {

/// Mean voltage at the motors as shares of the supply, from the registers as they are now. Both
/// inputs of a bridge alike brake: 0.
Drive motor_drive(const AvrCore& core);

}  // namespace tp100::sim
