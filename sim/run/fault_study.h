#pragma once
// What each fault does to a run: driven in virtual time, expected beside seen.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "sim/run/emulated_robot.h"

namespace tp100::sim {

/// One fault and what must come of it.
struct FaultTrial {
  std::string_view fault;  ///< as for --fault
  std::string_view end;  ///< "completed", "never began" or the name of the fault that ends the run
  std::string_view counter;   ///< the link's counter that must rise; empty: none
  double off_within_s = 0.0;  ///< motors are off so long after the fault begins; 0: not asked
  bool chip_only = false;     ///< wants board avr
};

std::span<const FaultTrial> fault_trials();

/// What was seen. Words only: numbers are another thing on each board.
struct FaultOutcome {
  std::string end;
  std::uint64_t counted = 0;   ///< of the trial's counter
  double off_after_s = 0.0;    ///< from the fault's beginning to the last instant with a duty
  std::uint64_t commands = 0;  ///< that the daemon sent
  std::uint64_t wild = 0;      ///< of these not finite, out of range or expired when sent
  bool as_expected = false;
};

/// Drives course 1-straight with the reference robot. Deterministic. Throws SetupError.
FaultOutcome try_fault(const FaultTrial& trial, BoardKind board, std::uint64_t seed = 1);

/// The row of a Markdown table: fault, expected, seen.
std::string fault_row(const FaultTrial& trial, BoardKind board, const FaultOutcome& outcome);
/// Its head.
std::string fault_table_head();

}  // namespace tp100::sim
