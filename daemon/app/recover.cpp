#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <tuple>

#include "app/commands.h"
#include "core/error.h"
#include "record/mcap_reader.h"
#include "record/mcap_writer.h"
#include "record/recording.h"
#include "text/command_line.h"

namespace tp100::app {
namespace {

struct RecoverOptions {
  std::string in;   ///< file, or the folder of a run
  std::string out;  ///< empty: beside it, with -recovered before .mcap
};

namespace fs = std::filesystem;
using record::McapChannel;

constexpr std::size_t kLargestChunk = std::size_t{4} << 20;

struct Counter : record::McapHandler {
  bool message(const record::McapMessage&) override {
    ++messages;
    return true;
  }
  std::uint64_t messages = 0;
};

/// Copies what it receives.
class Copier : public record::McapHandler {
 public:
  explicit Copier(record::McapWriter& writer) : writer_(writer) {}

  bool channel(const McapChannel& channel) override {
    channels_[channel.id] =
        writer_.add_channel(schema_of(channel), channel.topic, channel.encoding);
    return true;
  }
  bool message(const record::McapMessage& message) override {
    writer_.message(channels_.at(message.channel->id), message.log_ns, message.data);
    // Other programs may write messages without chunks.
    if (writer_.open_bytes() > kLargestChunk) writer_.end_chunk();
    return true;
  }
  bool chunk_end() override {
    writer_.end_chunk();
    return true;
  }
  bool attachment(const std::string& name, const std::string& media_type, std::uint64_t log_ns,
                  std::string_view data) override {
    writer_.attach({name, media_type, log_ns, std::string(data)});
    return true;
  }
  bool metadata(const std::string& name,
                const std::map<std::string, std::string>& entries) override {
    writer_.add_metadata(name, {entries.begin(), entries.end()});
    return true;
  }

 private:
  std::uint16_t schema_of(const McapChannel& channel) {
    if (channel.schema_name.empty()) return 0;
    const auto [entry, is_new] = schemas_.emplace(
        std::tuple(channel.schema_name, channel.schema_encoding, channel.schema), 0);
    if (is_new)
      entry->second =
          writer_.add_schema({channel.schema_name, channel.schema_encoding, channel.schema});
    return entry->second;
  }

  record::McapWriter& writer_;
  std::map<std::tuple<std::string, std::string, std::string>, std::uint16_t> schemas_;
  std::map<std::uint16_t, std::uint16_t> channels_;
};

std::string beside(const std::string& path) {
  const fs::path in(path);
  return (in.parent_path() / (in.stem().string() + "-recovered.mcap")).string();
}

int run_recover(const RecoverOptions& options) {
  const std::string in = record::recording_file(options.in);
  const record::McapReader reader(in);
  Counter there;
  const record::McapEnd before = reader.stream(there, record::McapCheck::kIndexes);
  if (before.whole) {
    std::printf("%s: not damaged, nothing to recover\n", in.c_str());
    return 0;
  }
  if (there.messages == 0)
    throw UserError(in + ": " + before.problem +
                    "; no message is whole, so nothing can be saved; delete it");
  const std::string out = options.out.empty() ? beside(in) : options.out;
  record::RecordingFile file(out);
  record::McapWriter writer(file, "tp100d recover", record::McapCompression::kZstd);
  Copier copier(writer);
  reader.stream(copier);
  writer.finish();
  if (file.error() != 0) {
    std::error_code ignored;
    fs::remove(out, ignored);
    throw UserError(out + ": cannot be written (" + std::strerror(file.error()) +
                    "); check free space, or give another --out");
  }
  std::printf("%s: %s; %llu messages saved in %s\n", in.c_str(), before.problem.c_str(),
              static_cast<unsigned long long>(there.messages), out.c_str());
  if (before.corrupted > 0)
    std::printf("%llu corrupted parts were skipped\n",
                static_cast<unsigned long long>(before.corrupted));
  return 0;
}

}  // namespace

void add_recover(CLI::App& app, Action& action) {
  static RecoverOptions options;
  CLI::App* command =
      app.add_subcommand("recover", "Rebuild a recording that was truncated or corrupted");
  text::option(command, "FILE", options.in, "FILE", "Recording, or its folder")->required();
  text::option(command, "--out", options.out, "FILE",
               "File to write (default: beside it, ...-recovered.mcap)");
  command->footer("Example: tp100d recover runs/RUN");
  command->callback([&action] { action = [] { return run_recover(options); }; });
}

}  // namespace tp100::app
