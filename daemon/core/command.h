#pragma once
// What the bridge requests of the robot in one step, and the requests and inputs that reach it.

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/enum_names.h"
#include "core/pose.h"
#include "core/time.h"

namespace tp100 {

/// One command. The link adds boot nonce and sequence and turns it into bytes. Its x and y and its
/// yaws are in different frames: x and y on the robot's own floor, both yaws in the course's world.
/// An external world that owns the pose can rotate one against the other; virtual ramps and blocks
/// shift only the position.
struct Command {
  std::uint16_t answers = 0;  ///< sequence of the sample that `pose` belongs to
  DeviceUs answered_us = 0;   ///< device time of that sample
  Pose pose{};  ///< steering pose at that sample: x, y on the floor, yaw in the course's world
  double desired_yaw_rad = 0.0;  ///< unwrapped, same frame and branch as pose.yaw_rad
  double yaw_rate_radps = 0.0;   ///< feed-forward turn rate
  double speed_mps = 0.0;        ///< ground speed of the reference point
  double gyro_bias_radps = 0.0;  ///< z axis
  DeviceUs expiry_us = 0;        ///< device time after which the robot must not use it
};

/// One-shot requests to the robot; the link repeats them until they are acknowledged.
enum class RobotRequest : std::uint8_t { kNone, kArm, kDisarm, kStop };

/// Outcome of the last arm or disarm request.
enum class RequestAnswer : std::uint8_t {
  kNone,          ///< no answer yet, or no request
  kAcknowledged,  ///< the robot accepted it
  kFailed,        ///< the robot refused it, or did not acknowledge it in time
};

/// An operator's request to the bridge (by keyboard, page, --go or signal).
enum class OperatorRequest : std::uint8_t {
  kStart,        ///< arm and begin the course, at whose start the robot is known to stand
  kHold,         ///< disarm, keep the session
  kStop,         ///< latch STOP on the robot; only a start or kDrive clears it
  kContinue,     ///< as kStart, but from where the robot is estimated to be
  kDrive,        ///< arm for driving by hand; the estimated poses continue
  kPause,        ///< slow down on the course to a standstill; the robot stays armed
  kResume,       ///< drive on after a pause
  kStartPlaced,  ///< as kStart; a person says that the robot stands at the start
};

/// Whether the request can make motors turn, and so needs a person's consent (core/consent.h).
constexpr bool moves(OperatorRequest request) {
  return request == OperatorRequest::kStart || request == OperatorRequest::kContinue ||
         request == OperatorRequest::kDrive || request == OperatorRequest::kResume ||
         request == OperatorRequest::kStartPlaced;
}

/// Names as in the events of a run.
inline constexpr std::array<EnumName<OperatorRequest>, 8> kOperatorRequestNames = {{
    {OperatorRequest::kStart, "start"},
    {OperatorRequest::kHold, "hold"},
    {OperatorRequest::kStop, "STOP"},
    {OperatorRequest::kContinue, "continue"},
    {OperatorRequest::kDrive, "drive by hand"},
    {OperatorRequest::kPause, "pause"},
    {OperatorRequest::kResume, "resume"},
    {OperatorRequest::kStartPlaced, "start, placed"},
}};
constexpr const char* to_string(OperatorRequest request) {
  return name_in(kOperatorRequestNames, request);
}

/// A driver's input that is older than this is ignored, and the robot stops.
inline constexpr HostNs kFreshInputNs = 150 * kNsPerMs;

/// The speeds that a driver requests. It never arms the robot: it is used only while the robot is
/// driven by hand.
struct VelocityInput {
  HostNs at_ns = 0;             ///< when the person gave it
  double speed_mps = 0.0;       ///< ground speed, backwards negative
  double yaw_rate_radps = 0.0;  ///< counter-clockwise positive
};

// A parameter that changes while the bridge runs: an input of the step like any other, so that a
// recording replays it.

/// The parameters that can change. Their numbers are fixed, because recordings contain them.
enum class LiveParameter : std::uint8_t {
  kSteering = 0,  ///< a PoseSource; ignored during a run
  kPreview = 1,
  kCrossTrackGain = 2,
  kMaxApproach = 3,
  kAcceleration = 4,
  kMinSpeed = 5,
  kPivotRate = 6,
  kPivotAcceleration = 7,
};
inline constexpr std::size_t kLiveParameters = 8;

struct ParameterChange {
  LiveParameter parameter = LiveParameter::kSteering;
  double value = 0.0;  ///< SI
};

}  // namespace tp100
