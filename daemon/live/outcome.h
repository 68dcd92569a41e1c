#pragma once
// What the end of a run means for the program: its exit status, and whether it waits for another
// start. Pure.

#include <algorithm>
#include <string>

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
  Next take(const RunChange& change);
  /// The program ends with this status, for `result`. False: it is ending already.
  bool end(int status, const std::string& result);
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
  Next ended(int status, const std::string& result);

  bool go_, stay_;
  bool ending_ = false;
  int status_ = 1, last_status_ = 0;  // of the program, and with `stay` of the last run
  std::string result_ = "running";
  FaultMask faults_ = 0;
  RunState run_ = RunState::kIdle;
};

}  // namespace tp100::live
