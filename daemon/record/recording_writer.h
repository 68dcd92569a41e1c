#pragma once
// What a recording holds, written into an MCAP file: steps, truth and what viewers see. One thread.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/step_record.h"
#include "messages/channels.h"
#include "messages/messages.h"
#include "record/mcap_writer.h"

namespace tp100::record {

// What only recordings have.
inline constexpr const char* kStepTopic = "/step";  ///< step_codec.h
inline constexpr const char* kStepSchemaName = "tp100.Step";
inline constexpr const char* kStepEncoding = "tp100";
/// Inputs of all steps before the first /step, where there were any.
inline constexpr const char* kBeforeTopic = "/before";
inline constexpr const char* kInputsSchemaName = "tp100.Inputs";
inline constexpr const char* kTruthTopic = "/truth";  ///< all digits, unlike /pose/truth
inline constexpr const char* kTruthSchemaName = "tp100.Truth";
inline constexpr const char* kFactsName = "tp100";  ///< of the metadata record

struct RecordingSettings {
  std::string path;                         ///< of the file; its folder is made if need be
  std::uint64_t max_bytes = 2'000'000'000;  ///< the recording ends there
  bool compress = true;
  messages::PublishClock clock{};
};

/// What a recording says of its run besides the steps.
struct RunFacts {
  messages::Subject subject{};
  McapMap facts;                      ///< names and values: course, robot, set-up, seed, ...
  std::vector<McapAttachment> files;  ///< as they were loaded
};

class RecordingWriter {
 public:
  /// Creates the file. Throws SetupError if it cannot be.
  RecordingWriter(const RecordingSettings& settings, const RunFacts& facts);

  /// Inputs of steps that came before, a block of them (step_codec.h); first of all.
  void before(HostNs at, std::span<const std::uint8_t> block);
  /// One step, and the messages that viewers get of it. `bytes` is `record` as encode_step writes
  /// it.
  void step(const StepRecord& record, std::span<const std::uint8_t> bytes);
  void truth(const messages::Truth& truth);
  /// A message of any other channel.
  void message(messages::Channel channel, HostNs at, std::string_view json);
  /// The end of the file. Nothing is written afterwards.
  void finish();

  /// False once it has ended: finished, or no more room.
  bool active() const { return active_; }
  /// Why it ended early, and what to do: one line. Empty: it did not.
  const std::string& warning() const { return warning_; }
  std::uint64_t bytes() const { return file_.size(); }
  const std::string& path() const { return settings_.path; }
  /// Time of the first step in it; 0: none yet.
  HostNs first_ns() const { return first_ns_; }

 private:
  void add_channels();
  void add_files(const RunFacts& facts);
  void poses(const StepRecord& record);
  void write(std::uint16_t channel, HostNs at, std::span<const std::uint8_t> data);
  void end_chunk();
  void end_early(const std::string& why);

  RecordingSettings settings_;
  messages::Messages messages_;
  RecordingFile file_;
  McapWriter writer_;
  std::uint16_t before_channel_ = 0, step_channel_ = 0, truth_channel_ = 0;
  std::map<messages::Channel, std::uint16_t> channels_;
  std::optional<messages::Truth> truth_;
  HostNs first_ns_ = 0, next_pose_ns_ = 0, next_slip_ns_ = 0;
  bool active_ = true;
  std::string warning_;
};

}  // namespace tp100::record
