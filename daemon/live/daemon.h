#pragma once
// `tp100d run`: one object that owns everything of a run, in the order of construction. Its thread,
// the main one, has ports, log, operator, signals and figures, and exchanges data with the
// real-time thread through rings and atomic values only. Because it accepts STOP from the operator
// and feeds the watchdog, it waits, until the robot is disarmed, neither for a disk nor for a lock
// that is held by a thread waiting for one.

#include <optional>
#include <string>
#include <vector>

#include "config/run_setup.h"
#include "messages/sink.h"

namespace tp100::live {

/// What a run of the daemon is told besides its files.
struct DaemonOptions {
  std::string stats_path{};  ///< JSON file of figures; empty: none
  bool wait = false;         ///< wait for a port and a robot instead of failing
  bool go = false;           ///< start without confirmation, on a physical port too
  bool ran_before = false;   ///< as in StartFacts
  bool stay = false;         ///< stay on after the end of a run
  std::optional<double> duration_s{};
  std::vector<messages::Sink*> sinks{};  ///< get every step; must outlive it
};

/// Runs until the course is completed, the run fails, the time is over or a signal arrives; disarms
/// the robot first. Returns the exit status; throws UserError for errors before the first session.
/// Ends the process if a disk hangs.
int run_daemon(const config::LoadedRun& run, const DaemonOptions& options);

}  // namespace tp100::live
