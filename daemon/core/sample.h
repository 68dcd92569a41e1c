#pragma once
// What the robot measured, in SI units: one decoded sample frame.

#include <array>
#include <cstdint>

#include "core/faults.h"
#include "core/time.h"

namespace tp100 {

/// Robot states, as on the wire (wire/messages.h).
enum class RobotState : std::uint8_t { kHello, kParameters, kDisarmed, kArmed, kRunning, kFaulted };

/// One sample. Counts and times are extended to 64 bit and never wrap within a boot.
struct Sample {
  std::uint16_t sequence = 0;     ///< as on the wire; commands answer it
  std::uint32_t lost_before = 0;  ///< samples missing between this one and the one before
  DeviceUs device_us = 0;         ///< when it was measured, robot's clock
  HostNs measured_ns = 0;         ///< the same instant on the host's clock, by clock sync
  std::int64_t left_counts = 0;   ///< encoder edges
  std::int64_t right_counts = 0;
  std::array<double, 3> gyro_radps{};  ///< body axes x, y, z; nominal scale, bias included
  std::array<double, 3> accel_mps2{};  ///< specific force, body axes
  double temperature_degc = 0.0;
  double battery_v = 0.0;  ///< both cells together
  double left_duty = 0.0;  ///< -1..1, as applied
  double right_duty = 0.0;
  RobotState state = RobotState::kHello;
  FaultMask faults = 0;            ///< latched by the robot
  std::uint16_t last_command = 0;  ///< sequence of the last command that it accepted
  std::uint8_t imu_age = 255;      ///< samples since the IMU values were new; 0 is fresh
};

/// The robot says that its motors are enabled.
inline bool enabled(const Sample& sample) {
  return sample.state == RobotState::kArmed || sample.state == RobotState::kRunning;
}

/// It is enabled or has a duty. Tracks that turn without either are turned by somebody's hand.
inline bool motors_on(const Sample& sample) {
  return enabled(sample) || sample.left_duty != 0.0 || sample.right_duty != 0.0;
}

}  // namespace tp100
