// Speed loop of one track: feed-forward with dead band, proportional term on speed, integral term
// on the distance by which the track lags behind its target.
#ifndef TP100_FIRMWARE_SPEED_LOOP_H
#define TP100_FIRMWARE_SPEED_LOOP_H

#include <stdint.h>

#include "wire/messages.h"

namespace tp100 {
namespace firmware {

/// Gains of a session; what follows from the parameters is computed once.
struct SpeedGains {
  SpeedGains() = default;
  explicit SpeedGains(const wire::Parameters& parameters);

  float per_target = 0.0f;  ///< feed-forward and proportional term [duty per m/s]
  float per_speed = 0.0f;   ///< [duty per m/s]
  float per_lag = 0.0f;     ///< [duty per m]
  float dead_band = 0.0f;   ///< duty at which a track just moves
  float ramp = 0.0f;        ///< of the dead band around a standstill [duty per m/s]
};

class SpeedLoop {
 public:
  /// Takes the track's motion, see TurnHistory::motion(); call once per sample and in every state.
  void measure(float moved_m, float speed_mps) {
    moved_m_ = moved_m;
    speed_mps_ = speed_mps;
  }
  /// Duty for the target. It is 0, with a cleared integrator, once the target has been a standstill
  /// for 100 ms and the track stands still. Call after measure(). [-1, 1]
  float update(float target_mps, float dt_s, const SpeedGains& gains);
  /// Clears the integrator.
  void clear() {
    lag_m_ = 0.0f;
    standing_s_ = 0.0f;
  }
  float lag_m() const { return lag_m_; }

 private:
  float moved_m_ = 0.0f;
  float speed_mps_ = 0.0f;
  float lag_m_ = 0.0f;
  float standing_s_ = 0.0f;
};

}  // namespace firmware
}  // namespace tp100

#endif
