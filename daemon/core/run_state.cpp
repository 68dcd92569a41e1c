#include "core/run_state.h"

namespace tp100 {

std::string_view to_string(RunState state) {
  switch (state) {
    case RunState::kIdle:
      return "idle";
    case RunState::kArming:
      return "arming";
    case RunState::kRunning:
      return "running";
    case RunState::kFinished:
      return "finished";
    case RunState::kAborted:
      return "aborted";
  }
  return "unknown";
}

}  // namespace tp100
