#include "record/recording.h"

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.h"
#include "record/recording_file.h"
#include "record/recording_writer.h"
#include "record/step_codec.h"
#include "text/format.h"

namespace tp100::record {
namespace {

using Json = nlohmann::json;

/// Everything before the first message.
class Beginning : public McapHandler {
 public:
  bool message(const McapMessage&) override { return false; }
  bool attachment(const std::string& name, const std::string&, std::uint64_t,
                  std::string_view data) override {
    held_ += data.size();
    if (held_ > McapReader::kMaxSize || files.size() >= kMaxFiles) return false;
    files[name] = data;
    return true;
  }
  bool metadata(const std::string& name,
                const std::map<std::string, std::string>& entries) override {
    if (name == kFactsName) facts = entries;
    return true;
  }
  std::map<std::string, std::string> files, facts;

 private:
  static constexpr std::size_t kMaxFiles = 100;
  std::uint64_t held_ = 0;
};

constexpr std::size_t kLongestTruth = 4096;

bool is_time(HostNs at) { return at >= -kLongestTime && at <= kLongestTime; }

class Distributor : public McapHandler {
 public:
  Distributor(const RecordingVisitor& visitor, const std::string& path, const std::string& version)
      : visitor_(visitor), path_(path), version_(version) {}

  bool message(const McapMessage& message) override {
    const McapChannel& channel = *message.channel;
    if (channel.topic == kBeforeTopic) {
      if (visitor_.before) before(message);
    } else if (channel.topic == kStepTopic) {
      if (visitor_.step) step(message);
    } else if (channel.topic == kTruthTopic) {
      if (visitor_.truth) truth(message);
    } else if (visitor_.message && channel.encoding == "json" &&
               (visitor_.topics.empty() || visitor_.topics.contains(channel.topic))) {
      visitor_.message(channel.topic, message.log_ns, message.text());
    }
    return true;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw UserError(path_ + ": " + what); }

  void require_layout(const McapMessage& message, const std::string& layout) const {
    if (message.channel->schema != layout)
      fail("its steps were recorded by version " + one_line(version_, 20) +
           ", which uses another layout; use that version of tp100d");
  }

  void before(const McapMessage& message) {
    require_layout(message, inputs_schema());
    for (std::span<const std::uint8_t> block = message.data; !block.empty();) {
      if (const auto problem = decode_inputs(block, *record_))
        fail("a step before it is invalid (" + *problem + ")");
      visitor_.before(*record_);
    }
  }

  void step(const McapMessage& message) {
    require_layout(message, step_schema());
    if (const auto problem = decode_step(message.data, *record_))
      fail("step " + std::to_string(message.sequence) + " is invalid (" + *problem + ")");
    visitor_.step(*record_);
  }

  void truth(const McapMessage& message) {
    const auto refuse = [&] { fail("truth " + std::to_string(message.sequence) + " is invalid"); };
    if (message.data.size() > kLongestTruth) refuse();
    const Json json = Json::parse(message.text(), nullptr, false);
    const auto number = [&](std::string_view name) {
      const auto found = json.find(name);
      if (!json.is_object() || found == json.end() || !found->is_number()) refuse();
      const auto value = found->get<double>();
      if (!(std::abs(value) <= kMaxInput)) refuse();
      return value;
    };
    Pose pose;
    visit_fields([&](auto name, double& value) { value = number(name); }, pose);
    const auto at = json.find("host_ns");
    if (at == json.end() || !at->is_number_integer() || !is_time(at->get<HostNs>())) refuse();
    visitor_.truth(at->get<HostNs>(), pose);
  }

  const RecordingVisitor& visitor_;
  const std::string& path_;
  const std::string& version_;
  std::unique_ptr<StepRecord> record_ = std::make_unique<StepRecord>();
};

}  // namespace

std::string recording_file(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_directory(path, error) ? path + "/" + kRecordingFile : path;
}

std::string run_name(const std::string& path) {
  const std::filesystem::path file =
      std::filesystem::absolute(recording_file(path)).lexically_normal();
  return file.stem() == "run" ? file.parent_path().filename() : file.stem();
}

bool is_recording(const std::string& path) {
  std::array<char, kMcapMagic.size()> magic{};
  std::ifstream file(recording_file(path), std::ios::binary);
  file.read(magic.data(), magic.size());
  const auto begins = [&](const void* with, std::size_t size) {
    return std::memcmp(magic.data(), with, size) == 0;
  };
  return file && (begins(kMcapMagic.data(), magic.size()) || begins("PK\x03\x04", 4));
}

struct Recording::State {
  explicit State(const std::string& path) : reader(recording_file(path)) {}
  McapReader reader;
  std::map<std::string, std::string> files, facts;
};

Recording::Recording(const std::string& path) : state_(std::make_unique<State>(path)) {
  Beginning beginning;
  state_->reader.stream(beginning);
  if (beginning.facts.empty())
    throw UserError(state_->reader.path() + ": an MCAP file, but no recording of tp100d");
  state_->files = std::move(beginning.files);
  state_->facts = std::move(beginning.facts);
}

Recording::~Recording() = default;

const std::string& Recording::path() const { return state_->reader.path(); }
bool Recording::whole() const { return state_->reader.indexed(); }
const std::map<std::string, std::string>& Recording::facts() const { return state_->facts; }

std::string Recording::fact(const std::string& name) const {
  const auto found = state_->facts.find(name);
  return found == state_->facts.end() ? std::string() : found->second;
}

HostNs Recording::start_ns() const {
  const HostNs start = text::number_in<HostNs>(fact("start_ns")).value_or(0);
  return is_time(start) ? start : 0;
}

std::int64_t Recording::start_unix_ns() const {
  return text::number_in<std::int64_t>(fact("start_unix_ns")).value_or(0);
}

std::string Recording::file(const std::string& name) const {
  const auto found = state_->files.find(name);
  return found == state_->files.end() ? std::string() : found->second;
}

void Recording::visit(const RecordingVisitor& visitor) const {
  const std::string version = fact("version");
  Distributor distributor(visitor, path(), version);
  const McapEnd end = state_->reader.stream(distributor);
  if (end.corrupted > 0)
    throw UserError(path() + ": corrupted, " + end.problem +
                    "; tp100d recover saves the intact part");
}

}  // namespace tp100::record
