// Speed loop of one track: feed-forward with dead band, proportional term on speed, integral term
// on the distance by which the track lags behind its target.
#ifndef TP100_FIRMWARE_SPEED_LOOP_H
#define TP100_FIRMWARE_SPEED_LOOP_H

#include <stdint.h>

#include "wire/messages.h"

namespace tp100 {
namespace firmware {

class SpeedLoop {
 public:
  /// Takes the track position; call once per sample and in every state. [counts]
  void measure(int32_t counts, uint16_t dt_us, const wire::Parameters& parameters);
  /// Duty for the target. It is 0, with a cleared integrator, once the target has been a standstill
  /// for 100 ms and the track stands still. Call after measure(). [-1, 1]
  float update(float target_mps, float dt_s, const wire::Parameters& parameters);
  /// Clears the integrator.
  void reset() {
    lag_m_ = 0.0f;
    standing_s_ = 0.0f;
  }
  /// Forgets the track position (new parameters).
  void restart() { measured_ = 0; }
  /// Track speed, mean over the last eight samples. [m/s]
  float speed_mps() const { return speed_mps_; }
  float lag_m() const { return lag_m_; }

 private:
  static const uint8_t kWindow = 8;
  int32_t counts_[kWindow] = {};
  uint16_t dt_us_[kWindow] = {};
  int32_t sum_counts_ = 0;
  uint32_t sum_us_ = 0;
  float counts_per_metre_ = 0.0f;  // the value that metres_per_count_ was computed from
  float metres_per_count_ = 0.0f;
  float mps_per_count_us_ = 0.0f;
  uint8_t next_ = 0;
  uint8_t measured_ = 0;
  int32_t last_counts_ = 0;
  float moved_m_ = 0.0f;
  float speed_mps_ = 0.0f;
  float lag_m_ = 0.0f;
  float standing_s_ = 0.0f;
};

}  // namespace firmware
}  // namespace tp100

#endif
