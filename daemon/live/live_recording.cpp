#include "live/live_recording.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <future>
#include <system_error>
#include <utility>

#include "core/clock.h"
#include "core/error.h"
#include "record/recording_file.h"

namespace tp100::live {
namespace {

namespace fs = std::filesystem;
using messages::Channel;

// Every recording that begins later holds all of it: two hours at 200 Hz.
constexpr std::uint64_t kMostBefore = 300'000'000;

std::string date_and_time(std::int64_t unix_ns) {
  const auto seconds = static_cast<std::time_t>(unix_ns / kNsPerS);
  std::tm local{};
  ::localtime_r(&seconds, &local);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y%m%d-%H%M%S", &local)};
}

/// Things that happen; the other channels say how something is.
bool happens(Channel channel) { return channel == Channel::kEvent || channel == Channel::kLog; }

[[noreturn]] void fail(const std::string& folder, const std::error_code& error) {
  throw SetupError(folder + ": cannot create the folder (" + error.message() +
                   "); give another --record");
}

}  // namespace

bool is_told(Channel channel) {
  return happens(channel) || channel == Channel::kLink || channel == Channel::kLoop ||
         channel == Channel::kState || channel == Channel::kParameter;
}

std::string make_run_folder(const std::string& directory, const std::string& name,
                            std::int64_t unix_ns) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) fail(directory, error);
  const std::string stem = directory + "/" + date_and_time(unix_ns) + "-" + name;
  std::string folder = stem;
  for (int i = 2; !fs::create_directory(folder, error); ++i) {
    if (error) fail(folder, error);
    folder = stem + "-" + std::to_string(i);
  }
  return folder;
}

LiveRecording::LiveRecording(const config::RunFiles& files, const config::RunSetup& run,
                             const messages::PublishClock& clock)
    : files_(files), run_(run), clock_(clock) {
  const config::RecordSettings& settings = run.configuration.record;
  if (settings.directory.empty()) return;
  std::error_code error;
  fs::create_directories(settings.directory, error);
  if (error) fail(settings.directory, error);
  recorder_ = std::make_unique<record::Recorder>(
      record::RecorderSettings{.journal_folder = settings.directory,
                               .journal_bytes = std::min(max_bytes() / 2, kMostBefore)});
}

std::uint64_t LiveRecording::max_bytes() const {
  return std::uint64_t{1'000'000} * static_cast<std::uint64_t>(run_.configuration.record.max_mb);
}

record::Recorder::Make LiveRecording::make(const std::string& name) const {
  const std::string& course = run_.course == nullptr ? std::string("poses") : run_.course->name;
  const auto unix_ns = static_cast<std::int64_t>(clock_.unix_ns(monotonic_now()));
  return [this, name = name.empty() ? course : name, unix_ns] {
    const std::string folder = make_run_folder(run_.configuration.record.directory, name, unix_ns);
    return std::make_unique<record::RecordingWriter>(
        record::RecordingSettings{
            .path = folder + "/run.mcap", .max_bytes = max_bytes(), .clock = clock_},
        config::run_facts(files_, run_, {{"program", "tp100d run"}}));
  };
}

std::uint64_t LiveRecording::start(const std::string& name, Answer answer) {
  if (recorder_ == nullptr) {
    answer("nothing can be recorded: give --record or set record.directory");
    return 0;
  }
  const std::lock_guard lock(mutex_);
  const std::uint64_t number = recorder_->ask_begin(make(name), std::move(answer));
  if (number == 0) return 0;
  const HostNs now = monotonic_now();
  for (const auto& [channel, json] : in_force_) recorder_->message(channel, now, json);
  return number;
}

void LiveRecording::stop(std::uint64_t number, Answer answer) {
  if (recorder_ == nullptr) return answer("nothing is recorded");
  recorder_->ask_end(number, std::move(answer));
}

std::uint64_t LiveRecording::number() const {
  return recorder_ == nullptr ? 0 : recorder_->number();
}

void LiveRecording::begin() {
  const auto answered = std::make_shared<std::promise<std::string>>();
  start({}, [answered](const std::string& why) { answered->set_value(why); });
  if (const std::string why = answered->get_future().get(); !why.empty()) throw SetupError(why);
}

bool LiveRecording::finish(std::chrono::steady_clock::time_point deadline) {
  return recorder_ == nullptr || recorder_->end(deadline);
}

void LiveRecording::discard() {
  if (recorder_ == nullptr) return;
  recorder_->end();
  record::remove_recording(recorder_->status().path);
}

messages::RecordingFigures LiveRecording::figures() const {
  messages::RecordingFigures figures;
  figures.available = recorder_ != nullptr;
  if (recorder_ == nullptr) return figures;
  const record::RecordingStatus status = recorder_->status();
  figures.active = status.active;
  figures.run = fs::path(status.path).parent_path().filename();
  figures.file = status.path;
  figures.elapsed_s = to_s(status.last_ns - status.first_ns);
  figures.bytes = status.bytes;
  figures.dropped = status.dropped;
  figures.warning = status.warning;
  return figures;
}

double LiveRecording::cpu_s() const {
  return recorder_ == nullptr ? 0.0 : recorder_->status().cpu_s;
}

void LiveRecording::take(const StepRecord& record) {
  if (recorder_ != nullptr) recorder_->take(record);
}

void LiveRecording::take_truth(HostNs at, const Pose& truth) {
  if (recorder_ != nullptr) recorder_->take_truth(at, truth);
}

void LiveRecording::hear(messages::Channel channel, std::uint64_t unix_ns, std::string_view json) {
  if (!is_told(channel)) return;
  const std::lock_guard lock(mutex_);
  if (!happens(channel)) in_force_[channel] = json;
  if (recorder_ != nullptr) recorder_->message(channel, clock_.host_ns(unix_ns), json);
}

}  // namespace tp100::live
