// The firmware on a Mega: the functions that the sketch calls.
#ifndef TP100_FIRMWARE_MEGA_H
#define TP100_FIRMWARE_MEGA_H

namespace tp100 {
namespace firmware {

/// Starts the board, then the firmware, then the 1 kHz interrupt.
void mega_setup();
void mega_loop();

}  // namespace firmware
}  // namespace tp100

#endif
