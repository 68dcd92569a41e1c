// Watches one belt for what only wiring or a blocked track can do: standing still under power,
// moving much less than its duty means, moving against it, or counts that jump.
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
  void reset() {
    sign_ = 0;
    known_ = false;
    jumped_ms_ = 0;
  }

 private:
  bool jumps_again(int32_t counts, uint16_t dt_ms, const wire::Parameters& parameters);
  bool missing(uint16_t size, int8_t sign, int32_t counts, uint16_t dt_ms,
               const wire::Parameters& parameters);

  bool known_;
  int32_t last_counts_;
  uint16_t jumped_ms_;  // until a jump is the first one again
  int8_t sign_;
  int32_t start_counts_;  // where the belt began to stand
  uint16_t standing_ms_;
  int32_t best_counts_;  // furthest along the duty
  // One step of many samples, and the way that the duty means beyond what was counted.
  int32_t step_counts_;
  uint32_t step_duty_ms_;
  uint16_t step_ms_;
  float missing_m_;
};

}  // namespace firmware
}  // namespace tp100

#endif
