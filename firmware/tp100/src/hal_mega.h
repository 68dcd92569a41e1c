// The Hal of an Arduino Mega 2560.
//
//   Mega pin   port        to
//   2, 3       PE4, PE5    left encoder A, B   (INT4, INT5)
//   18, 19     PD3, PD2    right encoder A, B  (INT3, INT2)
//   6, 7       PH3, PH4    L293D enable 1,2 (left) and 3,4 (right), PWM of timer 4, 490 Hz
//   22, 23     PA0, PA1    L293D inputs 1, 2: left forward, left backward
//   24, 25     PA2, PA3    L293D inputs 3, 4: right forward, right backward
//   20, 21     PD1, PD0    MPU6050 SDA, SCL
//   A0         PF0         battery through a 1:3 divider; reference: USB's 5 V, see battery.h
//   USB                    host, 500000 baud 8N1
//
// Details and safety notes: firmware/WIRING.md.
#ifndef TP100_FIRMWARE_HAL_MEGA_H
#define TP100_FIRMWARE_HAL_MEGA_H

#if defined(__AVR__)

#include <avr/io.h>

#include "battery.h"
#include "hal.h"

namespace tp100 {
namespace firmware {

/// Tells the sleeping main loop that there is work. It is one bit that a single instruction sets or
/// tests, because idle() tests it after every interrupt.
inline void raise_work() { GPIOR0 |= _BV(0); }
inline bool work_raised() { return (GPIOR0 & _BV(0)) != 0; }
inline void clear_work() { GPIOR0 &= static_cast<uint8_t>(~_BV(0)); }

class MegaHal : public Hal {
 public:
  /// Switches the outputs off and the watchdog on, then does the rest. Call once, before any other
  /// call.
  void begin();

  uint32_t micros() override;
  uint8_t uart_read(uint8_t* bytes, uint8_t most) override;
  uint8_t uart_room() override;
  uint8_t uart_waiting() override;
  void uart_write(const uint8_t* bytes, uint8_t size) override;

  bool i2c_write(uint8_t address, uint8_t reg, uint8_t value) override;
  bool i2c_read(uint8_t address, uint8_t reg, uint8_t* bytes, uint8_t size) override;
  void i2c_recover() override;

  void counts(int32_t& left, int32_t& right) override;
  uint16_t missed_edges() override;
  void motors(int16_t left, int16_t right) override;
  uint16_t battery_mv() override;

  void kick_watchdog() override;
  uint32_t boot_nonce() override { return nonce_; }
  wire::ResetCause reset_cause() override;
  wire::BoardType board() override { return wire::BoardType::kMega2560; }

  uint8_t lock() override;
  void unlock(uint8_t saved) override;
  void idle() override;

 private:
  Supply supply_;
  uint16_t battery_mv_ = 0;
  uint8_t conversion_ = 0;  // of kConversions
  uint32_t nonce_ = 0;
};

}  // namespace firmware
}  // namespace tp100

#endif
#endif
