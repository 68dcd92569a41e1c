// The hardware as the firmware sees it: the only thing between it and a Mega, an emulated board or
// a test. No call blocks except the I2C ones, which give up after 3 ms.
#ifndef TP100_FIRMWARE_HAL_H
#define TP100_FIRMWARE_HAL_H

#include <stdint.h>

#include "wire/messages.h"

namespace tp100 {
namespace firmware {

class Hal {
 public:
  /// Device clock, wraps. Callable from the timer interrupt. [us]
  virtual uint32_t micros() = 0;

  /// Takes one received byte. False: nothing there.
  virtual bool uart_read(uint8_t& byte) = 0;
  /// Bytes that uart_write takes without blocking.
  virtual uint8_t uart_room() = 0;
  /// Bytes that uart_write was given and that have not left yet.
  virtual uint8_t uart_waiting() = 0;
  /// At most uart_room() bytes.
  virtual void uart_write(const uint8_t* bytes, uint8_t size) = 0;

  /// Writes `value` to a register of an I2C device. False: not acknowledged or timed out.
  virtual bool i2c_write(uint8_t address, uint8_t reg, uint8_t value) = 0;
  /// Reads `size` registers (at most 32) from `reg` on. False: not acknowledged or timed out.
  virtual bool i2c_read(uint8_t address, uint8_t reg, uint8_t* bytes, uint8_t size) = 0;
  /// Frees a bus that a device holds and starts the controller anew.
  virtual void i2c_recover() = 0;

  /// Quadrature edges since boot, both read at one instant; positive: A leads B.
  virtual void counts(int32_t& left, int32_t& right) = 0;
  /// Times since boot that both phases of an encoder had changed at once, for both encoders
  /// together; wraps. Each leaves the count of that encoder off by two or more.
  virtual uint16_t missed_edges() = 0;
  /// Duties of the two driver channels, -kFullDuty..kFullDuty. Callable from the timer interrupt.
  virtual void motors(int16_t left, int16_t right) = 0;
  /// Newest reading of the cells behind the divider. [mV]
  virtual uint16_t battery_mv() = 0;

  virtual void kick_watchdog() = 0;
  /// Differs at every boot; 0 is replaced by the firmware.
  virtual uint32_t boot_nonce() = 0;
  virtual wire::ResetCause reset_cause() = 0;
  virtual wire::Board board() = 0;

  /// Keeps interrupts out until unlock(lock()). Nests.
  virtual uint8_t lock() = 0;
  virtual void unlock(uint8_t saved) = 0;
  /// May sleep until the next interrupt.
  virtual void idle() = 0;

 protected:
  ~Hal() = default;
};

/// Interrupts are off while one of these lives.
class CriticalSection {
 public:
  explicit CriticalSection(Hal& hal) : hal_(hal), saved_(hal.lock()) {}
  ~CriticalSection() { hal_.unlock(saved_); }
  CriticalSection(const CriticalSection&) = delete;
  CriticalSection& operator=(const CriticalSection&) = delete;

 private:
  Hal& hal_;
  uint8_t saved_;
};

}  // namespace firmware
}  // namespace tp100

#endif
