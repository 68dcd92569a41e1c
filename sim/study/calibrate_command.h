#pragma once
// tp100-sim calibrate: the calibration drives of an emulated robot, identified and judged.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "identify/identify.h"
#include "sim/robot/options.h"
#include "sim/study/effective_motion.h"

namespace tp100::sim {

/// One calibration: what was found and what the body really did.
struct Calibration {
  identify::Identification found{};
  std::array<double, identify::kParameters> truth{};
  std::vector<CalibrationDrive> drives;

  /// The stated accuracy was kept: slip within 0.01, the wheelbases within 2 %.
  bool accurate() const;
  /// The interval of a parameter that was found holds its truth.
  bool holds(identify::Parameter parameter) const;
};

/// Drives straight ahead, arcs and turns on the spot in both directions under an overhead camera,
/// as a robot of which nothing is known yet ([model] at its defaults), and identifies it. No two
/// drives share their noise. Throws SetupError.
Calibration calibrate(const Loaded& loaded, int repeats, std::uint64_t seed);

struct CalibrateCommand {
  Options options{};
  int repeats = 2;  ///< of each drive, each with noise of its own
  int runs = 1;     ///< whole calibrations, with this and the following seeds
  std::string out;  ///< folder for the recordings; empty: none
  bool json = false;
};

/// Calibrates and prints the values beside the truth, and how often the intervals held it. Returns
/// 0 if every calibration came within the stated accuracy, else 1. Throws SetupError.
int run_calibrate(const CalibrateCommand& command);

}  // namespace tp100::sim
