#pragma once
// tp100-sim faults: the list of what --fault can do, and what it does.

#include <string>

namespace tp100::sim {

struct FaultsCommand {
  bool json = false;
  bool drive = false;     ///< drive with each, print expected beside seen
  bool encoders = false;  ///< sweep encoders that fail over speeds, places and robots
  std::string board = "native";
};

/// Prints the list, or the table of drives. Returns 1 if a drive ended otherwise than expected.
/// Throws SetupError.
int run_faults(const FaultsCommand& command);

}  // namespace tp100::sim
