// The cells: filtered voltage and the cut-off.
#ifndef TP100_FIRMWARE_BATTERY_H
#define TP100_FIRMWARE_BATTERY_H

#include <stdint.h>

namespace tp100 {
namespace firmware {

class Battery {
 public:
  /// One reading, once a sample. [mV]
  void update(uint16_t reading_mv, uint16_t cutoff_mv);
  /// Filtered over about 80 ms. [mV]
  uint16_t millivolts() const { return static_cast<uint16_t>(sixteenths_ / 16); }
  /// Below the cut-off right now.
  bool below() const { return low_samples_ > 0; }
  /// Below the cut-off for a second.
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
