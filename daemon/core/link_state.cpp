#include "core/link_state.h"

namespace tp100 {

std::string_view to_string(SessionState state) {
  switch (state) {
    case SessionState::kClosed:
      return "closed";
    case SessionState::kListening:
      return "listening";
    case SessionState::kHello:
      return "hello";
    case SessionState::kParameters:
      return "parameters";
    case SessionState::kSyncing:
      return "syncing";
    case SessionState::kReady:
      return "ready";
    case SessionState::kRefused:
      return "refused";
  }
  return "unknown";
}

}  // namespace tp100
