#include "record/recording_writer.h"

#include <cstring>
#include <filesystem>

#include "core/error.h"
#include "messages/foxglove.h"
#include "record/step_codec.h"
#include "text/atomic_file.h"
#include "text/json_writer.h"

namespace tp100::record {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 20;
constexpr std::uint64_t kChunkNs = 500'000'000;

/// Creates the folder of `path`, and returns `path`.
const std::string& with_folder(const std::string& path) {
  text::make_folder(std::filesystem::path(path).parent_path(), "folder for recordings");
  return path;
}

std::string truth_text(const messages::PublishClock& clock, const messages::Truth& truth) {
  return text::json_object([&](text::JsonWriter& json) {
    json.field("t_s", clock.t_s(truth.at_ns)).field("host_ns", truth.at_ns);
    json.fields(truth.pose);
  });
}

/// False for channels that only make sense live, or follow from the others.
bool recorded(messages::Channel channel) {
  return channel != messages::Channel::kPathHistory && channel != messages::Channel::kClient &&
         channel != messages::Channel::kRecording;
}

}  // namespace

RecordingWriter::RecordingWriter(const RecordingSettings& settings, const RunFacts& facts)
    : settings_(settings),
      messages_(facts.run_context, settings.clock),
      step_messages_(messages_, true),
      file_(with_folder(settings.path)),
      writer_(file_, "tp100 " + facts.run_context.version,
              settings.compress ? McapCompression::kZstd : McapCompression::kNone) {
  add_channels();
  add_files(facts);
  if (file_.error() != 0)
    throw UserError(settings.path + ": cannot be written (" + std::strerror(file_.error()) +
                    "); check free space");
  const HostNs start = settings.clock.start_ns;
  for (const auto& [channel, text] : messages::setup_messages(messages_, start))
    message(channel, start, *text);
}

void RecordingWriter::add_channels() {
  std::map<std::string, std::uint16_t> schemas;
  const auto add = [&](const McapSchema& schema, std::string_view topic,
                       std::string_view encoding) {
    const auto [entry, is_new] = schemas.emplace(schema.name, std::uint16_t{});
    if (is_new) entry->second = writer_.add_schema(schema);
    return writer_.add_channel(entry->second, topic, encoding);
  };
  before_channel_ =
      add({kInputsSchemaName, kStepEncoding, inputs_schema()}, kBeforeTopic, kStepEncoding);
  step_channel_ = add({kStepSchemaName, kStepEncoding, step_schema()}, kStepTopic, kStepEncoding);
  truth_channel_ =
      add({kTruthSchemaName, "jsonschema",
           messages::schema_of(kTruthSchemaName, truth_text(settings_.clock, messages::Truth{}))},
          kTruthTopic, "json");
  for (const messages::ChannelText& channel : messages::channel_texts()) {
    if (!recorded(channel.channel)) continue;
    channels_[channel.channel] =
        add({channel.schema_name, "jsonschema", channel.schema}, channel.topic, "json");
  }
}

void RecordingWriter::add_files(const RunFacts& facts) {
  McapMap entries = facts.facts;
  entries.emplace_back("version", facts.run_context.version);
  entries.emplace_back("start_ns", std::to_string(settings_.clock.start_ns));
  entries.emplace_back("start_unix_ns", std::to_string(settings_.clock.start_unix_ns));
  writer_.add_metadata(kFactsName, entries);
  for (McapAttachment attachment : facts.files) {
    attachment.log_ns = settings_.clock.unix_ns(settings_.clock.start_ns);
    writer_.attach(attachment);
  }
}

void RecordingWriter::before(HostNs at, std::span<const std::uint8_t> block) {
  write(before_channel_, at, block);
}

void RecordingWriter::step(const StepRecord& record, std::span<const std::uint8_t> bytes) {
  const HostNs now = record.now_ns;
  if (first_ns_ == 0) first_ns_ = now;
  summary_.take(record);
  write(step_channel_, now, bytes);
  step_messages_.take(record, recorded,
                      [this](messages::Channel channel, HostNs at, const std::string& json) {
                        message(channel, at, json);
                      });
}

void RecordingWriter::truth(const messages::Truth& truth) {
  step_messages_.take_truth(truth);
  write(truth_channel_, truth.at_ns, bytes_of(truth_text(settings_.clock, truth)));
}

void RecordingWriter::message(messages::Channel channel, HostNs at, std::string_view json) {
  const auto entry = channels_.find(channel);
  if (entry != channels_.end()) write(entry->second, at, bytes_of(json));
}

void RecordingWriter::write(std::uint16_t channel, HostNs at, std::span<const std::uint8_t> data) {
  if (!active_) return;
  const std::uint64_t log_ns = settings_.clock.unix_ns(at);
  const bool old = writer_.open_bytes() > 0 && log_ns >= writer_.open_since_ns() + kChunkNs;
  if (old || writer_.open_bytes() > kChunkBytes) end_chunk();
  if (active_) writer_.message(channel, log_ns, data);
}

// Always keeps enough space free for the end of the file.
void RecordingWriter::end_chunk() {
  const std::uint64_t room = file_.room();
  if (writer_.needed() > room) return end_early("the disk is full");
  const std::uint64_t before = file_.size();
  writer_.end_chunk();
  if (file_.error() != 0) {
    active_ = false;
    warning_ = settings_.path + ": recording stopped (" + std::strerror(file_.error()) +
               "); the end of the file is missing, tp100d recover repairs it";
    return;
  }
  // Assumes that the next chunk is at most twice as large as this one.
  const std::uint64_t next = 2 * (file_.size() - before) + writer_.needed();
  if (file_.size() + next > settings_.max_bytes)
    end_early("record.max_mb, " + std::to_string(settings_.max_bytes / 1'000'000) +
              " MB, is reached");
}

// Discards the open chunk, which would not fit, and writes the end of the file.
void RecordingWriter::end_early(const std::string& why) {
  writer_.drop_chunk();
  finish();
  if (warning_.empty())
    warning_ = settings_.path + ": recording stopped, " + why + "; the file is complete";
}

void RecordingWriter::finish() {
  if (!active_) return;
  active_ = false;
  writer_.finish();
  if (file_.error() != 0)
    warning_ = settings_.path + ": the end of the recording could not be written (" +
               std::strerror(file_.error()) + "); tp100d recover repairs the file";
  if (settings_.at_end) settings_.at_end(summary_);
}

}  // namespace tp100::record
