// Version of the firmware, as in the hello message.
#ifndef TP100_FIRMWARE_VERSION_H
#define TP100_FIRMWARE_VERSION_H

#include <stdint.h>

namespace tp100 {
namespace firmware {

const uint8_t kVersionMajor = 0;
const uint8_t kVersionMinor = 1;
const uint8_t kVersionPatch = 0;

}  // namespace firmware
}  // namespace tp100

#endif
