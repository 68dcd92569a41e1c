#pragma once
// tp100-sim calibrate: the calibration drives of an emulated robot, identified and judged.

#include <string>

#include "sim/run/options.h"

namespace tp100::sim {

struct CalibrateCommand {
  Options options{};
  int repeats = 2;  ///< of each drive, each with noise of its own
  int runs = 1;     ///< whole calibrations, with this and the following seeds
  std::string out;  ///< folder for the recordings; empty: none
  bool json = false;
};

/// Drives straight ahead, arcs and turns on the spot in both directions under an overhead camera,
/// as a robot of which nothing is known yet ([model] at its defaults), identifies and prints the
/// values beside what the body really did, and how often the intervals held it. Returns 0 if every
/// calibration came within the stated accuracy, else 1. Throws SetupError.
int run_calibrate(const CalibrateCommand& command);

}  // namespace tp100::sim
