// Clock, PWM and ADC scaling of a Pico, apart from its registers, so that tests on the host can
// check it.
#ifndef TP100_FIRMWARE_PICO_SCALING_H
#define TP100_FIRMWARE_PICO_SCALING_H

#include <stdint.h>

#include "wire/messages.h"

namespace tp100 {
namespace firmware {
namespace pico {

const uint32_t kCrystalHz = 12000000;
/// PLL of the system clock: 12 MHz x 125 / (6 x 2). The VCO may run at 750 to 1600 MHz (data
/// sheet, 2.18.2).
const uint32_t kSysFeedback = 125, kSysDivider1 = 6, kSysDivider2 = 2;
const uint32_t kSysHz = kCrystalHz * kSysFeedback / (kSysDivider1 * kSysDivider2);
/// PLL of the ADC: 12 MHz x 100 / (5 x 5) = 48 MHz (2.15.6.2).
const uint32_t kAdcFeedback = 100, kAdcDivider1 = 5, kAdcDivider2 = 5;

/// The UART divides by 16 and by a number with six binary places (4.2.3.2.1).
const uint32_t kUartDivider64 = kSysHz * 4 / wire::kBaud;

/// The PWM counts to 1000, so that a duty is a compare level. It runs at 490 Hz, as on the Mega for
/// which the L293D is wired.
const uint32_t kPwmTop = static_cast<uint32_t>(wire::kFullDuty) - 1;
const uint32_t kPwmDivider = 255;

/// Compare level of a duty of either sign.
inline uint16_t pwm_level(int16_t duty) {
  const uint16_t size = static_cast<uint16_t>(duty < 0 ? -duty : duty);
  const uint16_t full = static_cast<uint16_t>(wire::kFullDuty);
  return size < full ? size : full;
}

/// Reference of the ADC: the board's 3.3 V regulator.
const uint32_t kReferenceMv = 3300;
/// Ratio of the divider between battery and pin, as on a Mega: full scale is 9.9 V.
const uint32_t kDivider = 3;

/// Battery voltage for a conversion by the 12-bit ADC. [mV]
inline uint16_t battery_mv(uint16_t steps) {
  return static_cast<uint16_t>(kDivider * kReferenceMv * steps / 4096);
}

}  // namespace pico
}  // namespace firmware
}  // namespace tp100

#endif
