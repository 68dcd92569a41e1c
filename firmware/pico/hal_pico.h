// The Hal of a Raspberry Pi Pico (RP2040). Not tried on hardware yet.
//
//   Pico pin   to
//   GP0, GP1   UART 0 TX, RX: a USB serial adapter of 3.3 V, 500000 baud 8N1
//   GP4, GP5   MPU6050 SDA, SCL
//   GP6, GP7   left encoder A, B    (3.3 V)
//   GP8, GP9   right encoder A, B   (3.3 V)
//   GP10, 11   L293D inputs 1, 2: left forward, left backward
//   GP12, 13   L293D inputs 3, 4: right forward, right backward
//   GP14, 15   L293D enable 1,2 (left) and 3,4 (right), PWM slice 7, 490 Hz
//   GP26       battery through a 1:3 divider
//
// Details and safety notes: firmware/WIRING.md.
#ifndef TP100_FIRMWARE_HAL_PICO_H
#define TP100_FIRMWARE_HAL_PICO_H

#include "hal.h"

namespace tp100 {
namespace firmware {

class PicoHal final : public Hal {
 public:
  /// Clocks, outputs off, watchdog, then the rest. Call once, before any other call.
  void begin();
  /// Called by the interrupts of UART and encoders, and by the timer tick.
  void on_uart();
  void on_edge();
  void raise_work() { work_ = true; }
  /// Switches the motors off by the registers alone, for use after a processor fault.
  static void outputs_off();

  uint32_t micros() override;
  bool uart_read(uint8_t& byte) override;
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
  wire::BoardType board() override { return wire::BoardType::kRp2040; }

  uint8_t lock() override;
  void unlock(uint8_t saved) override;
  void idle() override;

 private:
  bool i2c_transfer(uint8_t address, const uint8_t* out, uint8_t out_size, uint8_t* in,
                    uint8_t in_size);

  uint32_t nonce_ = 0;
  uint16_t battery_mv_ = 0;
  volatile bool work_ = false;
};

}  // namespace firmware
}  // namespace tp100

#endif
