#pragma once
// A recording of each run of a bridge that stays: what lies between two runs fills no disk.

#include <optional>
#include <string>

#include "app/live_recording.h"
#include "core/run_state.h"
#include "core/time.h"

namespace tp100::app {

class RunRecorder {
 public:
  /// `recording` must outlive this. Off: recordings are somebody else's.
  RunRecorder(LiveRecording& recording, bool on) : recording_(recording), on_(on) {}

  /// The run has come to that state. Begins a recording with the arming, unless somebody has one
  /// under way. Returns why it could not begin, in one line; empty: nothing is wrong.
  std::string on_run_state(RunState to, HostNs now);
  /// Ends what it began a second after the run, so that the end is in it. Call it again and again.
  void tick(HostNs now);

 private:
  bool under_way() const;

  LiveRecording& recording_;
  bool on_;
  std::string own_{};  ///< the file that was begun here; empty: none
  std::optional<HostNs> end_ns_{};
};

}  // namespace tp100::app
