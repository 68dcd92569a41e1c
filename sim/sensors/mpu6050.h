#pragma once
// MPU6050 behind its register map (MPU-6000/6050 register map rev 4.2), as seen over I2C.

#include <array>
#include <cstdint>
#include <random>
#include <span>

#include "core/time.h"
#include "course/robot_file.h"
#include "sim/body/body.h"

namespace tp100::sim {

// A device on the I2C bus, seen from the bus.

class I2cSlave {
 public:
  virtual ~I2cSlave() = default;
  /// A write transfer; the first byte sets the register pointer. False: NACK.
  virtual bool write(std::span<const std::uint8_t> bytes) = 0;
  /// A read transfer from the register pointer on. False: NACK.
  virtual bool read(std::span<std::uint8_t> bytes) = 0;
};

/// One sensor: noise, bias, scale error and temperature of one robot and one seed.
class Mpu6050 : public I2cSlave {
 public:
  static constexpr std::uint8_t kAddress = 0x68;
  /// The gyro's own scale at +-1000 deg/s; its data sheet and the wire round it to 32.8.
  static constexpr double kGyroLsbPerDegps = 32.768;

  Mpu6050(const course::EmulatedImu& values, std::uint64_t seed);

  /// Measures the body at virtual time `now_ns`; called once per physics step (1 ms, the sensor's
  /// own rate with the low-pass on).
  void measure(const BodyState& body, HostNs now_ns);

  bool write(std::span<const std::uint8_t> bytes) override;
  bool read(std::span<std::uint8_t> bytes) override;
  /// Injects a defect: the registers keep their values from now on, the bus answers as before.
  void freeze(bool frozen = true) { frozen_ = frozen; }
  /// Power-on register values: asleep, +-250 deg/s, +-2 g.
  void power_on();

 private:
  /// First-order low-pass with white noise ahead of it.
  double filtered(double& state, double value, double noise_sd, double share);
  void put(std::uint8_t reg, double value);
  double temperature_degc(HostNs now_ns) const;

  course::EmulatedImu values_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  std::array<std::uint8_t, 128> registers_{};
  std::uint8_t pointer_ = 0;
  std::array<double, 3> gyro_bias_radps_{};
  std::array<double, 3> accel_bias_mps2_{};
  std::array<double, 3> gyro_radps_{};
  std::array<double, 3> accel_mps2_{};
  int until_output_ = 0;
  bool frozen_ = false;
};

}  // namespace tp100::sim
