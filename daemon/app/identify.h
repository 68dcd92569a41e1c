#pragma once
// `tp100d identify`: parameters of a robot from recorded drives, to a robot file.

#include <string>
#include <vector>

#include "app/guided.h"

namespace tp100::app {

struct IdentifyOptions {
  std::vector<std::string> runs;  ///< recordings, or CSV files, of drives; none if it drives
  std::string out;                ///< robot file to write
  std::string robot;       ///< what everything else is taken from; empty: the configuration's
  std::string measured;    ///< CSV file of hand measurements; empty: none
  std::string config;      ///< empty: defaults
  std::string date;        ///< of the runs, as the file should say; empty: today
  bool drive = false;      ///< drive the calibration courses first
  GuidedOptions guided{};  ///< how; robot and configuration are taken from above
};

/// The command. Prints the report; writes nothing unless all went well. Exit status, 1 if a
/// drive was not completed; throws SetupError.
int run_identify(const IdentifyOptions& options);

}  // namespace tp100::app
