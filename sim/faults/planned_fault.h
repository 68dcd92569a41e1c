#pragma once
// One fault as asked for on the command line.

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "sim/faults/fault_kind.h"

namespace tp100::sim {

struct PlannedFault {
  FaultKind kind{};
  double number = 0.0;  ///< in the unit of the list
  bool to_host = true, to_robot = true;
  bool left = true, right = true;
  std::int64_t begin_ns = 0;  ///< since the port was opened
  std::int64_t end_ns = std::numeric_limits<std::int64_t>::max();

  bool active(std::int64_t at_ns) const { return at_ns >= begin_ns && at_ns < end_ns; }
};

/// NAME[:NUMBER][:WORD][@T[+D]]: from T s after the port was opened (0) for D s (for ever). Throws
/// SetupError.
PlannedFault parse_fault(std::string_view text);
std::vector<PlannedFault> parse_faults(const std::vector<std::string>& texts);

}  // namespace tp100::sim
