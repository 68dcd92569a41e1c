#include "imu.h"

#include <string.h>

namespace tp100 {
namespace firmware {
namespace {

const uint8_t kSampleRateDivider = 0x19;
const uint8_t kConfig = 0x1A;
const uint8_t kGyroConfig = 0x1B;
const uint8_t kAccelConfig = 0x1C;
const uint8_t kPowerManagement1 = 0x6B;

struct Setting {
  uint8_t reg;
  uint8_t value;
};
const Setting kSettings[] = {
    {kPowerManagement1, 0x01},   // awake, clock from the x gyro
    {kSampleRateDivider, 0x00},  // 1 kHz
    // Low pass 44 Hz (accelerometer), 42 Hz (gyro): well below half the sample rate, or noise would
    // alias.
    {kConfig, 0x03},
    {kGyroConfig, 0x10},   // +-1000 deg/s
    {kAccelConfig, 0x08},  // +-4 g
};

int16_t word(const uint8_t* bytes) {
  return static_cast<int16_t>(static_cast<uint16_t>((bytes[0] << 8) | bytes[1]));
}

}  // namespace

void Imu::start() {
  started_ = false;
  wait_ = kRetrySamples;
  uint8_t identity = 0;
  bool good = hal_.i2c_read(kAddress, kWhoAmI, &identity, 1) && identity == kAddress;
  for (uint8_t i = 0; good && i < sizeof kSettings / sizeof kSettings[0]; ++i) {
    good = hal_.i2c_write(kAddress, kSettings[i].reg, kSettings[i].value);
  }
  if (!good) {
    ++errors_;
    if (failures_ < 255) ++failures_;
    return;
  }
  failures_ = 0;
  started_ = true;
}

void Imu::update() {
  if (!started_) {
    grow_old();
    if (wait_ > 0) {
      --wait_;
      return;
    }
    hal_.i2c_recover();
    start();
    return;
  }
  ImuValues values;
  if (!read(values)) {
    grow_old();
    ++errors_;
    if (++failures_ >= kStaleSamples) {
      started_ = false;
      wait_ = 0;
    } else if (failures_ % kFailuresBeforeRecovery == 0) {
      hal_.i2c_recover();
    }
    return;
  }
  failures_ = 0;
  if (age_ != kNever && memcmp(&values, &values_, sizeof values) == 0) {
    grow_old();
    // A sensor that lost its supply for a moment is in sleep mode: configure it again.
    if (age_ % kStaleSamples == 0) start();
    return;
  }
  values_ = values;
  age_ = 0;
}

bool Imu::read(ImuValues& values) {
  uint8_t bytes[kMeasuredBytes];
  if (!hal_.i2c_read(kAddress, kAccelXHigh, bytes, sizeof bytes)) return false;
  const uint8_t* from = bytes;
  for (uint8_t i = 0; i < 3; ++i, from += 2) {
    values.accel[i] = word(from);
    values.gyro[i] = word(from + 8);
  }
  values.temperature = word(bytes + 6);
  return true;
}

void Imu::grow_old() {
  if (age_ < kNever - 1) ++age_;
}

}  // namespace firmware
}  // namespace tp100
