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

  TurnWatch() : then_() { reset(); }
  /// Once a sample while the gyro may be used; judges every eighth. `accel_x` as the IMU has it,
  /// `bias_radps` of the gyro.
  Verdict update(const TurnMark& now, int16_t accel_x, float bias_radps,
                 const wire::Parameters& parameters);
  /// What was before does not count.
  void reset();
  /// Duty that one track may take for a slope or an obstacle, now or a moment ago.
  float slope_duty() const { return slope_duty_; }
  /// And for scrubbing the floor in a turn, which the other track is relieved of if it runs the
  /// same way.
  float turn_duty() const { return turn_duty_; }

 private:
  void weigh(float turn_rad, float driven_rad, float elapsed_s);

  TurnMark then_;
  float all_rad_;   // gyro less belts, less what slip explains
  float slow_rad_;  // the same of what does not come at once, as a push does
  bool level_known_;
  float level_rad_;  // by the accelerometer, when the robot began
  float slope_rad_;
  float slope_duty_;
  float turn_duty_;
  int32_t accel_x_;  // sum of the step
  uint8_t samples_;
};

}  // namespace firmware
}  // namespace tp100

#endif
