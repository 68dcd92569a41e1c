#pragma once
// `tp100d export`: recordings as files that other programs read.

#include <string>
#include <vector>

namespace tp100::app {

// poses.csv and the trajectories cover the run (the whole recording, if nothing ran), a row for
// each step that got a sample; t_s counts from the start of the recording. Full double precision.
struct ExportOptions {
  std::vector<std::string> runs;  ///< recordings or their folders
  bool csv = false;               ///< samples.csv (as identify reads it), poses.csv
  bool tum = false;               ///< model.tum, odometry.tum, fused.tum, truth.tum
  std::string out;                ///< folder; empty: beside the recording. Only for one run
};

/// The command. Throws SetupError.
int run_export(const ExportOptions& options);

}  // namespace tp100::app
