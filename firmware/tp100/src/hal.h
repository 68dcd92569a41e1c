// The hardware as the firmware sees it: the only layer between it and a Mega, an emulated board or
// a test. No call blocks except the I2C calls, which give up after 3 ms.
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

  /// Takes at most `most` received bytes, and none behind a wire::kDelimiter. Returns how many.
  virtual uint8_t uart_read(uint8_t* bytes, uint8_t most) = 0;
  /// Number of bytes that uart_write accepts without blocking.
  virtual uint8_t uart_room() = 0;
  /// Number of bytes passed to uart_write that have not been sent yet.
  virtual uint8_t uart_waiting() = 0;
  /// Writes at most uart_room() bytes.
  virtual void uart_write(const uint8_t* bytes, uint8_t size) = 0;

  /// Writes `value` to a register of an I2C device. False: not acknowledged or timed out.
  virtual bool i2c_write(uint8_t address, uint8_t reg, uint8_t value) = 0;
  /// Reads `size` registers (at most 32) from `reg` on. False: not acknowledged or timed out.
  virtual bool i2c_read(uint8_t address, uint8_t reg, uint8_t* bytes, uint8_t size) = 0;
  /// Frees a bus that a device holds low and restarts the controller.
  virtual void i2c_recover() = 0;

  /// Quadrature edges since boot, both read at the same instant; positive: A leads B.
  virtual void counts(int32_t& left, int32_t& right) = 0;
  /// Number of times since boot that both phases of an encoder changed at once, summed over both
  /// encoders; wraps. Each time, the count of that encoder is off by two or more.
  virtual uint16_t missed_edges() = 0;
  /// Duties of the two driver channels, -kFullDuty..kFullDuty. Callable from the timer interrupt.
  virtual void motors(int16_t left, int16_t right) = 0;
  /// Latest battery reading behind the divider. [mV]
  virtual uint16_t battery_mv() = 0;

  virtual void kick_watchdog() = 0;
  /// Differs at every boot; the firmware replaces 0.
  virtual uint32_t boot_nonce() = 0;
  virtual wire::ResetCause reset_cause() = 0;
  virtual wire::BoardType board() = 0;

  /// Disables interrupts until the matching unlock(). Nests.
  virtual uint8_t lock() = 0;
  virtual void unlock(uint8_t saved) = 0;
  /// May sleep until the next interrupt.
  virtual void idle() = 0;

 protected:
  ~Hal() = default;
};

/// Disables interrupts during its lifetime.
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
