#pragma once
// The firmware built for this machine, with a Mega's timing: virtual time, a 64-byte receive
// buffer, byte times, blocking I2C bursts and a clock that is off by some ppm. The same inputs give
// the same bytes.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/time.h"
#include "sim/board/board.h"
#include "sim/sensors/mpu6050.h"

namespace tp100::sim {

/// One board.
struct NativeBoardSettings {
  std::uint64_t seed = 1;            ///< seed of the boot nonces
  double clock_ppm = 0.0;            ///< error of the resonator; positive runs fast
  std::uint32_t start_us = 0;        ///< device clock at each boot [us]
  HostNs boot_delay_ns = 4'000'000;  ///< from reset to setup(); bytes are lost meanwhile
};

/// Counts since construction.
struct NativeBoardCounters {
  std::uint64_t rx_overruns = 0;  ///< bytes that found the receive buffer full
  std::uint64_t rx_lost_in_boot = 0;
  std::uint64_t boots = 0;
  std::uint64_t loops = 0;
};

class NativeBoard final : public Board {
 public:
  /// `imu` answers at I2C address 0x68; null: no device answers. It must outlive the board. The
  /// board has no power until the first reset().
  NativeBoard(const NativeBoardSettings& settings, I2cSlave* imu);
  ~NativeBoard() override;
  NativeBoard(NativeBoard&&) noexcept;
  NativeBoard& operator=(NativeBoard&&) noexcept;

  void reset(PowerUp cause, HostNs now_ns) override;
  void advance(HostNs until_ns, std::span<const EncoderEdge> edges,
               std::span<const TimedByte> received) override;
  std::vector<TimedByte> take_sent() override;
  MotorDuty motor_duty() const override;
  void set_battery(double volts) override;
  void set_supply(double volts) override;

  NativeBoardCounters counters() const;
  /// Device clock at the end of the last quantum, wraps. [us]
  std::uint32_t device_us() const;

 private:
  struct Machine;
  std::unique_ptr<Machine> machine_;
};

}  // namespace tp100::sim
