#include "ros2/bag.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "core/error.h"
#include "record/mcap_writer.h"
#include "ros2/message_types.h"
#include "ros2/topics.h"
#include "text/atomic_file.h"
#include "text/json_writer.h"

namespace tp100::ros2 {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kChunkBytes = std::size_t{1} << 20U;

// Readers since Humble accept this version; later versions have more fields, which this bag lacks.
constexpr int kMetadataVersion = 5;

/// As rosbag2 writes it: enums of rmw as numbers, the largest duration for no limit.
std::string qos_text(const Qos& qos) {
  const std::string endless = "\n    sec: 9223372036\n    nsec: 854775807\n";
  return "- history: 1\n  depth: " + std::to_string(qos.depth) +
         "\n  reliability: " + (qos.reliable ? "1" : "2") +
         "\n  durability: " + (qos.transient_local ? "1" : "2") + "\n  deadline:" + endless +
         "  lifespan:" + endless + "  liveliness: 1\n  liveliness_lease_duration:" + endless +
         "  avoid_ros_namespace_conventions: false";
}

/// `text` in double quotes: a JSON string is valid YAML.
std::string quoted(const std::string& text) {
  std::string out;
  text::JsonWriter(out).value(text);
  return out;
}

class Bag {
 public:
  Bag(const std::string& path, const messages::RunContext& run_context, bool simulated)
      : file_(path),
        writer_(file_, "tp100 " + run_context.version, record::McapCompression::kZstd, "ros2") {
    std::map<const MessageType*, std::uint16_t> schemas;
    for (const TopicText& topic : topics()) {
      const bool live = std::ranges::find(kLiveTopics, topic.topic) != kLiveTopics.end();
      if (!live && !simulated && topic.topic != Topic::kMark) continue;
      const auto [schema, is_new] = schemas.emplace(topic.type, std::uint16_t{});
      if (is_new)
        schema->second = writer_.add_schema(
            {std::string(topic.type->name), "ros2msg", std::string(topic.type->schema)});
      const std::uint16_t id =
          writer_.add_channel(schema->second, topic.name, "cdr",
                              {{"offered_qos_profiles", qos_text(topic.qos)},
                               {"topic_type_hash", std::string(topic.type->hash)}});
      channels_.emplace(topic.topic, Channel{topic, id});
    }
  }

  void write(Topic topic, std::uint64_t unix_ns, const Bytes& cdr) {
    Channel& channel = channels_.at(topic);
    ++channel.messages;
    begin_ns_ = std::min(begin_ns_.value_or(unix_ns), unix_ns);
    end_ns_ = std::max(end_ns_, unix_ns);
    writer_.message(channel.id, unix_ns, cdr);
    if (writer_.open_bytes() > kChunkBytes) writer_.end_chunk();
  }

  void finish() {
    writer_.finish();
    if (file_.error() != 0)
      throw UserError(file_.path() + ": cannot be written (" + std::strerror(file_.error()) +
                      "); check free space");
  }

  /// Content of metadata.yaml.
  std::string metadata() const {
    const std::string name = quoted(fs::path(file_.path()).filename().string());
    const std::uint64_t begin_ns = begin_ns_.value_or(0);
    std::uint64_t count = 0;
    std::string list;
    for (const auto& [topic, channel] : channels_) {
      count += channel.messages;
      list += "    - topic_metadata:\n        name: " + std::string(channel.text.name) +
              "\n        type: " + std::string(channel.text.type->name) +
              "\n        serialization_format: cdr\n        offered_qos_profiles: " +
              quoted(qos_text(channel.text.qos)) +
              "\n      message_count: " + std::to_string(channel.messages) + "\n";
    }
    // The facts that the bag and its only file have in common.
    const auto facts = [&](const std::string& indent) {
      return indent + "starting_time:\n" + indent +
             "  nanoseconds_since_epoch: " + std::to_string(begin_ns) + "\n" + indent +
             "duration:\n" + indent +
             "  nanoseconds: " + std::to_string(std::max(end_ns_, begin_ns) - begin_ns) + "\n" +
             indent + "message_count: " + std::to_string(count) + "\n";
    };
    return "rosbag2_bagfile_information:\n  version: " + std::to_string(kMetadataVersion) +
           "\n  storage_identifier: mcap\n" + facts("  ") + "  topics_with_message_count:\n" +
           list + "  compression_format: \"\"\n  compression_mode: \"\"\n" +
           "  relative_file_paths:\n    - " + name + "\n  files:\n    - path: " + name + "\n" +
           facts("      ");
  }

 private:
  struct Channel {
    TopicText text;
    std::uint16_t id = 0;
    std::uint64_t messages = 0;
  };

  record::RecordingFile file_;
  record::McapWriter writer_;
  std::map<Topic, Channel> channels_;
  std::optional<std::uint64_t> begin_ns_;
  std::uint64_t end_ns_ = 0;
};

}  // namespace

std::vector<std::string> write_bag(const record::Recording& recording,
                                   const messages::RunContext& run_context, const Marks& marks,
                                   const std::string& folder) {
  text::make_folder(folder);
  // rosbag2 names the file after its folder.
  const fs::path place = fs::weakly_canonical(folder);
  const std::string path = (fs::path(folder) / (place.filename().string() + "_0.mcap")).string();
  const std::string metadata = (fs::path(folder) / "metadata.yaml").string();
  const bool simulated = recording.fact("program").starts_with("tp100-sim");
  const messages::PublishClock clock{.start_ns = recording.start_ns(),
                                     .start_unix_ns = recording.start_unix_ns()};
  Bag bag(path, run_context, simulated);
  TopicMessages messages(run_context, clock, simulated);
  HostNs now = recording.start_ns();
  const TopicMessages::Send write = [&](Topic topic, const Bytes& cdr) {
    bag.write(topic, clock.unix_ns(now), cdr);
  };
  auto write_marks = [&, next = marks.begin()](std::uint64_t until_ns) mutable {
    for (; next != marks.end() && next->first <= until_ns; ++next)
      bag.write(Topic::kMark, next->first, serialized(std_msgs::String{.data = next->second}));
  };
  bool begun = false;
  recording.visit({.step =
                       [&](const StepRecord& record) {
                         now = record.now_ns;
                         if (!std::exchange(begun, true)) messages.begin(now, write);
                         write_marks(clock.unix_ns(now));
                         messages.take(record, write);
                       },
                   .truth =
                       [&](HostNs at, const Pose& truth) {
                         if (simulated)
                           write(Topic::kGroundTruth, ground_truth(clock.unix_ns(at), truth));
                       }});
  write_marks(std::numeric_limits<std::uint64_t>::max());
  bag.finish();
  text::write_file(metadata, bag.metadata());
  return {path, metadata};
}

}  // namespace tp100::ros2
