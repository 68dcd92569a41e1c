// The inner yaw loop: propagates the yaw of the answered sample to the present and turns the yaw
// error into a turn rate, and that into track speeds (eqs 1 and 5 inverted) within their limits.
// Between commands only this loop steers.
#ifndef TP100_FIRMWARE_YAW_LOOP_H
#define TP100_FIRMWARE_YAW_LOOP_H

#include <stddef.h>
#include <stdint.h>

#include "shared/skid_steer.h"
#include "wire/messages.h"

namespace tp100 {
namespace firmware {

/// Rotation of the robot at one sample. Integrals since boot; only differences are meaningful.
struct TurnMark {
  uint32_t device_us;
  uint32_t gyro;  ///< integral of the raw z rate, LSB x 8 us, wraps
  int32_t left_counts;
  int32_t right_counts;
};

/// Track speeds, forward positive. [m/s]
typedef shared::TrackPair<float> TrackSpeeds;

/// Motion of both tracks at one sample.
struct TrackMotion {
  float left_m;  ///< since the sample before
  float right_m;
  TrackSpeeds speeds;  ///< mean over the last eight samples
};

/// Marks of the last samples, looked up by the sequence that a command answers.
class TurnHistory {
 public:
  /// Adds a sample. `gyro_z` is held over samples for which the IMU did not answer.
  void add(uint16_t sequence, uint32_t device_us, int16_t gyro_z, int32_t left_counts,
           int32_t right_counts);
  /// Mark of that sample, or null if it was never sent or has been overwritten.
  const TurnMark* find(uint16_t sequence) const;
  const TurnMark& newest() const { return newest_; }
  /// Motion up to the newest sample. What happened before the first sample is no motion.
  TrackMotion motion(float metres_per_count) const;
  /// Forgets all samples (a new session).
  void clear() { size_ = 0; }

 private:
  const TurnMark& ago(uint8_t samples) const;

  static const uint8_t kCapacity = 64;
  TurnMark marks_[kCapacity] = {};
  TurnMark newest_ = {};
  uint16_t last_sequence_ = 0;
  int16_t last_gyro_z_ = 0;
  uint8_t size_ = 0;
};

/// Rotation from `then` to `now`: by the gyro minus its bias if `use_gyro`, else by the tracks and
/// eq 5 (on a stand, where the body does not rotate). [rad]
float turned(const TurnMark& then, const TurnMark& now, bool use_gyro, float gyro_bias_radps,
             const wire::Parameters& parameters);

/// Turn rate that reduces `error_rad` (desired yaw - current yaw), limited to max_yaw_radps.
/// [rad/s]
float turn_rate(float error_rad, float feed_forward_radps, const wire::Parameters& parameters);

/// `from` moved towards `to`, each track by at most `step`. [m/s]
TrackSpeeds approach(const TrackSpeeds& from, const TrackSpeeds& to, float step);

}  // namespace firmware
}  // namespace tp100

#endif
