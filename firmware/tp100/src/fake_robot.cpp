#include "fake_robot.h"

#include <string.h>

#include "imu.h"

namespace tp100 {
namespace firmware {
namespace {

const int16_t kDeadBand = 90;  // thousandths
// For each thousandth of duty above the dead band: 1/3400 m/s, at 11140 counts per metre.
const int32_t kSpeedPerDuty = 215;
// A track below this speed is held by friction.
const int32_t kHeldSpeed = 256;
const float kMpsPerSpeed = 1.0f / (65536.0f * 11.14f);
const float kSlip = 0.16f;
const float kWheelbaseM = 0.2742f;
const float kDegPerRad = 57.29578f;
const float kGravityMps2 = 9.80665f;
const float kGyroLsbPerRadps = kDegPerRad * wire::kGyroLsbPerDegps;
const float kAccelLsbPerMps2 = wire::kAccelLsbPerG / kGravityMps2;
// Bias of the z axis, of the size that a real gyro has.
const int16_t kGyroBias = 13;
const float kTemperatureDegc = 27.0f;

void put(uint8_t* bytes, int16_t value) {
  bytes[0] = static_cast<uint8_t>(static_cast<uint16_t>(value) >> 8);
  bytes[1] = static_cast<uint8_t>(value & 0xFF);
}

int16_t lsb(float value) { return static_cast<int16_t>(value < 0 ? value - 0.5f : value + 0.5f); }

int16_t size_of(int16_t duty) { return static_cast<int16_t>(duty < 0 ? -duty : duty); }

}  // namespace

void FakeRobot::Track::step(int16_t duty) {
  const int16_t above = static_cast<int16_t>(size_of(duty) - kDeadBand);
  int32_t target = above > 0 ? kSpeedPerDuty * above : 0;
  if (duty < 0) target = -target;
  speed += (target - speed) / 64;
  if (target == 0 && speed < kHeldSpeed && speed > -kHeldSpeed) speed = 0;
  const int32_t moved = speed + rest;
  // Rounds down on both boards and hosts, so that the rest stays positive.
  const int32_t whole = moved >> 16;
  counts = static_cast<int32_t>(static_cast<uint32_t>(counts) + static_cast<uint32_t>(whole));
  rest = static_cast<uint16_t>(moved & 0xFFFF);
}

void FakeRobot::step(int16_t left_duty, int16_t right_duty) {
  left_.step(left_duty);
  right_.step(right_duty);
  const uint16_t load = static_cast<uint16_t>(size_of(left_duty) + size_of(right_duty));
  battery_mv_ = static_cast<uint16_t>(kBatteryMv - load / 4);
  if (since_ms_ < 1000) ++since_ms_;
}

bool FakeRobot::imu_read(uint8_t address, uint8_t reg, uint8_t* bytes, uint8_t size) {
  if (address != Imu::kAddress) return false;
  memset(bytes, 0, size);
  if (reg == Imu::kWhoAmI && size == 1) bytes[0] = Imu::kAddress;
  if (reg == Imu::kAccelXHigh && size == Imu::kMeasuredBytes) measure(bytes);
  return true;
}

void FakeRobot::measure(uint8_t* bytes) {
  const float ground = 1.0f - kSlip;
  const int32_t sum = left_.speed + right_.speed;
  const float mean_mps = 0.5f * ground * kMpsPerSpeed * static_cast<float>(sum);
  const float rate_radps =
      ground * kMpsPerSpeed / kWheelbaseM * static_cast<float>(right_.speed - left_.speed);
  float forward_mps2 = 0.0f;
  if (since_ms_ > 0) {
    forward_mps2 = 0.5f * 1000.0f * ground * kMpsPerSpeed *
                   static_cast<float>(sum - measured_speed_) / static_cast<float>(since_ms_);
  }
  measured_speed_ = sum;
  since_ms_ = 0;
  const int16_t values[] = {
      static_cast<int16_t>(lsb(forward_mps2 * kAccelLsbPerMps2) + 8 * noise()),
      static_cast<int16_t>(lsb(mean_mps * rate_radps * kAccelLsbPerMps2) + 8 * noise()),
      static_cast<int16_t>(lsb(wire::kAccelLsbPerG) + 8 * noise()),
      lsb((kTemperatureDegc - wire::kTemperatureOffsetDegc) * wire::kTemperatureLsbPerDegc),
      noise(),
      noise(),
      static_cast<int16_t>(lsb(rate_radps * kGyroLsbPerRadps) + kGyroBias + noise()),
  };
  for (const int16_t value : values) {
    put(bytes, value);
    bytes += sizeof value;
  }
}

// -3 to 3, middle values more often.
int16_t FakeRobot::noise() {
  random_ = static_cast<uint16_t>(random_ * 25173U + 13849U);
  const uint8_t high = static_cast<uint8_t>(random_ >> 8);
  return static_cast<int16_t>((high & 3) + ((high >> 2) & 3) - 3);
}

}  // namespace firmware
}  // namespace tp100
