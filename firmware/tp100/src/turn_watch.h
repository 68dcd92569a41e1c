// Watches the turn by the gyro against the turn by the belts: an encoder that loses counts is made
// up for by the yaw loop, and no duty shows it.
#ifndef TP100_FIRMWARE_TURN_WATCH_H
#define TP100_FIRMWARE_TURN_WATCH_H

#include "yaw_loop.h"

namespace tp100 {
namespace firmware {

class TurnWatch {
 public:
  /// Which belt is counted short.
  enum Verdict : uint8_t { kGood, kLeftShort, kRightShort };

  TurnWatch() : then_(), all_rad_(0.0f), slow_rad_(0.0f), samples_(0) {}
  /// Once a sample while the gyro may be used; judges every eighth. `bias_radps` of the gyro.
  Verdict update(const TurnMark& now, float bias_radps, const wire::Parameters& parameters);
  /// What was before does not count.
  void reset();

 private:
  TurnMark then_;
  float all_rad_;   // gyro less belts, less what slip explains
  float slow_rad_;  // the same of what does not come at once, as a push does
  uint8_t samples_;
};

}  // namespace firmware
}  // namespace tp100

#endif
