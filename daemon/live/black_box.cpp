#include "live/black_box.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "core/error.h"
#include "core/faults.h"
#include "live/live_recording.h"
#include "record/recording_file.h"
#include "record/recording_writer.h"
#include "record/step_codec.h"

namespace tp100::live {
namespace {

// What is said in a black box's time, at most.
constexpr std::size_t kMostMessages = 4096;

std::string of_environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : value;
}

}  // namespace

std::string black_box_directory(const config::RecordSettings& settings) {
  if (!settings.black_box_directory.empty()) return settings.black_box_directory;
  if (!settings.directory.empty()) return settings.directory;
  if (const std::string state = of_environment("XDG_STATE_HOME"); !state.empty())
    return state + "/tp100";
  const std::string home = of_environment("HOME");
  return home.empty() ? home : home + "/.local/state/tp100";
}

BlackBox::BlackBox(const config::RunFiles& files, const config::RunSetup& run,
                   const messages::PublishClock& clock, record::Worker& disk,
                   std::function<bool()> recorded)
    : files_(files),
      run_(run),
      clock_(clock),
      disk_(disk),
      recorded_(std::move(recorded)),
      length_ns_(from_s(run.configuration.record.black_box_s)),
      directory_(black_box_directory(run.configuration.record)) {}

BlackBox::~BlackBox() {
  finish();
  disk_.idle_by(std::chrono::steady_clock::time_point::max());
}

void BlackBox::hear(messages::Channel channel, std::uint64_t unix_ns, std::string_view json) {
  if (length_ns_ == 0 || !is_told(channel)) return;
  const std::lock_guard lock(mutex_);
  const HostNs at_ns = clock_.host_ns(unix_ns);
  messages_.push_back({channel, at_ns, std::string(json)});
  while (messages_.size() > kMostMessages || messages_.front().at_ns < at_ns - length_ns_)
    messages_.pop_front();
}

void BlackBox::take(const StepRecord& record) {
  if (length_ns_ == 0) return;
  keep(record);
  const FaultMask faults = record.snapshot.faults;
  const std::optional<Fault> fault = first_fault(faults & ~known_);
  known_ = faults;
  if (fault && fault_.empty() && !recorded_()) {
    fault_ = describe(*fault).name;
    due_ns_ = record.now_ns + kAfterwardsNs;
  }
  if (!fault_.empty() && record.now_ns >= due_ns_) begin_to_write();
}

void BlackBox::keep(const StepRecord& record) {
  while (!steps_.empty() && steps_.front().at_ns < record.now_ns - length_ns_) steps_.pop_front();
  encoded_.clear();
  record::encode_step(record, encoded_);
  // A copy holds no more than it needs: used again, each would grow to the longest step ever.
  steps_.push_back({record.now_ns, encoded_});
}

void BlackBox::begin_to_write() {
  Messages messages;
  {
    const std::lock_guard lock(mutex_);
    messages = messages_;
  }
  // Two black boxes have no step in common.
  const std::string fault = std::exchange(fault_, {});
  const bool taken =
      disk_.post([this, fault, steps = std::exchange(steps_, {}), messages = std::move(messages)] {
        write(fault, steps, messages);
      });
  if (!taken) note("black box of " + fault + " is not written: the disk is too slow");
}

void BlackBox::write(const std::string& fault, const Steps& steps, const Messages& messages) {
  try {
    if (directory_.empty())
      throw SetupError("no folder for it: set record.black_box_directory, or 0 for black_box_s");
    const HostNs begin_ns = steps.front().at_ns;
    const std::string folder =
        make_run_folder(directory_, "black-box-" + fault,
                        static_cast<std::int64_t>(clock_.unix_ns(steps.back().at_ns)));
    const std::string file = folder + "/run.mcap";
    record::RecordingWriter writer(
        {.path = file, .clock = clock_},
        config::run_facts(files_, run_, {{"program", "tp100d run"}, {"black_box", fault}}));
    auto message = messages.begin();
    StepRecord record;
    for (const Step& step : steps) {
      for (; message != messages.end() && message->at_ns <= step.at_ns; ++message) {
        if (message->at_ns >= begin_ns)
          writer.message(message->channel, message->at_ns, message->json);
      }
      if (!record::decode_step(step.bytes, record)) writer.step(record, step.bytes);
    }
    writer.finish();
    if (!writer.warning().empty()) throw SetupError(writer.warning());
    char seconds[16];
    std::snprintf(seconds, sizeof seconds, "%.1f", to_s(steps.back().at_ns - begin_ns));
    keep_newest(file);
    note("black box: " + std::string(seconds) + " s around " + fault + " are in " + file);
  } catch (const SetupError& error) {
    note("black box of " + fault + " is not written: " + error.what());
  }
}

// Whatever else somebody has put beside it stays.
void BlackBox::keep_newest(const std::string& file) {
  files_written_.push_back(file);
  if (files_written_.size() <= kMostFiles) return;
  record::remove_recording(files_written_.front());
  files_written_.pop_front();
}

void BlackBox::finish() {
  if (!fault_.empty() && !steps_.empty()) begin_to_write();
}

void BlackBox::note(std::string text) {
  const std::lock_guard lock(mutex_);
  note_ = std::move(text);
}

std::string BlackBox::take_note() {
  const std::lock_guard lock(mutex_);
  return std::exchange(note_, {});
}

}  // namespace tp100::live
