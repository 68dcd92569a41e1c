// CRC-16/IBM-3740 (also called CCITT-FALSE): polynomial 0x1021, initial value 0xFFFF, not
// reflected, no final xor; check value of "123456789" is 0x29B1. Half-byte table: 32 bytes of flash
// on the Mega.
#ifndef TP100_WIRE_CRC16_H
#define TP100_WIRE_CRC16_H

#include <stddef.h>
#include <stdint.h>

#ifdef __AVR__
#include <avr/pgmspace.h>
#define TP100_WIRE_FLASH PROGMEM
#define TP100_WIRE_READ_WORD(address) pgm_read_word(address)
#else
#define TP100_WIRE_FLASH
#define TP100_WIRE_READ_WORD(address) (*(address))
#endif

namespace tp100 {
namespace wire {

const uint16_t kCrcInitial = 0xFFFF;

/// CRC of one more byte. Pure; about 40 cycles on an ATmega2560.
inline uint16_t crc16_update(uint16_t crc, uint8_t byte) {
  static const uint16_t table[16] TP100_WIRE_FLASH = {
      0x0000, 0x1021, 0x2042, 0x3063, 0x4084, 0x50A5, 0x60C6, 0x70E7,
      0x8108, 0x9129, 0xA14A, 0xB16B, 0xC18C, 0xD1AD, 0xE1CE, 0xF1EF};
  // In bytes: an AVR shifts a word by one place a cycle and more.
  uint8_t index = static_cast<uint8_t>(static_cast<uint8_t>((crc >> 8) ^ byte) >> 4);
  crc = static_cast<uint16_t>((crc << 4) ^ TP100_WIRE_READ_WORD(&table[index]));
  index = static_cast<uint8_t>((static_cast<uint8_t>(crc >> 8) >> 4) ^ byte) & 0x0F;
  crc = static_cast<uint16_t>((crc << 4) ^ TP100_WIRE_READ_WORD(&table[index]));
  return crc;
}

/// CRC of a whole buffer, starting from `crc`.
inline uint16_t crc16(const uint8_t* data, size_t size, uint16_t crc = kCrcInitial) {
  for (size_t i = 0; i < size; ++i) crc = crc16_update(crc, data[i]);
  return crc;
}

}  // namespace wire
}  // namespace tp100

#endif
