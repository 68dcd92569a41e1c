#pragma once
// The two-wire interface of the emulated Mega as a master (ATmega2560 datasheet, 24.7), with one
// sensor on the bus. It replaces simavr's own, which supports only one speed and no faults.

#include <cstdint>
#include <vector>

#include "sim/board/avr_core.h"
#include "sim/sensors/mpu6050.h"

struct avr_irq_t;
struct avr_twi_t;

namespace tp100::sim {

/// Faults of the bus.
enum class I2cFault {
  kNone,
  kSilent,  ///< no device acknowledges
  kHeld,    ///< the sensor holds SDA low until it has seen nine clocks
  kStuck,   ///< SDA permanently low
};

class AvrI2c {
 public:
  /// `slave` answers at `address`; null: no device answers.
  AvrI2c(AvrCore& core, I2cSlave* slave, std::uint8_t address);

  void set_fault(I2cFault fault);
  /// Call after a reset of the chip.
  void restore();

 private:
  enum class State { kIdle, kStarted, kSending, kReceiving, kRefused };

  static void on_control(avr_t*, std::uint16_t address, std::uint8_t value, void* i2c);
  static void on_pins(avr_irq_t*, std::uint32_t directions, void* i2c);
  static CpuCycles on_done(avr_t*, CpuCycles when, void* i2c);
  void control(std::uint8_t value);
  void begin_step(std::uint8_t value);
  void address_byte(std::uint8_t byte);
  void next_byte(std::uint8_t value);
  void finish_transfer();
  void complete(unsigned bits, std::uint8_t status);
  std::uint8_t take_byte();
  bool acknowledges(std::uint8_t address);

  AvrCore& core_;
  I2cSlave* slave_;
  std::uint8_t address_;
  avr_twi_t* twi_;
  I2cFault fault_ = I2cFault::kNone;
  State state_ = State::kIdle;
  std::uint8_t next_status_ = 0;
  std::uint8_t next_data_ = 0;
  std::uint8_t clocks_ = 0;
  bool clock_low_ = false;
  std::vector<std::uint8_t> written_;
  std::vector<std::uint8_t> latched_;
  std::size_t next_latched_ = 0;
};

}  // namespace tp100::sim
