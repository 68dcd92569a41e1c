#pragma once
// MPU6050 behind its register map (MPU-6000/6050 register map rev 4.2): what a firmware sees over
// I2C.

#include <array>
#include <cstdint>
#include <random>
#include <span>

#include "course/robot.h"
#include "sim/body/body.h"

namespace tp100::sim {

/// One sensor: noise, bias, scale error and temperature of one robot and one seed.
class Mpu6050 {
 public:
  static constexpr std::uint8_t kAddress = 0x68;

  Mpu6050(const course::EmulatedImu& values, std::uint64_t seed);

  /// Measures the body at virtual time `now_ns`; called once per physics step.
  void measure(const BodyState& body, std::int64_t now_ns);

  /// I2C write of `bytes` starting at the register in bytes[0]. False: NACK.
  bool write(std::span<const std::uint8_t> bytes);
  /// I2C read from the register pointer on, auto-increment. False: NACK.
  bool read(std::span<std::uint8_t> bytes);
  /// Power-on register values.
  void power_on();

 private:
  course::EmulatedImu values_;
  std::mt19937_64 random_;
  std::array<std::uint8_t, 128> registers_{};
  // the rest is up to the implementation
};

}  // namespace tp100::sim
