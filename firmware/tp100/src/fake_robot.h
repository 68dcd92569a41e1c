// A TP100 on a level floor, small enough for the board itself: two motors, two encoders, an MPU6050
// and a battery.
#ifndef TP100_FIRMWARE_FAKE_ROBOT_H
#define TP100_FIRMWARE_FAKE_ROBOT_H

#include <stdint.h>

namespace tp100 {
namespace firmware {

/// Its values are those of the robot file end-loaded.toml. A track's speed is proportional to its
/// duty above the dead band and follows it with a time constant of 64 ms. Both tracks slip by the
/// same share, and the robot turns by the difference of their ground speeds over an equivalent
/// wheelbase. The sensors are noisy, because the firmware treats a sensor whose last digits never
/// change as broken.
class FakeRobot {
 public:
  /// Advances by one millisecond with these duties, -kFullDuty..kFullDuty.
  void step(int16_t left_duty, int16_t right_duty);

  /// Quadrature edges since construction.
  int32_t left_counts() const { return left_.counts; }
  int32_t right_counts() const { return right_.counts; }
  /// [mV]
  uint16_t battery_mv() const { return battery_mv_; }
  /// Reads registers of its MPU6050 as Hal::i2c_read does. The ranges are +-1000 deg/s and +-4 g
  /// whatever was configured. About 0.2 ms on a Mega.
  bool imu_read(uint8_t address, uint8_t reg, uint8_t* bytes, uint8_t size);

 private:
  struct Track {
    int32_t speed;  // counts per millisecond, in 65536ths
    uint16_t rest;  // fraction of the next count, in 65536ths
    int32_t counts;
    void step(int16_t duty);
  };
  void measure(uint8_t* bytes);
  int16_t noise();

  static constexpr uint16_t kBatteryMv = 7900;

  Track left_ = {};
  Track right_ = {};
  uint16_t battery_mv_ = kBatteryMv;
  int32_t measured_speed_ = 0;  // sum of both tracks' speeds when the IMU was last read
  uint16_t since_ms_ = 0;       // time since then
  uint16_t random_ = 1;
};

}  // namespace firmware
}  // namespace tp100

#endif
