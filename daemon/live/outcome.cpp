#include "live/outcome.h"

#include <utility>

#include "core/faults.h"

namespace tp100::live {
namespace {

// Faults after which the robot may recover: without --go the program waits for a new start.
constexpr FaultMask kRecoverable = fault_bit(Fault::link_lost) | fault_bit(Fault::robot_rebooted) |
                                   fault_bit(Fault::stop_requested) | fault_bit(Fault::world_lost);

}  // namespace

Outcome::Next Outcome::take(const RunChange& change) {
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

Outcome::Next Outcome::ended(int status, const std::string& result) {
  if (!stay_) return end(status, result) ? Next::kEnd : Next::kNothing;
  last_status_ = status;
  result_ = result;
  return Next::kSayAndAsk;
}

bool Outcome::end(int status, const std::string& result) {
  if (std::exchange(ending_, true)) return false;
  status_ = status;
  result_ = result;
  return true;
}

}  // namespace tp100::live
