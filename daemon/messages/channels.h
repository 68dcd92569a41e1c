#pragma once
// The channels of viewers and recordings: topic, schema, number of messages for a new subscriber;
// and the messages of those that follow from steps.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/estimates.h"
#include "messages/messages.h"

namespace tp100::messages {

/// Channels in the order of their ids (1 and up).
enum class Channel : std::uint32_t {
  kTransforms = 1,
  kPose,  ///< of the first estimate; the others follow, see pose_channel()
  kPoseTruth = kPose + static_cast<std::uint32_t>(kPoseSources.size()),
  kPath,
  kScene,
  kPathHistory,
  kLog,
  kEstimate,
  kSample,
  kCommand,
  kSlip,
  kLink,
  kLoop,
  kState,
  kCourse,
  kEvent,
  kParameter,
  kRecording,
  kCameraImage,
  kClient,
};

constexpr Channel pose_channel(PoseSource source) {
  return static_cast<Channel>(static_cast<std::uint32_t>(Channel::kPose) +
                              static_cast<std::uint32_t>(source));
}
inline constexpr auto kChannelCount = static_cast<std::uint32_t>(Channel::kClient);

struct ChannelText {
  Channel channel{};
  std::string topic;
  std::string schema_name;
  std::string schema;    ///< JSON schema
  std::size_t kept = 0;  ///< how many of the latest messages a new subscriber receives
};

/// All channels, ascending by id. The schemas are derived from example messages and from the tables
/// of names, so that they cannot differ from the messages sent. schemas.json beside this file has
/// them for those who make types of them.
std::vector<ChannelText> channel_texts();

/// Messages of one time: channel and JSON.
using SharedMessages = std::vector<std::pair<Channel, std::shared_ptr<const std::string>>>;

/// The messages of /course, /path and /scene at `at`, which grow with the path up to some MB. Any
/// thread that neither operator nor viewer waits for: where the course was loaded.
SharedMessages setup_messages(const Messages& messages, HostNs at);

/// The messages that follow from steps, for viewers and recordings alike. One thread.
class StepMessages {
 public:
  using Wanted = std::function<bool(Channel)>;
  using Send = std::function<void(Channel, HostNs at, std::string json)>;

  /// `recorded`: for a recording, which holds every step itself and therefore fewer poses.
  /// `messages` has to outlive it.
  StepMessages(const Messages& messages, bool recorded)
      : messages_(messages), recorded_(recorded) {}

  /// Takes the robot's true pose, which is used for the steps of the next second.
  void take_truth(const Truth& truth) {
    truth_ = truth;
    truth_is_new_ = true;
  }
  /// Sends what follows from `record` on the channels that are due and `wanted`.
  void take(const StepRecord& record, const Wanted& wanted, const Send& send);

 private:
  const Messages& messages_;
  bool recorded_;
  std::optional<Truth> truth_;
  bool truth_is_new_ = false;
  std::array<HostNs, kChannelCount> due_ns_{};
};

/// JSON schema of messages like `example`: an object without null fields. An empty array is taken
/// for an array of objects.
std::string schema_of(const std::string& title, const std::string& example);

}  // namespace tp100::messages
