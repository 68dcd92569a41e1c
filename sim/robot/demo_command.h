#pragma once
// tp100-sim demo: the two real programs, one at each end of a pseudo-terminal.

#include <string>

#include "sim/robot/options.h"

namespace tp100::sim {

struct DemoCommand {
  Options options{};
  std::string course = "1-curve";
  bool headless = false;
};

/// Starts `tp100-sim robot` and `tp100d run`, waits for the course to end, at most three times more
/// if the machine stood still meanwhile, then prints the scored table. Returns 0 if both the live
/// and the scored run were completed. Throws SetupError.
int run_demo(const DemoCommand& command);

}  // namespace tp100::sim
