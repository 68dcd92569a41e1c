// A TP100 on a level floor, small enough for the board itself: two motors, two encoders, an MPU6050
// and a battery.
#ifndef TP100_FIRMWARE_FAKE_ROBOT_H
#define TP100_FIRMWARE_FAKE_ROBOT_H

#include <stdint.h>

namespace tp100 {
namespace firmware {

/// Its values are those of the robot file end-loaded.toml. A track follows its duty with a time
/// constant of 64 ms: from the dead band on, the speed grows in proportion. Both tracks slip by the
/// same share, and the robot turns by the difference of their ground speeds over an equivalent
/// wheelbase. The sensors are noisy: the firmware takes one whose last digits never change for a
/// broken one.
class FakeRobot {
 public:
  FakeRobot();
  /// A millisecond passes with these duties, -kFullDuty..kFullDuty.
  void step(int16_t left_duty, int16_t right_duty);

  /// Quadrature edges since construction.
  int32_t left_counts() const { return left_.counts; }
  int32_t right_counts() const { return right_.counts; }
  /// [mV]
  uint16_t battery_mv() const { return battery_mv_; }
  /// Reads registers of its MPU6050 as Hal::i2c_read does; +-1000 deg/s and +-4 g whatever was
  /// written. About 0.2 ms on a Mega.
  bool imu_read(uint8_t address, uint8_t reg, uint8_t* bytes, uint8_t size);

 private:
  struct Track {
    int32_t speed;  // counts per millisecond, in 65536ths
    uint16_t rest;  // of the next count, in 65536ths
    int32_t counts;
    void step(int16_t duty);
  };
  void measure(uint8_t* bytes);
  int16_t noise();

  Track left_;
  Track right_;
  uint16_t battery_mv_;
  int32_t measured_speed_;  // sum of both tracks' when the IMU was last read
  uint16_t since_ms_;       // since then
  uint16_t random_;
};

}  // namespace firmware
}  // namespace tp100

#endif
