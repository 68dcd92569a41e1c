#pragma once
// `tp100d export`: recordings as files that other programs read.

#include <string>
#include <vector>

#include "analysis/recording.h"

namespace tp100::app {

struct ExportOptions {
  std::vector<std::string> runs;  ///< recordings or their folders
  bool csv = false;               ///< samples.csv (as identify reads it), poses.csv
  bool tum = false;               ///< model.tum, odometry.tum, fused.tum, truth.tum
  std::string out;                ///< folder; empty: beside the recording. Only for one run
};

/// The estimates at each sample of the run (of the whole recording, if nothing ran): t_s since the
/// recording began, x, y, z, roll, pitch and yaw of each, and what steered. Full double precision.
std::string poses_csv(const analysis::Recording& recording);

/// Trajectories in the TUM format over the same time; `truth` is empty where it is not known.
struct Trajectories {
  std::string model, odometry, fused, truth;
};
Trajectories trajectories(const analysis::Recording& recording);

/// The command. Throws SetupError.
int run_export(const ExportOptions& options);

}  // namespace tp100::app
