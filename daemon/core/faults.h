#pragma once
// The fault list as text. The list itself is wire/faults.h, shared with the firmware.

#include <array>
#include <bit>
#include <optional>
#include <string>
#include <string_view>

#include "wire/faults.h"

namespace tp100 {

using wire::Fault;
using wire::fault_bit;
using wire::FaultMask;

/// The robot's faults, bits 0 to 15. The daemon latches those, too, that it sees in a run's samples
/// or finds itself (STOP, a stale IMU, commands not accepted); bits 16 to 63 are its own alone.
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

inline constexpr auto kFaultTexts = std::to_array<FaultText>({
#define TP100_TEXT(bit, name, cause, fix) {Fault::name, #name, cause, fix},
    TP100_ROBOT_FAULTS(TP100_TEXT) TP100_DAEMON_FAULTS(TP100_TEXT)
#undef TP100_TEXT
});
inline constexpr FaultText kUnknownFaultText{
    Fault{255}, "unknown", "a fault that this version does not know", "update the daemon"};

/// The row of `fault`; kUnknownFaultText for a bit that this version does not know.
constexpr const FaultText& describe(Fault fault) {
  for (const FaultText& text : kFaultTexts)
    if (text.fault == fault) return text;
  return kUnknownFaultText;
}

/// Lowest fault in `mask`, or nothing if the mask is empty.
constexpr std::optional<Fault> first_fault(FaultMask mask) {
  if (mask == 0) return std::nullopt;
  return static_cast<Fault>(std::countr_zero(mask));
}

/// Calls visit(fault) for each of them, the lowest bit first.
template <class Visit>
constexpr void each_fault(FaultMask mask, const Visit& visit) {
  for (; mask != 0; mask &= mask - 1) visit(*first_fault(mask));
}

// How to fix a board without this firmware, worded the same in all messages.

/// The command to run, from the source tree or the installed package. `port`: of the board; empty:
/// the program finds it.
inline std::string flash_command(const std::string& port = {}) {
  const std::string options = port.empty() ? "" : " --port " + port;
  return "scripts/flash" + options + " (installed: tp100-flash" + options + ")";
}

}  // namespace tp100
