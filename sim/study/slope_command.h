#pragma once
// tp100-sim slope: the paper's slope experiment on the emulated body.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "course/robot.h"

namespace tp100::sim {

/// What was measured on one slope, from the body's exact motion.
struct SlopeSlip {
  double slope_rad = 0.0;
  double left = 0.0, right = 0.0;  ///< 1 - speed of the body over either belt / belt speed
  double yaw_rate_radps = 0.0;
  bool climbed = false;  ///< false: it slid or fell over
};

/// A slope of the experiment and what the paper's table has for it; it has no row for 4 deg.
struct SlopeRow {
  double slope_deg;
  std::optional<double> paper_left, paper_right;
};
/// 0, 4 ... 28 deg.
std::span<const SlopeRow> slope_rows();

/// Straight up an even slope, both belts at `belt_mps` for two seconds after half a second of
/// running in. Pure.
SlopeSlip measure_slope(const course::EmulatedBody& values, double slope_rad, double belt_mps);

struct SlopeCommand {
  std::string robot;  ///< bundled name or file; empty: the reference robot
  bool json = false;
};

/// Drives 0, 4 ... 28 deg at 0.10 m/s and prints the slip of both belts beside the paper's table.
/// Returns 0 if the robot climbed every slope, else 1. Throws SetupError.
int run_slope(const SlopeCommand& command);

}  // namespace tp100::sim
