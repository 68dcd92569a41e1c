#pragma once
// The effect of each fault on a run and on the next one, driven in virtual time: expected and
// observed.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/faults.h"
#include "link/session.h"
#include "messages/sink.h"
#include "sim/robot/emulated_robot.h"

namespace tp100::sim {

/// One fault and its expected effect.
struct FaultTrial {
  std::string_view fault;  ///< as for --fault; empty: none
  std::string_view end;  ///< "completed", "never began" or the name of the fault that ends the run
  /// What the daemon publishes about it, and its least value: a counter of the link ("corrupted":
  /// all four of corrupted frames), or the maximum of a figure during the run, named with its unit.
  std::string_view counter;
  double at_least = 1.0;
  double off_within_s = 0.0;  ///< motors are off within this time; 0: the run completes
  double again_s = 0.0;       ///< time of the next start, which completes; 0: no second run
  std::string_view log{};  ///< beginning of the expected log line, with cause and fix; empty: `end`
  bool chip_only = false;  ///< needs board avr
};

std::span<const FaultTrial> fault_trials();

/// An event of the session, and the hello that was known then.
struct SessionMessage {
  link::SessionEvent event;
  wire::Hello hello;
};

/// A counter or figure of a run, as trials name it.
struct Figure {
  std::string_view name;
  double value;
};

/// The observed effect.
struct FaultOutcome {
  std::string end;
  std::string again;     ///< the end of the second run; empty: there was none
  double counted = 0.0;  ///< value of the trial's counter
  std::vector<Figure> figures{};
  double off_after_s = 0.0;    ///< from the fault's beginning to the last instant with a duty
  std::uint64_t commands = 0;  ///< number that the daemon sent
  std::uint64_t wild = 0;      ///< of these: not finite, out of range or expired when sent
  FaultMask faults = 0;        ///< faults that ended the first run
  std::vector<SessionMessage> session_messages{};
  bool as_expected = false;
};

/// Drives the first 0.6 m of course 1-straight with the reference robot, and once more if the trial
/// requires it. `sink` receives every step. Deterministic. Throws UserError.
FaultOutcome try_fault(const FaultTrial& trial, BoardKind board, messages::Sink* sink = nullptr,
                       std::uint64_t seed = 1);

/// What is expected of a fault, and what was observed, as cells of a table.
std::string expected_effect(const FaultTrial& trial);
std::string seen_effect(const FaultTrial& trial, const FaultOutcome& outcome);

}  // namespace tp100::sim
