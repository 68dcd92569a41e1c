#include "sim/sensors/mpu6050.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "core/time.h"

namespace tp100::sim {

namespace {

constexpr std::uint8_t kSampleDivider = 0x19;
constexpr std::uint8_t kConfig = 0x1A;
constexpr std::uint8_t kGyroConfig = 0x1B;
constexpr std::uint8_t kAccelConfig = 0x1C;
constexpr std::uint8_t kIntStatus = 0x3A;
constexpr std::uint8_t kAccelOut = 0x3B;
constexpr std::uint8_t kTemperatureOut = 0x41;
constexpr std::uint8_t kGyroOut = 0x43;
constexpr std::uint8_t kPower = 0x6B;
constexpr std::uint8_t kWhoAmI = 0x75;

constexpr std::uint8_t kSleep = 0x40;
constexpr std::uint8_t kDeviceReset = 0x80;

constexpr double kRateHz = 1000.0;
// Bandwidth by DLPF_CFG, register map 4.3. Without the low-pass the sensor is faster than the 1 kHz
// at which it is emulated.
constexpr std::array<double, 8> kBandwidthHz = {256, 188, 98, 42, 20, 10, 5, 256};

int full_scale(std::uint8_t config) { return (config >> 3) & 3; }

}  // namespace

Mpu6050::Mpu6050(const course::EmulatedImu& values, std::uint64_t seed)
    : values_(values), random_(seed) {
  for (double& bias : gyro_bias_radps_) bias = values_.gyro_bias_radps * normal_(random_);
  for (double& bias : accel_bias_mps2_) bias = values_.accel_bias_mps2 * normal_(random_);
  power_on();
}

void Mpu6050::power_on() {
  registers_.fill(0);
  registers_[kPower] = kSleep;
  registers_[kWhoAmI] = kAddress;
  pointer_ = 0;
  until_output_ = 0;
}

double Mpu6050::temperature_degc(HostNs now_ns) const {
  const double warm = 1.0 - std::exp(-static_cast<double>(now_ns) * 1e-9 / values_.warm_up_s);
  return values_.start_temperature_degc + values_.warm_up_degc * warm;
}

double Mpu6050::filtered(double& state, double value, double noise_sd, double share) {
  state += (value + noise_sd * normal_(random_) - state) * share;
  return state;
}

void Mpu6050::put(std::uint8_t reg, double value) {
  const auto raw = static_cast<std::int16_t>(std::clamp(std::round(value), -32768.0, 32767.0));
  const auto bits = static_cast<std::uint16_t>(raw);
  registers_[reg] = static_cast<std::uint8_t>(bits >> 8);
  registers_[reg + 1u] = static_cast<std::uint8_t>(bits & 0xFF);
}

void Mpu6050::measure(const BodyState& body, HostNs now_ns) {
  const double temperature = temperature_degc(now_ns);
  const double warmer = temperature - values_.start_temperature_degc;
  for (double& bias : gyro_bias_radps_) {
    bias += values_.gyro_bias_walk_radps_rts * normal_(random_) / std::sqrt(kRateHz);
  }
  if ((registers_[kPower] & kSleep) != 0 || frozen_) return;

  const double bandwidth = kBandwidthHz[registers_[kConfig] & 7u];
  const double share = 1.0 - std::exp(-2.0 * kPi * bandwidth / kRateHz);
  const double per_sample = std::sqrt(kRateHz / 2.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const double scale = i == 2 ? 1.0 + values_.gyro_scale_error : 1.0;
    const double rate =
        body.rate_radps[i] * scale + gyro_bias_radps_[i] + values_.gyro_bias_per_degc * warmer;
    filtered(gyro_radps_[i], rate, values_.gyro_noise_radps_rthz * per_sample, share);
    filtered(accel_mps2_[i], body.specific_force_mps2[i] + accel_bias_mps2_[i],
             values_.accel_noise_mps2_rthz * per_sample, share);
  }
  if (until_output_-- > 0) return;
  // Without the low-pass the divider counts at 8 kHz, of which every eighth period is emulated.
  const std::uint8_t low_pass = registers_[kConfig] & 7u;
  const int divider = registers_[kSampleDivider];
  until_output_ = low_pass == 0 || low_pass == 7 ? std::max(0, (divider + 1) / 8 - 1) : divider;

  const double gyro_lsb =
      4.0 * kGyroLsbPerDegps / (1 << full_scale(registers_[kGyroConfig])) * kDegPerRad;
  const double accel_lsb =
      16384.0 / (1 << full_scale(registers_[kAccelConfig])) / kStandardGravityMps2;
  for (std::uint8_t i = 0; i < 3; ++i) {
    put(static_cast<std::uint8_t>(kAccelOut + 2 * i), accel_mps2_[i] * accel_lsb);
    put(static_cast<std::uint8_t>(kGyroOut + 2 * i), gyro_radps_[i] * gyro_lsb);
  }
  put(kTemperatureOut, (temperature - 36.53) * 340.0);
  registers_[kIntStatus] |= 1;
}

bool Mpu6050::write(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return true;
  pointer_ = bytes.front() & 0x7F;
  for (const std::uint8_t value : bytes.subspan(1)) {
    if (pointer_ == kPower && (value & kDeviceReset) != 0) {
      power_on();
      return true;
    }
    const bool measured = pointer_ >= kIntStatus && pointer_ < kPower - 1;
    if (!measured && pointer_ != kWhoAmI) registers_[pointer_] = value;
    pointer_ = (pointer_ + 1) & 0x7F;
  }
  return true;
}

bool Mpu6050::read(std::span<std::uint8_t> bytes) {
  for (std::uint8_t& value : bytes) {
    value = registers_[pointer_];
    if (pointer_ == kIntStatus) registers_[kIntStatus] = 0;
    pointer_ = (pointer_ + 1) & 0x7F;
  }
  return true;
}

}  // namespace tp100::sim
