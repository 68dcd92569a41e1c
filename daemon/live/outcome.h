#pragma once
// What the end of a run means for the program: its exit status, and whether it waits for another
// start. Pure.

#include <algorithm>
#include <string>
#include <utility>

#include "core/faults.h"
#include "live/live_cycle.h"

namespace tp100::live {

class Outcome {
 public:
  enum class Next {
    kNothing,
    kAskForStart,
    kSayAndAsk,  ///< with `stay`: also say the result
    kEnd
  };

  /// Options of the program: a start without confirmation, and staying on after the end of a run.
  Outcome(bool go, bool stay) : go_(go), stay_(stay) {}

  /// The run state has changed.
  Next take(const RunChange& change) {
    run_ = change.to;
    if (change.to == RunState::kFinished) return ended(0, "completed");
    // A run requested by an option does not wait for another start.
    if (change.refused != StartRefusal::kNone && go_) return ended(1, "refused");
    if (change.to == RunState::kAborted) {
      faults_ = change.faults | (change.from == change.to ? faults_ : 0);
      if (ending_ && status_ == 0) {
        // The completed run has failed after all.
        status_ = 1;
        result_ = "aborted";
      }
      const bool by_hand = change.from == RunState::kDriving;
      const bool recoverable = by_hand || (faults_ & kRecoverable) != 0;
      const bool waits = recoverable && !go_ && (faults_ & fault_bit(Fault::moves_unasked)) == 0;
      if (!by_hand) last_status_ = 1;
      if (!waits) return ended(1, "aborted");
    }
    return ending_ ? Next::kNothing : Next::kAskForStart;
  }
  /// The program ends with this status, for `result`. False: it is ending already.
  bool end(int status, const std::string& result) {
    if (std::exchange(ending_, true)) return false;
    status_ = status;
    result_ = result;
    return true;
  }
  /// Somebody ended the program.
  bool interrupt() { return end(stay_ && !under_way(run_) ? last_status_ : 1, "interrupted"); }
  /// Something was lost at the end.
  void fail() { status_ = std::max(status_, 1); }

  bool ending() const { return ending_; }
  int status() const { return status_; }  ///< exit status, once it is ending
  /// "running", "completed", "aborted", "refused", "interrupted" or "duration".
  const std::string& result() const { return result_; }
  FaultMask faults() const { return faults_; }  ///< of the last abort
  RunState run() const { return run_; }

 private:
  Next ended(int status, const std::string& result) {
    if (!stay_) return end(status, result) ? Next::kEnd : Next::kNothing;
    last_status_ = status;
    result_ = result;
    return Next::kSayAndAsk;
  }

  // Faults after which the robot may recover: without --go the program waits for a new start.
  static constexpr FaultMask kRecoverable =
      fault_bit(Fault::link_lost) | fault_bit(Fault::robot_rebooted) |
      fault_bit(Fault::stop_requested) | fault_bit(Fault::world_lost);

  bool go_, stay_;
  bool ending_ = false;
  int status_ = 1, last_status_ = 0;  // of the program, and with `stay` of the last run
  std::string result_ = "running";
  FaultMask faults_ = 0;
  RunState run_ = RunState::kIdle;
};

}  // namespace tp100::live
