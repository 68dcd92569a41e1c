#pragma once
// A recording of each run of a bridge that stays: what lies between two runs fills no disk.

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/run_state.h"
#include "core/time.h"
#include "live/live_recording.h"

namespace tp100::live {

class RunRecorder {
 public:
  /// `recording` must outlive this. Off: recordings are somebody else's.
  RunRecorder(LiveRecording& recording, bool on) : recording_(recording), on_(on) {}

  /// The run has come to that state. A recording begins with the arming, unless somebody has one
  /// under way.
  void on_run_state(RunState to, HostNs now);
  /// Ends what it began a second after the run, so that the end is in it. Call it again and again.
  void tick(HostNs now);
  /// Why a recording could not begin, in one line, since the last call; or nothing.
  std::string take_note();

 private:
  struct Note {
    std::mutex mutex;
    std::string text;
  };

  void end();

  LiveRecording& recording_;
  bool on_;
  std::uint64_t own_ = 0;  ///< the recording that was begun here; 0: none
  std::optional<HostNs> end_ns_{};
  std::shared_ptr<Note> note_ = std::make_shared<Note>();
};

}  // namespace tp100::live
