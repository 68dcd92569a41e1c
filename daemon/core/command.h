#pragma once
// What the bridge asks of the robot in one step.

#include <cstdint>

#include "core/pose.h"
#include "core/time.h"

namespace tp100 {

/// One command. The link adds boot nonce and sequence and turns it into bytes.
struct Command {
  std::uint16_t answers = 0;     ///< sequence of the sample that `pose` belongs to
  DeviceUs answered_us = 0;      ///< device time of that sample
  Pose pose{};                   ///< steering estimate at that sample
  double desired_yaw_rad = 0.0;  ///< unwrapped, same branch as pose.yaw_rad
  double yaw_rate_radps = 0.0;   ///< feed-forward turn rate
  double speed_mps = 0.0;        ///< ground speed of the reference point
  double gyro_bias_radps = 0.0;  ///< z axis
  DeviceUs expiry_us = 0;        ///< device time after which the robot must not use it
};

/// One-shot requests to the robot; the link repeats them until they are acknowledged.
enum class RobotRequest : std::uint8_t { kNone, kArm, kDisarm, kStop };

/// What became of the last arm or disarm that was asked of the robot.
enum class RequestAnswer : std::uint8_t {
  kNone,          ///< nothing yet, or nothing was asked
  kAcknowledged,  ///< the robot accepted it
  kFailed,        ///< the robot refused it, or did not acknowledge it in time
};

/// What an operator (keyboard, page, --go, signal) asks of the bridge.
enum class OperatorRequest : std::uint8_t {
  kStart,  ///< arm and begin the course from where the robot stands
  kHold,   ///< disarm, keep the session
  kStop,   ///< latch STOP on the robot; only kStart ends it
};

}  // namespace tp100
