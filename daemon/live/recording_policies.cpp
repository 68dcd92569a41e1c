#include "live/recording_policies.h"

#include <filesystem>
#include <utility>

#include "core/error.h"
#include "core/faults.h"
#include "runs/run_folder.h"
#include "text/format.h"

namespace tp100::live {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

// By number, because a viewer may have ended it and begun another.
void RunRecordings::end() {
  if (own_ != 0) recording_.stop(own_, ignore);
  own_ = 0;
}

void RunRecordings::on_run_state(RunState to, HostNs now) {
  if (!on_) return;
  if (to != RunState::kArming) {
    if (!armed(to) && own_ != 0) end_ns_ = now + kTailNs;
    return;
  }
  end_ns_.reset();
  end();
  if (recording_.number() != 0) return;
  own_ = recording_.start("", [&events = events_](const std::string& why) {
    if (!why.empty()) events.note("this run is not recorded: " + why);
  });
}

void RunRecordings::tick(HostNs now) {
  if (!end_ns_ || now < *end_ns_) return;
  end_ns_.reset();
  end();
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
  if (!status.path.empty()) {
    files.push_back(status.path);
    if (files.size() > kMaxFiles) {
      forget(fs::path(files.front()).parent_path());
      files.pop_front();
    }
  }
  if (status.path.empty())
    return events.note("black box of " + fault + " is not written: " + status.warning);
  events.note(text::format("black box: %.1f s around ", to_s(status.last_ns - status.first_ns)) +
              fault + " are in " + status.path +
              (status.warning.empty() ? "" : "; " + status.warning));
}

}  // namespace tp100::live
