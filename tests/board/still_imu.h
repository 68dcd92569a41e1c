#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/sensors/mpu6050.h"

namespace tp100::sim {

/// An MPU6050 at standstill, with a little noise.
class StillImu final : public I2cSlave {
 public:
  bool write(std::span<const std::uint8_t> bytes) override {
    if (!answers) return false;
    pointer_ = bytes[0];
    return true;
  }
  bool read(std::span<std::uint8_t> bytes) override {
    if (!answers) return false;
    ++reads_;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const std::size_t reg = pointer_ + i;
      bytes[i] = reg == 0x75 ? 0x68 : reg == 0x3C ? static_cast<std::uint8_t>(reads_ % 5) : 0;
    }
    return true;
  }
  bool answers = true;

 private:
  std::size_t pointer_ = 0;
  unsigned reads_ = 0;
};

}  // namespace tp100::sim
