#include "ros2/inputs.h"

#include <cmath>
#include <initializer_list>

#include "core/error.h"
#include "core/start_rule.h"
#include "core/upright.h"
#include "ros2/message_types.h"
#include "text/format.h"

namespace tp100::ros2 {
namespace {

// Faster than any robot, and larger than any room.
constexpr double kMaxVelocity = 100.0, kMaxPlaceM = 100.0;
constexpr std::int64_t kMaxStampNs = std::int64_t{1} << 62U;
constexpr std::size_t kMaxShown = 64, kLongestName = 64, kLongestMark = 80;

bool finite(std::initializer_list<double> values) {
  for (const double value : values)
    if (!std::isfinite(value)) return false;
  return true;
}

bool finite(const geometry_msgs::Vector3& v) { return finite({v.x, v.y, v.z}); }

template <class Message>
std::optional<Message> message_of(const Received& received, std::string& why) {
  std::optional<Message> message = deserialized<Message>(received.cdr);
  if (!message) why = "no " + std::string(Message::kType.name) + " in little-endian CDR";
  return message;
}

std::optional<VelocityRequest> velocity_of(const geometry_msgs::Twist& twist, std::int64_t stamp_ns,
                                           std::string& why) {
  if (stamp_ns <= 0 || stamp_ns >= kMaxStampNs) {
    why = "a velocity without the time at which it was sent";
    return std::nullopt;
  }
  if (finite(twist.linear) && finite(twist.angular) && std::abs(twist.linear.x) <= kMaxVelocity &&
      std::abs(twist.angular.z) <= kMaxVelocity)
    return VelocityRequest{twist.linear.x, twist.angular.z, stamp_ns};
  why = "a velocity is not finite, or above 100 m/s or rad/s";
  return std::nullopt;
}

std::optional<Pose> pose_of(const std_msgs::Header& header, const geometry_msgs::Pose& pose,
                            std::string& why) {
  if (!header.frame_id.empty() && header.frame_id != kMap) {
    why = "a pose in frame '" + one_line(header.frame_id, kMaxShown) + "'; give it in 'map'";
    return std::nullopt;
  }
  const geometry_msgs::Point& at = pose.position;
  const geometry_msgs::Quaternion& q = pose.orientation;
  const std::optional<double> yaw_rad = upright_yaw({q.x, q.y, q.z, q.w});
  if (!yaw_rad) {
    why = "a pose whose quaternion x y z w has not length 1, or turns the robot over";
    return std::nullopt;
  }
  if (!finite({at.x, at.y, at.z, *yaw_rad}) || std::abs(at.x) > kMaxPlaceM ||
      std::abs(at.y) > kMaxPlaceM) {
    why = "a pose that is not finite, or farther than 100 m";
    return std::nullopt;
  }
  return Pose{.x_m = at.x, .y_m = at.y, .yaw_rad = *yaw_rad};
}

}  // namespace

const std::array<InputText, kInputCount>& inputs() {
  // Best effort, because only the newest velocity counts and an old one must not be sent again.
  static const std::array<InputText, kInputCount> kInputs = {{
      {Input::kVelocity, "/cmd_vel", &geometry_msgs::Twist::kType, {.reliable = false}},
      {Input::kVelocityStamped,
       "/cmd_vel",
       &geometry_msgs::TwistStamped::kType,
       {.reliable = false}},
      {Input::kDrive, "/tp100/drive", &std_msgs::Bool::kType, {}},
      {Input::kInitialPose, "/initialpose", &geometry_msgs::PoseWithCovarianceStamped::kType, {}},
      {Input::kGoal, "/goal_pose", &geometry_msgs::PoseStamped::kType, {}},
      {Input::kCourse, "/tp100/course", &std_msgs::String::kType, {}},
      {Input::kMark, "/tp100/mark", &std_msgs::String::kType, {}},
      {Input::kStop, "/tp100/stop", &std_msgs::Empty::kType, {}},
  }};
  return kInputs;
}

std::optional<VelocityRequest> read_velocity(const Received& received, std::string& why) {
  if (received.input == Input::kVelocity) {
    if (const auto twist = message_of<geometry_msgs::Twist>(received, why))
      return velocity_of(*twist, received.written_ns, why);
  } else if (const auto stamped = message_of<geometry_msgs::TwistStamped>(received, why)) {
    const builtin_interfaces::Time& stamp = stamped->header.stamp;
    const std::int64_t stamp_ns = stamp.sec * kNsPerS + stamp.nanosec;
    return velocity_of(stamped->twist, stamp_ns == 0 ? received.written_ns : stamp_ns, why);
  }
  return std::nullopt;
}

std::optional<bool> read_drive(const Received& received, std::string& why) {
  const auto message = message_of<std_msgs::Bool>(received, why);
  return message ? std::optional(message->data) : std::nullopt;
}

std::optional<Pose> read_pose(const Received& received, std::string& why) {
  if (received.input == Input::kGoal) {
    if (const auto goal = message_of<geometry_msgs::PoseStamped>(received, why))
      return pose_of(goal->header, goal->pose, why);
  } else if (const auto at = message_of<geometry_msgs::PoseWithCovarianceStamped>(received, why)) {
    return pose_of(at->header, at->pose.pose, why);
  }
  return std::nullopt;
}

std::optional<CourseStart> read_course(const Received& received, std::string& why) {
  const auto message = message_of<std_msgs::String>(received, why);
  if (!message) return std::nullopt;
  CourseStart start{.name = message->data};
  const std::size_t where = start.name.rfind('/') + 1;
  const auto request = start_request(std::string_view(start.name).substr(where));
  if (where > 0 && where < start.name.size() && request) {
    start.name.resize(where - 1);
    start.request = *request;
  }
  if (!start.name.empty() && start.name.size() <= kLongestName) return start;
  why = "the name of a course has 1 to 64 characters";
  return std::nullopt;
}

std::optional<std::string> read_mark(const Received& received, std::string& why) {
  const auto message = message_of<std_msgs::String>(received, why);
  if (!message) return std::nullopt;
  const std::string text = message->data.empty() ? "mark" : message->data;
  if (text.size() <= kLongestMark && one_line(text) == text) return text;
  why = "a mark has at most 80 characters of ASCII";
  return std::nullopt;
}

bool in_time(const Received& received, std::string& why) {
  if (received.written_ns <= 0 || received.written_ns >= kMaxStampNs) {
    why = "the message does not say when it was sent";
    return false;
  }
  const std::int64_t age_ns = received.taken_ns - received.written_ns;
  if (age_ns <= kMaxAgeNs && age_ns >= -kMaxAgeNs) return true;
  why = text::format(
      "sent %.1f s ago by the clock of its sender, but at most 2 s are accepted; send it again, or "
      "synchronise both machines' clocks",
      to_s(age_ns));
  return false;
}

}  // namespace tp100::ros2
