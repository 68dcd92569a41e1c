// The Mega's first UART at 500000 baud, by interrupts, with rings that an index byte wraps.
// Arduino's Serial takes 126 cycles a sent byte, which is two fifths of the processor at this rate.
#ifndef TP100_FIRMWARE_UART_MEGA_H
#define TP100_FIRMWARE_UART_MEGA_H

#if defined(__AVR__)

#include <stdint.h>

namespace tp100 {
namespace firmware {
namespace uart_mega {

/// 8N1 at wire::kBaud, both directions on.
void begin();
/// Takes one received byte. False: nothing there.
bool read(uint8_t& byte);
/// True if a whole frame waits, or so many bytes that they should not wait for more.
bool worth_reading();
/// Bytes that write() takes now.
uint8_t room();
/// Bytes given to write() that are not yet in the shift register.
uint8_t waiting();
/// At most room() bytes.
void write(const uint8_t* bytes, uint8_t size);

}  // namespace uart_mega
}  // namespace firmware
}  // namespace tp100

#endif
#endif
