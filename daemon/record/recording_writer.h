#pragma once
// Writes the content of a recording into an MCAP file: steps, truth and viewers' messages. One
// thread.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/run_summary.h"
#include "messages/channels.h"
#include "messages/messages.h"
#include "record/mcap_writer.h"

namespace tp100::record {

// Topics of recordings only.
inline constexpr const char* kStepTopic = "/step";  ///< step_codec.h
inline constexpr const char* kStepSchemaName = "tp100.Step";
inline constexpr const char* kStepEncoding = "tp100";
/// Inputs of all steps before the first /step, if any.
inline constexpr const char* kBeforeTopic = "/before";
inline constexpr const char* kInputsSchemaName = "tp100.Inputs";
inline constexpr const char* kTruthTopic = "/truth";  ///< all digits, unlike /pose/truth
inline constexpr const char* kTruthSchemaName = "tp100.Truth";
inline constexpr const char* kFactsName = "tp100";  ///< of the metadata record

struct RecordingSettings {
  std::string path;                         ///< of the file; its folder is created if absent
  std::uint64_t max_bytes = 2'000'000'000;  ///< the recording ends there
  bool compress = true;
  messages::PublishClock clock{};
  std::function<void(const RunSummary&)> at_end{};  ///< called when the file is written
};

/// What a recording contains about its run besides the steps.
struct RunFacts {
  messages::RunContext run_context{};
  McapMap facts;                      ///< names and values: course, robot, set-up, seed, ...
  std::vector<McapAttachment> files;  ///< as they were loaded
};

class RecordingWriter {
 public:
  /// Creates the file. Throws UserError on failure.
  RecordingWriter(const RecordingSettings& settings, const RunFacts& facts);

  /// Writes a block of inputs of earlier steps (step_codec.h), before anything else.
  void before(HostNs at, std::span<const std::uint8_t> block);
  /// Writes one step and the viewers' messages for it. `bytes` is `record` as encoded by
  /// encode_step.
  void step(const StepRecord& record, std::span<const std::uint8_t> bytes);
  void truth(const messages::Truth& truth);
  /// Writes a message of any other channel.
  void message(messages::Channel channel, HostNs at, std::string_view json);
  /// Writes the end of the file. Nothing is written afterwards.
  void finish();

  /// False once it has ended: finished, or disk full.
  bool active() const { return active_; }
  /// Why it ended early, and what to do: one line, or empty.
  const std::string& warning() const { return warning_; }
  std::uint64_t bytes() const { return file_.size(); }
  const std::string& path() const { return settings_.path; }
  /// Time of its first step; 0: none yet.
  HostNs first_ns() const { return first_ns_; }

 private:
  void add_channels();
  void add_files(const RunFacts& facts);
  void write(std::uint16_t channel, HostNs at, std::span<const std::uint8_t> data);
  void end_chunk();
  void end_early(const std::string& why);

  RecordingSettings settings_;
  messages::Messages messages_;
  messages::StepMessages step_messages_;
  RecordingFile file_;
  McapWriter writer_;
  std::uint16_t before_channel_ = 0, step_channel_ = 0, truth_channel_ = 0;
  std::map<messages::Channel, std::uint16_t> channels_;
  HostNs first_ns_ = 0;
  RunSummary summary_;
  bool active_ = true;
  std::string warning_;
};

}  // namespace tp100::record
