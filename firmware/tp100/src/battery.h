// The battery: its voltage by the ADC, filtered, and the cut-off.
#ifndef TP100_FIRMWARE_BATTERY_H
#define TP100_FIRMWARE_BATTERY_H

#include <stdint.h>

namespace tp100 {
namespace firmware {

const uint16_t kSupplyMv = 5000;
const uint16_t kBandgapMv = 1100;
/// Ratio of the divider between the battery and the pin.
const uint8_t kDivider = 3;

/// The voltage of the board's supply, against which its ADC measures the battery.
///
/// The reference is AVcc, USB's 5 V: 4.40 to 5.25 V at a device by USB 2.0. If it were taken for
/// 5 V, a battery of 5.28 V would read 6.0 V at 4.40 V. AVcc follows from the chip's bandgap, as
/// far as the bandgap itself is known: 1.0 to 1.2 V, typically 1.1 V (data sheet of ATmega640 to
/// 2561, "System and Reset Characteristics"). It is taken for 1.1 V, and the supply for 5 V at
/// most:
///   - the battery never reads higher than it would if 5 V were assumed;
///   - on a chip of 1.1 V it reads right up to 5 V, and at most 5 % low above;
///   - on the chip farthest off it reads 10 % high (1.0 V, below 4.55 V) or 8 % low (1.2 V).
class Supply {
 public:
  /// Takes a measurement of the bandgap against AVcc, in steps of the 10-bit converter.
  void update(uint16_t steps) {
    if (steps == 0) return;
    const uint32_t mv = static_cast<uint32_t>(kBandgapMv) * 1024U / steps;
    // Averaging four readings reduces the noise of a single one.
    sixteenths_ = known_ ? sixteenths_ - sixteenths_ / 4 + 4 * mv : 16 * mv;
    known_ = true;
  }
  /// Estimated supply voltage; kSupplyMv before the first update. [mV]
  uint16_t millivolts() const {
    const uint32_t mv = sixteenths_ / 16;
    return known_ && mv < kSupplyMv ? static_cast<uint16_t>(mv) : kSupplyMv;
  }
  /// Battery voltage for a conversion of the divider's output. [mV]
  uint16_t battery_mv(uint16_t steps) const {
    return static_cast<uint16_t>(static_cast<uint32_t>(kDivider) * millivolts() * steps / 1024);
  }

 private:
  uint32_t sixteenths_ = 0;
  bool known_ = false;
};

/// Filtered voltage and cut-off.
class Battery {
 public:
  /// Takes one reading; call once per sample. [mV]
  void update(uint16_t reading_mv, uint16_t cutoff_mv) {
    if (!started_) sixteenths_ = 16UL * reading_mv;
    started_ = true;
    sixteenths_ = sixteenths_ - sixteenths_ / 16 + reading_mv;
    if (millivolts() >= cutoff_mv) {
      low_samples_ = 0;
    } else if (low_samples_ < kLowSamples) {
      ++low_samples_;
    }
  }
  /// Voltage filtered over about 80 ms. [mV]
  uint16_t millivolts() const { return static_cast<uint16_t>(sixteenths_ / 16); }
  /// True while the voltage is below the cut-off.
  bool below() const { return low_samples_ > 0; }
  /// True once the voltage has been below the cut-off for a second.
  bool low() const { return low_samples_ >= kLowSamples; }

 private:
  static const uint8_t kLowSamples = 200;
  uint32_t sixteenths_ = 0;
  bool started_ = false;
  uint8_t low_samples_ = 0;
};

}  // namespace firmware
}  // namespace tp100

#endif
