#pragma once
// A device on the I2C bus, seen from the bus.

#include <cstdint>
#include <span>

namespace tp100::sim {

class I2cSlave {
 public:
  virtual ~I2cSlave() = default;
  /// A write transfer; the first byte sets the register pointer. False: NACK.
  virtual bool write(std::span<const std::uint8_t> bytes) = 0;
  /// A read transfer from the register pointer on. False: NACK.
  virtual bool read(std::span<std::uint8_t> bytes) = 0;
};

}  // namespace tp100::sim
