#pragma once
// Automatic recordings of a running bridge: each run, and the seconds around a fault.

#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "core/run_state.h"
#include "core/step_record.h"
#include "live/live_recording.h"
#include "messages/event_queue.h"

namespace tp100::live {

/// Records each run of a bridge that stays on, but not the time between two runs.
class RunRecordings {
 public:
  /// `recording` must outlive this, and `events`, which hear of a recording that could not begin,
  /// the recording. Off: recordings are controlled elsewhere.
  RunRecordings(LiveRecording& recording, messages::EventQueue& events, bool on)
      : recording_(recording), events_(events), on_(on) {}

  /// Takes a change of the run state. A recording begins with the arming, unless one is already
  /// running.
  void on_run_state(RunState to, HostNs now);
  /// Ends its recording one second after the run, so that the end is included. Call it regularly.
  void tick(HostNs now);

 private:
  void end();

  LiveRecording& recording_;
  messages::EventQueue& events_;
  bool on_;
  std::uint64_t own_ = 0;  ///< the recording begun here; 0: none
  std::optional<HostNs> end_ns_{};
};

/// Records record.black_box_s around a fault that occurs while nothing is recorded; the last second
/// of them follows the fault.
class BlackBox : public messages::Sink {
 public:
  /// Most files that one run of the program keeps. The newest replaces the oldest, so that a fault
  /// that recurs does not fill the disk.
  static constexpr std::size_t kMaxFiles = 20;

  /// `recording` must outlive this, and `events`, which hear of each file, the recording.
  BlackBox(const config::RecordSettings& settings, LiveRecording& recording,
           messages::EventQueue& events);

  // Called by the thread that drains the steps, after `recording` has taken the step. Never waits
  // for the disk.
  void take(const StepRecord& record) override;
  /// The program is ending: a black box whose second is not over ends here.
  void finish();

 private:
  struct Written {
    void add(const std::string& fault, const record::RecordingStatus& status);

    messages::EventQueue& events;
    std::deque<std::string> files;  // of this run, oldest first; the recorder's thread only
  };

  bool on_;
  LiveRecording& recording_;
  FaultMask known_ = 0;    // faults of the newest step
  std::uint64_t own_ = 0;  // the recording begun here; 0: none
  HostNs end_ns_ = 0;      // when that ends
  std::shared_ptr<Written> written_;
};

}  // namespace tp100::live
