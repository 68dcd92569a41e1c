#include "live/live_recording.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <future>
#include <utility>

#include "config/setup_files.h"
#include "core/clock.h"
#include "core/error.h"
#include "record/recording_file.h"
#include "runs/run_folder.h"
#include "runs/run_result.h"
#include "text/atomic_file.h"
#include "text/file_name.h"
#include "text/format.h"
#include "text/json_writer.h"
#include "text/standard_streams.h"

namespace tp100::live {
namespace {

namespace fs = std::filesystem;
using messages::Channel;

// A cable that comes and goes makes a black box each time, and nobody may look for weeks.
constexpr int kBlackBoxesMb = 500;
constexpr std::string_view kBlackBoxName = "-black-box-";

/// Channels of what happens once; the other channels hold a state.
bool is_event_channel(Channel channel) {
  return channel == Channel::kEvent || channel == Channel::kLog || channel == Channel::kCameraImage;
}

/// Whether messages of that channel are recorded when they are published, because they cannot be
/// derived from the steps.
bool is_recorded(Channel channel) {
  return is_event_channel(channel) || channel == Channel::kLink || channel == Channel::kLoop ||
         channel == Channel::kState || channel == Channel::kParameter;
}

/// What was deleted, in one line; empty: nothing.
std::string describe_freed(const runs::FreedSpace& freed) {
  std::string text;
  if (!freed.deleted.empty()) {
    text = "deleted to stay within record.quota_mb:";
    for (const std::string& run : freed.deleted) text += " " + run;
  }
  if (!freed.why_not.empty()) text += (text.empty() ? "" : "; ") + freed.why_not;
  return text;
}

/// Deletes a run's folder, unless it has a note or its recording is open.
void forget(const fs::path& run) {
  std::error_code error;
  if (fs::exists(run / runs::kRunNoteFile, error)) return;
  try {
    runs::delete_run(run.parent_path(), run.filename());
  } catch (const UserError&) {
    return;
  }
}

void ignore(const std::string&) {}

/// A list without it lacks a few figures.
void write_result(const std::string& folder, const ActiveRun& run, const RunSummary& summary) {
  try {
    text::write_file(
        folder + runs::kRunResultFile,
        runs::write_run_result(runs::result_of(summary, run.course(), run.loaded.setup.robot.name)),
        text::Flush::kNo);
  } catch (const UserError&) {
    return;
  }
}

record::RecorderSettings recorder_settings(const config::Configuration& configuration) {
  const config::RecordSettings& settings = configuration.record;
  text::make_folder(settings.directory, "--record");
  if (settings.directory.empty() && settings.black_box_s == 0.0) return {};
  const std::uint64_t half = std::uint64_t{500'000} * static_cast<std::uint64_t>(settings.max_mb);
  record::HistorySettings history{.folder = black_box_directory(settings)};
  if (!settings.directory.empty()) {
    history.folder = settings.directory;
    history.max_bytes = std::min(history.max_bytes, half);
  }
  return {.history = history,
          .look_back_ns = std::max<HostNs>(from_s(settings.black_box_s) - kTailNs, 0)};
}

}  // namespace

std::string black_box_directory(const config::RecordSettings& settings) {
  if (!settings.black_box_directory.empty()) return settings.black_box_directory;
  if (!settings.directory.empty()) return settings.directory;
  return config::user_folder("XDG_STATE_HOME", "/.local/state");
}

LiveRecording::LiveRecording(std::shared_ptr<const ActiveRun> run,
                             const messages::PublishClock& clock, messages::EventQueue& events)
    : settings_(run->loaded.setup.configuration.record),
      clock_(clock),
      events_(events),
      run_(std::move(run)),
      recorder_(recorder_settings(run_->loaded.setup.configuration)) {
  // Reaching the file size limit is an error like any other.
  std::signal(SIGXFSZ, SIG_IGN);
}

void LiveRecording::exchange(const Exchange& exchange, bool continues) {
  const bool recorded = number() != 0;
  {
    // One lock for all, so that no recording begins between them with the old files.
    const std::lock_guard lock(mutex_);
    recorder_.forget(exchange.first_step);
    run_ = exchange.run;
    exchanged_ns_ = exchange.at_ns;
    std::erase_if(last_, [&](const auto& each) { return each.second.at_ns < exchanged_ns_; });
  }
  if (recorded && continues) start({}, ignore);
}

record::Recorder::Make LiveRecording::make(const std::string& directory, const std::string& name,
                                           HostNs now, const record::McapMap& facts, int quota_mb,
                                           std::string_view only) const {
  const auto unix_ns = static_cast<std::int64_t>(clock_.unix_ns(now));
  return [clock = clock_, max_mb = static_cast<std::uint64_t>(settings_.max_mb), run = run_,
          directory, name, facts, unix_ns, quota_mb, only, &events = events_] {
    // No run of a person is called a black box: those are deleted without being asked for.
    const bool mistaken = only.empty() && ('-' + name).starts_with(kBlackBoxName);
    const std::string own = mistaken ? "run-" : "";
    if (quota_mb > 0) {
      const std::uint64_t max_bytes = static_cast<std::uint64_t>(quota_mb) * 1'000'000;
      std::string text = describe_freed(runs::free_space(directory, max_bytes, only));
      if (!text.empty())
        events.post({.at_ns = monotonic_now(),
                     .kind = "recording",
                     .level = messages::Event::Level::kWarning,
                     .text = std::move(text)});
    }
    const std::string folder = runs::make_run_folder(directory, own + name, unix_ns) + "/";
    return std::make_unique<record::RecordingWriter>(
        record::RecordingSettings{
            .path = folder + record::kRecordingFile,
            .max_bytes = max_mb * 1'000'000,
            .clock = clock,
            .at_end = [folder,
                       run](const RunSummary& summary) { write_result(folder, *run, summary); }},
        config::run_facts(run->loaded.files, run->loaded.setup, facts));
  };
}

// The recorder, which answers, ends before this.
std::vector<server::ServiceRow> LiveRecording::services() {
  const auto begin = [this](const server::Request& request,
                            const server::Answer& answer) -> Result<> {
    const std::string name = request.arguments.text("name").value_or("");
    if (!name.empty() && !text::is_file_name(name)) return Refusal{text::kFileNameRule};
    start(name, [this, answer](const std::string& why) {
      answer(why, server::json_of({{"run", figures().run}}));
    });
    return Done{};
  };
  const auto end = [this](const server::Request&, const server::Answer& answer) -> Result<> {
    stop(0, [this, answer](const std::string& why) {
      const messages::RecordingFigures ended = figures();
      answer(why, text::json_object([&](text::JsonWriter& json) {
               json.field("run", ended.run).field("bytes", ended.bytes);
             }));
    });
    return Done{};
  };
  using server::Service;
  return {{Service::kRecordStart, "record_start", R"({"name":""})", R"({"run":""})", begin},
          {Service::kRecordStop, "record_stop", "{}", R"({"run":"","bytes":1})", end}};
}

std::uint64_t LiveRecording::start(const std::string& name, const Answer& answer) {
  const std::string& directory = settings_.directory;
  if (directory.empty()) {
    answer("nothing can be recorded: give --record or set record.directory");
    return 0;
  }
  const HostNs now = monotonic_now();
  const std::lock_guard lock(mutex_);
  const std::string course = run_->course();
  const std::string usual = course.empty() ? "poses" : course;
  const std::uint64_t number =
      recorder_.ask_begin(make(directory, name.empty() ? usual : name, now,
                               {{"program", "tp100d run"}}, settings_.quota_mb, ""),
                          answer);
  if (number == 0) return 0;
  for (const auto& [channel, message] : last_) recorder_.message(channel, now, message.json);
  return number;
}

std::uint64_t LiveRecording::start_black_box(const std::string& fault, HostNs now,
                                             const record::Recorder::Ended& ended) {
  const std::string directory = black_box_directory(settings_);
  if (directory.empty()) {
    ended(
        {.warning = "no folder is set: set record.black_box_directory, or record.black_box_s = 0"});
    return 0;
  }
  const std::lock_guard lock(mutex_);
  const int quota_mb = settings_.quota_mb > 0 ? settings_.quota_mb : kBlackBoxesMb;
  return recorder_.ask_look_back(
      make(directory, "black-box-" + fault, now, {{"program", "tp100d run"}, {"black_box", fault}},
           quota_mb, kBlackBoxName),
      ended);
}

void LiveRecording::begin() {
  const auto answered = std::make_shared<std::promise<std::string>>();
  start({}, [answered](const std::string& why) { answered->set_value(why); });
  if (const std::string why = answered->get_future().get(); !why.empty()) throw UserError(why);
}

void LiveRecording::discard() {
  recorder_.end();
  const std::string path = recorder_.status().path;
  if (path.empty()) return;
  std::error_code error;
  fs::remove(fs::path(path).parent_path() / runs::kRunResultFile, error);
  record::remove_recording(path);
}

messages::RecordingFigures LiveRecording::figures() const {
  const record::RecordingStatus status = recorder_.status();
  return {.available = !settings_.directory.empty(),
          .active = status.active,
          .run = fs::path(status.path).parent_path().filename(),
          .file = status.path,
          .elapsed_s = to_s(status.last_ns - status.first_ns),
          .bytes = status.bytes,
          .dropped = status.dropped,
          .warning = status.warning};
}

void LiveRecording::on_message(messages::Channel channel, std::uint64_t unix_ns,
                               std::string_view json) {
  if (!is_recorded(channel)) return;
  const HostNs at = clock_.host_ns(unix_ns);
  const std::lock_guard lock(mutex_);
  if (!is_event_channel(channel)) {
    if (at < exchanged_ns_) return;
    last_[channel] = {at, std::string(json)};
  }
  recorder_.message(channel, at, json);
}

// By number, because a viewer may have ended it and begun another.
void RunRecordings::end() {
  if (own_ != 0) recording_.stop(own_, ignore);
  own_ = 0;
}

void RunRecordings::take(const StepRecord& record) {
  const bool was = std::exchange(under_way_, under_way(record.snapshot.run_state));
  if (!on_) return;
  const bool failed =
      (record.snapshot.faults & ~std::exchange(faults_, record.snapshot.faults)) != 0;
  if ((was || failed) && !under_way_ && own_ != 0) end_ns_ = record.now_ns + kTailNs;
  const bool begins = !was && under_way_;
  if (begins || (end_ns_ && record.now_ns >= *end_ns_)) {
    end_ns_.reset();
    end();
  }
  if (!begins || recording_.number() != 0) return;
  own_ = recording_.start("", [&events = events_](const std::string& why) {
    if (!why.empty()) events.note("this run is not recorded: " + why);
  });
}

BlackBox::BlackBox(const config::RecordSettings& settings, LiveRecording& recording,
                   messages::EventQueue& events)
    : on_(settings.black_box_s > 0.0),
      recording_(recording),
      written_(std::make_shared<Written>(Written{.events = events, .files = {}})) {}

void BlackBox::take(const StepRecord& record) {
  if (!on_) return;
  const FaultMask faults = record.snapshot.faults;
  const std::optional<Fault> fault = first_fault(faults & ~known_);
  known_ = faults;
  if (fault && own_ == 0 && recording_.number() == 0) {
    const std::string name(describe(*fault).name);
    end_ns_ = record.now_ns + kTailNs;
    own_ = recording_.start_black_box(
        name, record.now_ns, [written = written_, name](const record::RecordingStatus& status) {
          written->add(name, status);
        });
  }
  if (own_ != 0 && record.now_ns >= end_ns_) finish();
}

void BlackBox::finish() {
  if (own_ != 0) recording_.stop(std::exchange(own_, 0), ignore);
}

void BlackBox::Written::add(const std::string& fault, const record::RecordingStatus& status) {
  if (status.path.empty())
    return events.note("black box of " + fault + " is not written: " + status.warning);
  files.push_back(status.path);
  if (files.size() > kMaxFiles) {
    forget(fs::path(files.front()).parent_path());
    files.pop_front();
  }
  events.note(text::format("black box: %.1f s around ", to_s(status.last_ns - status.first_ns)) +
              fault + " are in " + status.path +
              (status.warning.empty() ? "" : "; " + status.warning));
}

}  // namespace tp100::live
