#pragma once
// The remedy for a board without this firmware, in the words of all messages.

#include <string>

namespace tp100 {

/// What to run, from the source tree or from the installed package. `port`: of the board; empty:
/// the program finds it.
inline std::string flash_command(const std::string& port = {}) {
  const std::string options = port.empty() ? "" : " --port " + port;
  return "scripts/flash" + options + " (installed: tp100-flash" + options + ")";
}

}  // namespace tp100
