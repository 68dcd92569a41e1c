// Watches one belt for what only wiring or a blocked track can do: standing still under power, or
// moving against its duty.
#ifndef TP100_FIRMWARE_BELT_WATCH_H
#define TP100_FIRMWARE_BELT_WATCH_H

#include "wire/messages.h"

namespace tp100 {
namespace firmware {

class BeltWatch {
 public:
  enum Verdict : uint8_t { kGood, kStalled, kReversed };

  BeltWatch();
  /// Once a sample, with the duty that was applied since the last one. [thousandths, counts, ms]
  Verdict update(int16_t duty, int32_t counts, uint16_t dt_ms, const wire::Parameters& parameters);
  void reset() { sign_ = 0; }

 private:
  int8_t sign_;
  int32_t start_counts_;  // where the belt began to stand
  uint16_t standing_ms_;
  int32_t best_counts_;  // furthest along the duty
};

}  // namespace firmware
}  // namespace tp100

#endif
