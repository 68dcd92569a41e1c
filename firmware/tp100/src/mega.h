// The firmware on a Mega: what the sketch calls.
#ifndef TP100_FIRMWARE_MEGA_H
#define TP100_FIRMWARE_MEGA_H

namespace tp100 {
namespace firmware {

/// Board, firmware, then the 1 kHz interrupt.
void mega_setup();
void mega_loop();

}  // namespace firmware
}  // namespace tp100

#endif
