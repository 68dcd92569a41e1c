// Monitors of the tracks and their encoders: each track by its duty, both together by the gyro.
#ifndef TP100_FIRMWARE_TRACK_MONITOR_H
#define TP100_FIRMWARE_TRACK_MONITOR_H

#include "wire/messages.h"
#include "yaw_loop.h"

namespace tp100 {
namespace firmware {

/// Monitors one track, or the mean of both, for what only wiring or a blocked track can cause:
/// standstill under power, much less motion than the duty implies, motion against the duty, or
/// counts that jump.
class TrackMonitor {
 public:
  enum Verdict : uint8_t { kGood, kStalled, kReversed };

  TrackMonitor();

  /// Call once per sample. `duty`: applied during the last `dt_ms` [thousandths]. `counts`: now.
  /// `load_duty`: duty that slopes and turns may take now, beyond straight level driving. [0..1]
  /// `free`: the robot drives straight on level ground, so that the duty of a speed can be learned.
  Verdict update(int16_t duty, int32_t counts, uint16_t dt_ms, float load_duty, bool free,
                 const wire::Parameters& parameters);
  /// A run begins: forgets what was learned about the track.
  void reset();
  /// Distance that the duty implies beyond what was counted and what the load explains. [m]
  float missing_m() const { return missing_m_; }

 private:
  bool again();
  bool jumps_again(int32_t counts, uint16_t dt_ms, const wire::Parameters& parameters);
  bool missing(uint16_t size, int8_t sign, int32_t counts, uint16_t dt_ms, float load_duty,
               bool free, const wire::Parameters& parameters);
  void learn(float above, float speed_duty, float load_duty, float step_s,
             const wire::Parameters& parameters);

  /// Values above it are not learned; a run begins with it.
  static constexpr float kMaxGain = 1.4f;

  bool known_ = false;
  int32_t last_counts_ = 0;
  uint16_t jumped_ms_ = 0;  // time left in which another jump is a repeated one
  int8_t sign_ = 0;
  int32_t start_counts_ = 0;  // where the standstill began
  uint16_t standing_ms_ = 0;
  int32_t first_counts_ = 0;  // when the duty last changed its sign
  int32_t best_counts_ = 0;   // furthest position in the direction of the duty
  bool went_back_ = false;    // by a jump, since best_counts_ was reached
  // Sums over one step of many samples.
  int32_t step_counts_ = 0;
  uint32_t step_duty_ms_ = 0;
  uint16_t step_ms_ = 0;
  float missing_m_ = 0.0f;     // distance that the duty implies beyond what was counted
  float gain_ = kMaxGain;      // duty that the track takes, relative to the parameters
  float learned_duty_ = 0.0f;  // duty by the parameters for the speed at which gain_ was learned
  float slow_duty_ = 0.0f;     // duty by the parameters for its speed, over some steps
};

/// Compares the rotation by the gyro with the rotation by the tracks. It finds an encoder that
/// loses counts: the yaw loop compensates for it, so that no duty shows it.
class TurnMonitor {
 public:
  /// Which track counts too little.
  enum Verdict : uint8_t { kGood, kLeftShort, kRightShort };

  /// Call once per sample while the gyro may be used; every eighth call judges. `accel_x` is the
  /// raw IMU value, `bias_radps` the gyro's bias.
  Verdict update(const TurnMark& now, int16_t accel_x, float bias_radps,
                 const wire::Parameters& parameters);
  /// Forgets everything before this call.
  void reset();
  /// Duty that one track may take for a slope or an obstacle, now or shortly before.
  float slope_duty() const { return slope_duty_; }
  /// Duty for scrubbing in a turn; the other track needs that much less if it runs in the same
  /// direction.
  float turn_duty() const { return turn_duty_; }

 private:
  void weigh(float turn_rad, float driven_rad, float elapsed_s);

  TurnMark then_ = {};
  float all_rad_ = 0.0f;   // gyro minus tracks, minus what slip explains
  float slow_rad_ = 0.0f;  // the same with its rate limited, so that a disturbance adds little
  bool level_known_ = false;
  float level_rad_ = 0.0f;  // pitch by the accelerometer when the robot started
  float slope_rad_ = 0.0f;
  float slope_duty_ = 0.0f;
  float turn_duty_ = 0.0f;
  float left_ = 0.0f;  // counts per step, less slip, averaged over some steps
  float right_ = 0.0f;
  int32_t accel_x_ = 0;  // sum over the step
  uint8_t samples_ = 0;
};

}  // namespace firmware
}  // namespace tp100

#endif
