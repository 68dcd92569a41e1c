// The Mega's first UART at 500000 baud, interrupt driven, with ring buffers of 256 bytes, whose
// 8-bit indices wrap by themselves. Arduino's Serial takes 126 cycles per byte sent, two fifths of
// the processor at this rate.
#ifndef TP100_FIRMWARE_UART_MEGA_H
#define TP100_FIRMWARE_UART_MEGA_H

#if defined(__AVR__)

#include <stdint.h>

namespace tp100 {
namespace firmware {
namespace uart_mega {

/// Configures 8N1 at wire::kBaud and enables both directions.
void begin();
/// See Hal::uart_read.
uint8_t read(uint8_t* bytes, uint8_t most);
/// True if a whole frame is waiting, or so many bytes that reading must not be delayed.
bool worth_reading();
/// Number of bytes that write() accepts now.
uint8_t room();
/// Number of bytes passed to write() that are not yet in the shift register.
uint8_t waiting();
/// Writes at most room() bytes.
void write(const uint8_t* bytes, uint8_t size);

}  // namespace uart_mega
}  // namespace firmware
}  // namespace tp100

#endif
#endif
