// The voltage of the board's supply, against which its ADC measures the cells.
//
// The reference is AVcc, USB's 5 V: 4.40 to 5.25 V at a device by USB 2.0. Taken for 5 V, cells of
// 5.28 V would read 6.0 V at 4.40 V. The chip's bandgap tells what AVcc is, as well as the bandgap
// itself is known: 1.0 to 1.2 V, typically 1.1 V (data sheet of ATmega640 to 2561, "System and
// Reset Characteristics"). It is taken for 1.1 V, and the supply for 5 V at most:
//   - cells never read higher than they would if 5 V were assumed;
//   - on a chip of 1.1 V they read right up to 5 V, and at most 5 % low above;
//   - on the chip farthest off they read 10 % high (1.0 V, below 4.55 V) or 8 % low (1.2 V).
#ifndef TP100_FIRMWARE_SUPPLY_H
#define TP100_FIRMWARE_SUPPLY_H

#include <stdint.h>

namespace tp100 {
namespace firmware {

const uint16_t kSupplyMv = 5000;
const uint16_t kBandgapMv = 1100;
/// Of the divider between the cells and the pin.
const uint8_t kDivider = 3;

class Supply {
 public:
  /// The bandgap, measured with AVcc as the reference; in steps of the 10-bit converter.
  void update(uint16_t steps) {
    if (steps == 0) return;
    const uint32_t mv = static_cast<uint32_t>(kBandgapMv) * 1024U / steps;
    // What one reading is off by its noise, four are less.
    sixteenths_ = known_ ? sixteenths_ - sixteenths_ / 4 + 4 * mv : 16 * mv;
    known_ = true;
  }
  /// kSupplyMv before the first update. [mV]
  uint16_t millivolts() const {
    const uint32_t mv = sixteenths_ / 16;
    return known_ && mv < kSupplyMv ? static_cast<uint16_t>(mv) : kSupplyMv;
  }
  /// The cells, by what the converter gives for the divider. [mV]
  uint16_t cells_mv(uint16_t steps) const {
    return static_cast<uint16_t>(static_cast<uint32_t>(kDivider) * millivolts() * steps / 1024);
  }

 private:
  uint32_t sixteenths_ = 0;
  bool known_ = false;
};

}  // namespace firmware
}  // namespace tp100

#endif
