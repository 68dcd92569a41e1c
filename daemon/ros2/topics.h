#pragma once
// The ROS 2 topics: their types and qualities of service, and their messages from the results of
// steps, for the network and for bags alike. Frames are those of REP-105.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "core/step_record.h"
#include "messages/messages.h"
#include "ros2/message_type.h"

namespace tp100::ros2 {

/// The course's frame, for poses that do not drift.
inline constexpr const char* kMap = "map";

enum class Topic : std::uint8_t {
  kOdometry,
  kTransforms,
  kStaticTransforms,
  kFusedPose,
  kImu,
  kJointStates,
  kBatteryState,
  kPath,
  kState,
  kRobotDescription,
  kMark,
  kGroundTruth,
  kClock,
};
inline constexpr std::size_t kTopicCount = static_cast<std::size_t>(Topic::kClock) + 1;

/// Quality of service that a publisher offers; its history keeps the last `depth` messages.
struct Qos {
  bool reliable = true;          ///< else best effort
  bool transient_local = false;  ///< late subscribers receive what is kept; else volatile
  int depth = 10;
};

struct TopicText {
  Topic topic{};
  const char* name = "";  ///< with the leading slash
  const MessageType* type = nullptr;
  Qos qos{};
};

/// All topics, in the enum's order.
const std::array<TopicText, kTopicCount>& topics();

/// Topics of the live daemon: all except those of simulations.
inline constexpr std::array kLiveTopics = {
    Topic::kOdometry, Topic::kTransforms,      Topic::kStaticTransforms, Topic::kFusedPose,
    Topic::kImu,      Topic::kJointStates,     Topic::kBatteryState,     Topic::kPath,
    Topic::kState,    Topic::kRobotDescription};

// kMark is in bags only: on the network /tp100/mark is what nodes send.

/// Additional topics of simulations.
inline constexpr std::array kVirtualTopics = {Topic::kGroundTruth, Topic::kClock};

/// Message of /ground_truth: the robot's true pose in the course's world.
Bytes ground_truth(std::uint64_t unix_ns, const Pose& pose);

/// What does not change during a run: /robot_description, /tf_static, and /path if there is a
/// course, which grows with its path up to some MB. Any thread that nobody waits for.
using SetupMessages = std::vector<std::pair<Topic, Bytes>>;
SetupMessages setup_messages(const messages::Messages& messages, HostNs at);

/// Messages of a run, each as CDR. One thread, not the real-time one.
class TopicMessages {
 public:
  using Send = std::function<void(Topic topic, Bytes cdr)>;

  /// `virtual_time`: also on /clock. The clock of headers is `clock`'s Unix time.
  TopicMessages(messages::RunContext run_context, messages::PublishClock clock, bool virtual_time);

  /// Another course, robot or set-up is in force.
  void exchange(messages::RunContext run_context);
  /// Sets the last answer to a node, for the next messages of /tp100/state.
  void answer(const messages::Event& answer);
  /// Sends setup_messages().
  void begin(HostNs at, const Send& send) const;
  /// Sends what follows from `record`. The robot's poses and measurements are stamped with the time
  /// at which they were measured; a step that received no sample sends none of them.
  void take(const StepRecord& record, const Send& send);

 private:
  bool state_is_due(const StepRecord& record);

  messages::Messages messages_;
  std::optional<messages::Event> answer_;
  bool virtual_time_;
  HostNs battery_due_ns_ = 0, state_due_ns_ = 0;
  std::tuple<SessionState, RunState, FaultMask> state_{};
};

}  // namespace tp100::ros2
