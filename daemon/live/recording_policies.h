#pragma once
// Automatic recordings of a running bridge: each run, and the seconds around a fault.

#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "core/run_state.h"
#include "core/step_record.h"
#include "live/event_log.h"
#include "live/live_recording.h"

namespace tp100::live {

/// Records each run of a bridge that stays on, but not the time between two runs.
class RunRecordings {
 public:
  /// `recording` must outlive this. Off: recordings are controlled elsewhere.
  RunRecordings(LiveRecording& recording, bool on) : recording_(recording), on_(on) {}

  /// Takes a change of the run state. A recording begins with the arming, unless one is already
  /// running.
  void on_run_state(RunState to, HostNs now);
  /// Ends its recording one second after the run, so that the end is included. Call it regularly.
  void tick(HostNs now);
  /// Why a recording could not begin, in one line, since the last call; or nothing.
  std::string take_note() { return note_->take(); }

 private:
  void end();

  LiveRecording& recording_;
  bool on_;
  std::uint64_t own_ = 0;  ///< the recording begun here; 0: none
  std::optional<HostNs> end_ns_{};
  std::shared_ptr<Note> note_ = std::make_shared<Note>();
};

/// Records record.black_box_s around a fault that occurs while nothing is recorded; the last second
/// of them follows the fault.
class BlackBox : public messages::Sink {
 public:
  /// Most files that one run of the program keeps. The newest replaces the oldest, so that a fault
  /// that recurs does not fill the disk.
  static constexpr std::size_t kMaxFiles = 20;

  /// `recording` must outlive this.
  BlackBox(const config::RecordSettings& settings, LiveRecording& recording);

  // Called by the thread that drains the steps, after `recording` has taken the step. Never waits
  // for the disk.
  void take(const StepRecord& record) override;
  /// The program is ending: a black box whose second is not over ends here.
  void finish();
  /// A line about the last file, that it was written or why not; empty if there is nothing new.
  std::string take_note() { return written_->note.take(); }

 private:
  struct Written {
    void add(const std::string& fault, const record::RecordingStatus& status);

    Note note;
    std::deque<std::string> files;  // of this run, oldest first; the recorder's thread only
  };

  bool on_;
  LiveRecording& recording_;
  FaultMask known_ = 0;    // faults of the newest step
  std::uint64_t own_ = 0;  // the recording begun here; 0: none
  HostNs end_ns_ = 0;      // when that ends
  std::shared_ptr<Written> written_ = std::make_shared<Written>();
};

}  // namespace tp100::live
