// MPU6050 over I2C (MPU-6000/6050 register map rev 4.2). It never blocks the main loop: a device
// that does not answer is tried again every 105 ms.
#ifndef TP100_FIRMWARE_IMU_H
#define TP100_FIRMWARE_IMU_H

#include "hal.h"

namespace tp100 {
namespace firmware {

/// Raw values in register order from 0x3B on.
struct ImuValues {
  int16_t accel[3];
  int16_t temperature;
  int16_t gyro[3];
};

class Imu {
 public:
  static const uint8_t kAddress = 0x68;
  static const uint8_t kWhoAmI = 0x75;
  /// First of the registers that hold what was measured, and their number.
  static const uint8_t kAccelXHigh = 0x3B;
  static const uint8_t kMeasuredBytes = 14;
  static const uint8_t kNever = 255;

  explicit Imu(Hal& hal) : hal_(hal) {}
  /// Identifies and configures the sensor: gyro +-1000 deg/s, accelerometer +-4 g, 1 kHz, low pass
  /// of 42 Hz. About 1 ms.
  void start();
  /// Reads all values; call once per sample.
  void update();

  const ImuValues& values() const { return values_; }
  /// Number of samples since the values were new; 0 fresh, kNever before the first.
  uint8_t age() const { return age_; }
  /// True if the sensor never answered, or if another device answers at its address.
  bool missing() const { return age_ == kNever && !started_ && failures_ > 0; }
  /// True if there were no new values for ten samples: the sensor stopped answering, or its values
  /// no longer change. The last digits of a working sensor are noisy.
  bool stale() const { return age_ != kNever && age_ >= kStaleSamples; }
  /// True if the values are recent enough to integrate.
  bool fresh() const { return age_ < kStaleSamples; }
  uint16_t errors() const { return errors_; }

 private:
  static const uint8_t kStaleSamples = 10;
  static const uint8_t kRetrySamples = 20;
  static const uint8_t kFailuresBeforeRecovery = 3;

  bool read(ImuValues& values);
  void grow_old();

  Hal& hal_;
  ImuValues values_ = {};
  bool started_ = false;
  uint8_t age_ = kNever;
  uint8_t failures_ = 0;
  uint8_t wait_ = 0;
  uint16_t errors_ = 0;
};

}  // namespace firmware
}  // namespace tp100

#endif
