// The Mega's two-wire interface as a master at 400 kHz. The processor sleeps while the bus works,
// whereas Arduino's Wire busy-waits for half a millisecond per sample.
#ifndef TP100_FIRMWARE_TWI_MEGA_H
#define TP100_FIRMWARE_TWI_MEGA_H

#if defined(__AVR__)

#include <stdint.h>

namespace tp100 {
namespace firmware {
namespace twi_mega {

/// Switches pull-ups and controller on.
void begin();
/// Switches controller and pull-ups off: the pins are plain ports again.
void end();
/// write() and read() make one transfer each and need interrupts enabled. They return false if the
/// device does not acknowledge or the transfer takes longer than 3 ms.
bool write(uint8_t address, const uint8_t* bytes, uint8_t size);
/// Writes the register's number, then reads after a repeated start.
bool read(uint8_t address, uint8_t reg, uint8_t* bytes, uint8_t size);

}  // namespace twi_mega
}  // namespace firmware
}  // namespace tp100

#endif
#endif
