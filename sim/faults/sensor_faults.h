#pragma once
// Faults of encoders and IMU.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/time.h"
#include "sim/faults/fault.h"
#include "sim/sensors/mpu6050.h"
#include "sim/sensors/quadrature_encoder.h"

namespace tp100::sim {

/// Faults between the encoders and the pins.
class EncoderFaults {
 public:
  explicit EncoderFaults(const std::vector<PlannedFault>& faults);
  /// Applies the faults to the `edges` of the quantum from `from_ns`, in order of time. Time plus
  /// `shift_ns` is the time since the port was opened.
  void pass(std::vector<EncoderEdge>& edges, HostNs from_ns, HostNs shift_ns);

 private:
  void jump(std::vector<EncoderEdge>& edges, HostNs from_ns, std::uint8_t first_channel,
            int& cycles);

  /// Phases of one side's encoder as the counter sees them, once edges were lost.
  struct Slipping {
    bool began = false;
    double kept = 0.0;  ///< part of an edge that is still to be passed on, signed
    std::array<bool, 2> levels{};
  };
  struct Planned {
    PlannedFault fault;
    std::array<int, 2> cycles;  ///< phases still to be generated, signed
    std::array<Slipping, 2> slipping{};
  };
  void lose(std::vector<EncoderEdge>& edges, HostNs shift_ns, Planned& planned) const;

  std::vector<Planned> faults_;
  std::array<bool, 4> levels_{};
};

/// Faults between the IMU and the bus.
class ImuFaults : public I2cSlave {
 public:
  explicit ImuFaults(I2cSlave& imu) : imu_(imu) {}

  void set_missing(bool missing) { missing_ = missing; }
  void set_saturated(bool saturated) { saturated_ = saturated; }

  bool write(std::span<const std::uint8_t> bytes) override;
  bool read(std::span<std::uint8_t> bytes) override;

 private:
  I2cSlave& imu_;
  bool missing_ = false;
  bool saturated_ = false;
  std::uint8_t pointer_ = 0;
};

}  // namespace tp100::sim
