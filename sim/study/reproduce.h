#pragma once
// The paper's experiment, all of it, on the emulated robots: what was driven and what it says.

#include <string>
#include <vector>

#include "sim/study/slope_command.h"
#include "sim/study/trial.h"

namespace tp100::sim {

/// One line of the table of limits. `limit` is what we set ourselves; a value above it, or one that
/// is none, does not hold.
struct Judged {
  std::string course, robot;
  std::string what;    ///< model, fused or tracking, and which figure of it
  std::string unit;    ///< of all three values
  double limit = 0.0;  ///< negative: shown, not judged
  Spread ours{};
  bool holds() const { return limit < 0.0 || ours.median <= limit; }
};

/// Every run of one robot on one course in one set-up, and the figures that are judged.
struct CourseStudy {
  std::string course, robot, setup, board;
  std::string blind;  ///< when the camera saw nothing; empty: never
  int runs = 0, completed = 0;
  double distance_m = 0.0;
  std::vector<Judged> judged;
  Spread mse_x_m2{}, mse_y_m2{}, mse_yaw_rad2{};  ///< of the model
  TrialRun shown{};                               ///< the first run, for the figures
};

/// Drives `trial` and judges it by the limits of its kind of course: 1-straight, 1-curve, 1-sharp,
/// 2 or 3. `reference`: the reference robot's limits; other robots' model may be off by 3 % of the
/// distance.
CourseStudy study(const Trial& trial, const std::string& kind, bool reference);

struct ReproduceCommand {
  std::string out = "reproduce";  ///< folder
  std::string part = "all";       ///< paper, state, robots, drawn, held-out, avr or all
  std::uint64_t seed = 1;
  int runs = 10;
  int drawn = 10;  ///< robots to draw, each driven with one seed
};

/// Drives everything, writes index.html, results.json and the trajectories into the folder, prints
/// the table of limits. Returns 0 if every limit holds and every run was completed, else 1. Throws
/// SetupError.
int run_reproduce(const ReproduceCommand& command);

}  // namespace tp100::sim
