#include "app/live_recording.h"

#include <array>
#include <ctime>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "loop/pacing.h"

namespace tp100::app {
namespace {

namespace fs = std::filesystem;

std::string date_and_time(std::int64_t unix_ns) {
  const auto seconds = static_cast<std::time_t>(unix_ns / kNsPerS);
  std::tm local{};
  ::localtime_r(&seconds, &local);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y%m%d-%H%M%S", &local)};
}

[[noreturn]] void fail(const std::string& folder, const std::error_code& error) {
  throw SetupError(folder + ": cannot create the folder (" + error.message() +
                   "); give another --record");
}

}  // namespace

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

LiveRecording::LiveRecording(const RunFiles& files, const RunSetup& run,
                             const publish::PublishClock& clock)
    : files_(files), run_(run), clock_(clock) {}

void LiveRecording::start(const std::string& name) {
  const RecordSettings& settings = run_.configuration.record;
  if (settings.directory.empty())
    throw SetupError("nothing can be recorded: give --record or set record.directory");
  const std::lock_guard lock(mutex_);
  if (recorder_ != nullptr && recorder_->status().active)
    throw SetupError("a recording is running already: " + recorder_->path());
  const HostNs now = loop::monotonic_now();
  const std::string& course = run_.course == nullptr ? std::string("poses") : run_.course->name;
  const std::string folder = make_run_folder(settings.directory, name.empty() ? course : name,
                                             static_cast<std::int64_t>(clock_.unix_ns(now)));
  recorder_ = std::make_shared<publish::Recorder>(
      publish::RecorderSettings{
          .recording = {.path = folder + "/run.mcap",
                        .max_bytes =
                            std::uint64_t{1'000'000} * static_cast<std::uint64_t>(settings.max_mb),
                        .clock = clock_}},
      run_facts(files_, run_, {{"program", "tp100d run"}}));
  name_ = fs::path(folder).filename();
  began_ns_ = now;
}

void LiveRecording::stop() {
  if (const auto current = recorder()) current->finish();
}

void LiveRecording::discard() {
  if (const auto current = recorder()) current->discard();
}

std::shared_ptr<publish::Recorder> LiveRecording::recorder() const {
  const std::lock_guard lock(mutex_);
  return recorder_;
}

publish::RecordingFigures LiveRecording::figures() const {
  publish::RecordingFigures figures;
  figures.available = !run_.configuration.record.directory.empty();
  const std::lock_guard lock(mutex_);
  if (recorder_ == nullptr) return figures;
  const publish::RecordingStatus status = recorder_->status();
  figures.active = status.active;
  figures.run = name_;
  figures.file = recorder_->path();
  figures.elapsed_s = to_s((status.active ? loop::monotonic_now() : status.last_ns) - began_ns_);
  figures.bytes = status.bytes;
  figures.dropped = status.dropped;
  figures.warning = status.warning;
  return figures;
}

double LiveRecording::cpu_s() const {
  const auto current = recorder();
  return current == nullptr ? 0.0 : current->status().cpu_s;
}

void LiveRecording::take(const StepRecord& record) {
  if (const auto current = recorder()) current->take(record);
}

void LiveRecording::take_truth(HostNs at, const Pose& truth) {
  if (const auto current = recorder()) current->take_truth(at, truth);
}

void LiveRecording::message(publish::Channel channel, HostNs at, std::string_view json) {
  if (const auto current = recorder()) current->message(channel, at, json);
}

}  // namespace tp100::app
