#pragma once
// The channels of viewers and recordings: topic, schema, number of messages for a new subscriber.

#include <cstdint>
#include <string>
#include <vector>

#include "core/estimates.h"

namespace tp100::messages {

/// Channels in the order of their ids (1 and up).
enum class Channel : std::uint32_t {
  kTransforms = 1,
  kPoseModel,
  kPoseOdometry,
  kPoseFused,
  kPoseTruth,
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
  kClient,
};

/// The channel of each estimate's pose.
inline constexpr PerSource<Channel> kPoseChannels = {
    {Channel::kPoseModel, Channel::kPoseOdometry, Channel::kPoseFused}};
static_assert(kPoseChannels.values.back() != Channel{}, "a source without a channel");
inline constexpr std::uint32_t kChannelCount = 21;

struct ChannelText {
  Channel channel{};
  std::string topic;
  std::string schema_name;
  std::string schema;    ///< JSON schema
  std::size_t kept = 0;  ///< how many of the latest messages a new subscriber receives
};

/// All channels, ascending by id. The schemas are derived from example messages, so that they
/// cannot differ from the messages sent.
std::vector<ChannelText> channel_texts();

/// JSON schema of messages like `example`: an object without null fields. An empty array is taken
/// for an array of objects.
std::string schema_of(const std::string& title, const std::string& example);

}  // namespace tp100::messages
