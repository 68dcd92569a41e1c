#pragma once
// Identification that drives itself (identify/next_manoeuvre.h), by emulated robots under the
// overhead camera: seconds of driving that it takes, and how often its intervals hold the truth.

#include <cstdint>
#include <string>
#include <vector>

#include "course/bundled_files.h"
#include "identify/identify.h"
#include "identify/next_manoeuvre.h"
#include "sim/robot/options.h"
#include "sim/study/commands.h"

namespace tp100::sim {

/// What one robot found out by itself.
struct AutoCalibration {
  Calibration calibration{};
  identify::AutoProgress progress{};
  std::vector<std::string> manoeuvres;  ///< in driving order
};

/// Drives manoeuvre after manoeuvre inside the fence of `area`, as a robot of which nothing is
/// known, each from where the camera saw the last one end. No two share their noise. Throws
/// SetupError: a manoeuvre was not finished, or none fits into the fence.
AutoCalibration calibrate_by_itself(const Loaded& loaded, const course::TextFile& area,
                                    std::uint64_t seed);

/// All bundled robots, or the one named, and `sampled` ones of the stated ranges. Prints a line per
/// robot, then the median of the seconds and how often the intervals held the truth. Returns 0 if
/// all intervals of every robot became narrow, else 1. Throws SetupError.
int run_auto_calibrate(const CalibrateCommand& command);

}  // namespace tp100::sim
