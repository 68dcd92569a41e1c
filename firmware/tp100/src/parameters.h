// Checks of the parameters that the daemon sends.
#ifndef TP100_FIRMWARE_PARAMETERS_H
#define TP100_FIRMWARE_PARAMETERS_H

#include "wire/messages.h"

namespace tp100 {
namespace firmware {

/// Index (0-based, in message order) of the first field that is not finite or out of the range
/// documented in wire/messages.h; 0 if all are good, since the nonce is not checked here.
uint8_t bad_field(const wire::Parameters& parameters);

/// True if the gyro propagates the yaw.
inline bool uses_gyro(const wire::Parameters& parameters) {
  return (parameters.flags & wire::kUseGyro) != 0;
}

}  // namespace firmware
}  // namespace tp100

#endif
