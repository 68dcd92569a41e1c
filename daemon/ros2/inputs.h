#pragma once
// What ROS 2 programs may request of the daemon: the topics to which it subscribes, and the meaning
// of their messages. Pure. Treats messages as hostile.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/bytes.h"
#include "core/command.h"
#include "core/pose.h"
#include "core/time.h"
#include "ros2/topics.h"

namespace tp100::ros2 {

enum class Input : std::uint8_t {
  kVelocity,         ///< /cmd_vel, without a stamp
  kVelocityStamped,  ///< /cmd_vel, stamped
  kDrive,            ///< /tp100/drive: take the lease, or release it
  kInitialPose,      ///< /initialpose
  kGoal,             ///< /goal_pose: start a course that leads there
  kCourse,           ///< /tp100/course: start the course of that name
  kMark,             ///< /tp100/mark: this moment, for the recording
  kStop,             ///< /tp100/stop: last, so that it overrides what arrives with it
};
inline constexpr std::size_t kInputCount = static_cast<std::size_t>(Input::kStop) + 1;

struct InputText {
  Input input{};
  const char* name = "";  ///< with the leading slash; two types may have one name
  const MessageType* type = nullptr;
  Qos qos{};  ///< requested from the publisher
};

/// All of them, in the enum's order.
const std::array<InputText, kInputCount>& inputs();

/// A message as it arrived.
struct Received {
  Input input{};
  std::uint64_t writer = 0;     ///< no other writer of this domain has it
  std::int64_t written_ns = 0;  ///< Unix time by the writer's own clock
  std::int64_t taken_ns = 0;    ///< Unix time of arrival, by our clock
  std::span<const std::uint8_t> cdr{};
  bool gone = false;  ///< no message: no writer is left on this topic
};

/// A requested velocity.
struct VelocityRequest {
  double speed_mps = 0.0;       ///< backwards negative
  double yaw_rate_radps = 0.0;  ///< counter-clockwise positive
  std::int64_t stamp_ns = 0;    ///< when it was requested, by the sender's clock
};

// Each returns nothing, and sets `why` to one line, unless the message is a complete one of the
// input's type, with finite numbers in their ranges.
/// For kVelocity, and kVelocityStamped, whose stamp is used unless it is 0. Only linear.x and
/// angular.z have a meaning for tracks.
std::optional<VelocityRequest> read_velocity(const Received& received, std::string& why);
/// For kDrive.
std::optional<bool> read_drive(const Received& received, std::string& why);
/// For kInitialPose and kGoal: x, y and yaw in `map`.
std::optional<Pose> read_pose(const Received& received, std::string& why);
/// A course to start, and where the robot stands; see StartPlaces.
struct CourseStart {
  std::string name;
  OperatorRequest request = OperatorRequest::kStart;
};
/// For kCourse: "NAME", "NAME/start" or "NAME/here".
std::optional<CourseStart> read_course(const Received& received, std::string& why);

/// For kMark: the words, "mark" without any.
std::optional<std::string> read_mark(const Received& received, std::string& why);

/// Limit of the age of a message that starts the robot: the error of its writer's clock and the
/// delay.
inline constexpr std::int64_t kMaxAgeNs = 2 * kNsPerS;
/// Whether the message is within that limit; else `why` is set.
bool in_time(const Received& received, std::string& why);

}  // namespace tp100::ros2
