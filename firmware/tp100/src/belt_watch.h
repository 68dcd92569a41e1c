// Watches one belt, or the mean of both, for what only wiring or a blocked track can do: standing
// still under power, moving much less than its duty means, moving against it, or counts that jump.
#ifndef TP100_FIRMWARE_BELT_WATCH_H
#define TP100_FIRMWARE_BELT_WATCH_H

#include "wire/messages.h"

namespace tp100 {
namespace firmware {

class BeltWatch {
 public:
  enum Verdict : uint8_t { kGood, kStalled, kReversed };

  BeltWatch();
  /// Once a sample, with the duty that was applied since the last one [thousandths, counts, ms].
  /// `load_duty`: what the floor may take of the duty now, beyond straight level driving. [0..1]
  Verdict update(int16_t duty, int32_t counts, uint16_t dt_ms, float load_duty,
                 const wire::Parameters& parameters);
  /// A run begins: nothing is known of the belt.
  void reset();
  /// Distance that the duty means beyond what was counted, and what load explains. [m]
  float missing_m() const { return missing_m_; }

 private:
  bool again();
  bool jumps_again(int32_t counts, uint16_t dt_ms, const wire::Parameters& parameters);
  bool missing(uint16_t size, int8_t sign, int32_t counts, uint16_t dt_ms, float load_duty,
               const wire::Parameters& parameters);
  void learn(float above, float speed_duty, float step_s, const wire::Parameters& parameters);

  bool known_;
  int32_t last_counts_;
  uint16_t jumped_ms_;  // until a jump is the first one again
  int8_t sign_;
  int32_t start_counts_;  // where the belt began to stand
  uint16_t standing_ms_;
  int32_t first_counts_;  // when the duty got its sign
  int32_t best_counts_;   // furthest along the duty
  bool went_back_;        // from there
  // One step of many samples, and the way that the duty means beyond what was counted.
  int32_t step_counts_;
  uint32_t step_duty_ms_;
  uint16_t step_ms_;
  float missing_m_;
  float gain_;       // duty that the belt takes, over what the parameters say
  float slow_duty_;  // that they say for its speed, over some steps
};

}  // namespace firmware
}  // namespace tp100

#endif
