// What the daemon may ask the firmware to believe.
#ifndef TP100_FIRMWARE_PARAMETERS_H
#define TP100_FIRMWARE_PARAMETERS_H

#include "wire/messages.h"

namespace tp100 {
namespace firmware {

/// Position (0-based, in the order of the message) of the first field that is not finite or out of
/// the range documented in wire/messages.h; 0 if all are good, since the nonce is not checked here.
uint8_t bad_field(const wire::Parameters& parameters);

/// True if the gyro carries the yaw forward.
inline bool uses_gyro(const wire::Parameters& parameters) {
  return (parameters.flags & wire::kUseGyro) != 0;
}

}  // namespace firmware
}  // namespace tp100

#endif
