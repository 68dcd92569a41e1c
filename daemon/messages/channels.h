#pragma once
// The channels that viewers and recordings see: topic, schema, what a new subscriber gets.

#include <cstdint>
#include <string>
#include <vector>

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
  kTrail,
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
inline constexpr std::uint32_t kChannelCount = 21;

struct ChannelText {
  Channel channel{};
  std::string topic;
  std::string schema_name;
  std::string schema;    ///< JSON schema
  std::size_t kept = 0;  ///< how many of the last messages a new subscriber gets
};

/// All of them, ascending by id. The schemas come from example messages, so that they cannot drift
/// from what is sent.
std::vector<ChannelText> channel_texts();

/// JSON schema of messages like `example`: an object, none of whose fields is null. An empty array
/// is taken for one of objects.
std::string schema_of(const std::string& title, const std::string& example);

}  // namespace tp100::messages
