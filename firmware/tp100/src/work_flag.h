// Tells the sleeping main loop that there is work. It is one bit that a single instruction sets or
// tests, because idle() tests it after every interrupt.
#ifndef TP100_FIRMWARE_WORK_FLAG_H
#define TP100_FIRMWARE_WORK_FLAG_H

#if defined(__AVR__)

#include <avr/io.h>

namespace tp100 {
namespace firmware {

inline void raise_work() { GPIOR0 |= _BV(0); }
inline bool work_raised() { return (GPIOR0 & _BV(0)) != 0; }
inline void clear_work() { GPIOR0 &= static_cast<uint8_t>(~_BV(0)); }

}  // namespace firmware
}  // namespace tp100

#endif
#endif
