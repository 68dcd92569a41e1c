#pragma once
// Identification that chooses its own manoeuvres (identify/next_manoeuvre.h), by emulated robots
// under an overhead camera: seconds of driving, and how often its intervals contain the truth.

#include <cstdint>
#include <string>
#include <vector>

#include "course/bundled_files.h"
#include "identify/identify.h"
#include "identify/next_manoeuvre.h"
#include "sim/lab/calibration.h"
#include "sim/robot/options.h"

namespace tp100::sim {

/// Result of one robot's automatic identification.
struct AutoCalibration {
  Calibration calibration{};
  identify::AutoProgress progress{};
  std::vector<std::string> manoeuvres;  ///< in driving order
};

/// Drives manoeuvre after manoeuvre inside the fence of `area` as an unidentified robot, each from
/// where the camera saw the last one end, each with noise of its own. Throws UserError if a
/// manoeuvre was not finished, or none fits into the fence.
AutoCalibration calibrate_by_itself(const Loaded& loaded, const course::TextFile& area,
                                    std::uint64_t seed);

struct AutoCommand {
  Options options{};
  int runs = 1;                     ///< whole identifications, with this and the following seeds
  std::string area = "1-straight";  ///< course whose fence contains the manoeuvres
  int sampled = 0;  ///< number of sampled robots (sampled.h) besides the bundled ones
};

/// tp100-lab identify: studies all bundled robots, or the one named, and the sampled ones. Prints a
/// line per robot, then the median of the seconds and how often the intervals contained the truth.
/// Returns 0 if all intervals of every robot became narrow, else 1. Throws UserError.
int run_auto(const AutoCommand& command);

}  // namespace tp100::sim
