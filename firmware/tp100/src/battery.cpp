#include "battery.h"

namespace tp100 {
namespace firmware {

void Battery::update(uint16_t reading_mv, uint16_t cutoff_mv) {
  if (!started_) sixteenths_ = 16UL * reading_mv;
  started_ = true;
  sixteenths_ = sixteenths_ - sixteenths_ / 16 + reading_mv;
  if (millivolts() >= cutoff_mv) {
    low_samples_ = 0;
  } else if (low_samples_ < kLowSamples) {
    ++low_samples_;
  }
}

}  // namespace firmware
}  // namespace tp100
