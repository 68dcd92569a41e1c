#pragma once
// The fault list in words. The list itself is wire/faults.h, shared with the firmware.

#include <optional>
#include <string>
#include <string_view>

#include "wire/faults.h"

namespace tp100 {

using wire::Fault;
using wire::fault_bit;
using wire::FaultMask;

/// Faults that a robot can latch. The daemon latches some of them too, e.g. a STOP; the others it
/// latches alone.
inline constexpr FaultMask kRobotFaults = 0xFFFFU;
/// The robot's faults that this version knows.
inline constexpr FaultMask kKnownRobotFaults = 0
#define TP100_KNOWN(bit, name, cause, fix) | fault_bit(Fault::name)
    TP100_ROBOT_FAULTS(TP100_KNOWN)
#undef TP100_KNOWN
    ;

/// One row of the fault list.
struct FaultText {
  Fault fault;
  std::string_view name;   ///< stable identifier, as in logs and JSON
  std::string_view cause;  ///< what happened
  std::string_view fix;    ///< what to do
};

/// The row of `fault`; a row named "unknown" for a bit that this version does not know.
const FaultText& describe(Fault fault);

/// Lowest fault in `mask`, or nothing if the mask is empty.
std::optional<Fault> first_fault(FaultMask mask);

// How to fix a board without this firmware, worded the same in all messages.

/// The command to run, from the source tree or the installed package. `port`: of the board; empty:
/// the program finds it.
inline std::string flash_command(const std::string& port = {}) {
  const std::string options = port.empty() ? "" : " --port " + port;
  return "scripts/flash" + options + " (installed: tp100-flash" + options + ")";
}

}  // namespace tp100
