// The Hal of a bare Mega that simulates its robot: clock, UART and watchdog are the board's own,
// everything else is simulated.
#ifndef TP100_FIRMWARE_FAKE_MEGA_H
#define TP100_FIRMWARE_FAKE_MEGA_H

#if defined(__AVR__)

#include "fake_robot.h"
#include "hal_mega.h"

namespace tp100 {
namespace firmware {

/// The motor driver's pins stay low whatever the firmware commands.
class FakeMegaHal final : public MegaHal {
 public:
  bool i2c_write(uint8_t, uint8_t, uint8_t) override { return true; }
  bool i2c_read(uint8_t address, uint8_t reg, uint8_t* bytes, uint8_t size) override {
    return robot_.imu_read(address, reg, bytes, size);
  }
  void i2c_recover() override {}

  void counts(int32_t& left, int32_t& right) override {
    left = robot_.left_counts();
    right = robot_.right_counts();
  }
  uint16_t missed_edges() override { return 0; }
  void motors(int16_t left, int16_t right) override {
    const CriticalSection section(*this);
    left_duty_ = left;
    right_duty_ = right;
  }
  uint16_t battery_mv() override { return robot_.battery_mv(); }
  wire::BoardType board() override { return wire::BoardType::kFakeRobot; }

  /// Sleeps as a Mega's does, then lets the robot catch up with the clock.
  void idle() override {
    MegaHal::idle();
    const uint32_t now_us = micros();
    if (now_us - at_us_ > kLongestUs) at_us_ = now_us - kLongestUs;
    while (now_us - at_us_ >= 1000) {
      at_us_ += 1000;
      const uint8_t saved = lock();
      const int16_t left = left_duty_;
      const int16_t right = right_duty_;
      unlock(saved);
      robot_.step(left, right);
    }
  }

 private:
  static const uint16_t kLongestUs = 20000;

  FakeRobot robot_;
  volatile int16_t left_duty_ = 0;
  volatile int16_t right_duty_ = 0;
  uint32_t at_us_ = 0;
};

}  // namespace firmware
}  // namespace tp100

#endif
#endif
