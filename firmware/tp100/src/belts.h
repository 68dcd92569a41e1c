// From ground speed and turn rate to belt speeds (eqs 1 and 5 inverted) and their limits.
#ifndef TP100_FIRMWARE_BELTS_H
#define TP100_FIRMWARE_BELTS_H

#include "wire/messages.h"

namespace tp100 {
namespace firmware {

/// Belt speeds, forward positive. [m/s]
struct BeltSpeeds {
  float left;
  float right;
};

/// Belt speeds for a ground speed and a turn rate, within max_track_mps. What does not fit is taken
/// from the speed and not from the turn: a robot that cannot keep up still steers.
BeltSpeeds belt_speeds(float speed_mps, float yaw_rate_radps, const wire::Parameters& parameters);

/// `from` moved towards `to`, each belt by at most `step`. [m/s]
BeltSpeeds approach(const BeltSpeeds& from, const BeltSpeeds& to, float step);

}  // namespace firmware
}  // namespace tp100

#endif
