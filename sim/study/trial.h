#pragma once
// Many runs of one robot on one course, and what they say together.

#include <cstdint>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "core/spread.h"
#include "report/metrics.h"
#include "report/run_result.h"
#include "sim/robot/lockstep.h"

namespace tp100::sim {

/// One course, one robot, seeds `first_seed` and following, with the overhead camera (but not on a
/// bench), steered by the fused pose (on a bench by odometry).
struct Trial {
  course::Course course{};
  course::Robot robot{};
  bridge::Setup setup = bridge::Setup::kFlat;
  BoardKind board = BoardKind::kNative;
  std::uint64_t first_seed = 1;
  int runs = 10;
  bool both_directions = true;  ///< each seed on the mirrored course too
  double blind_from_s = 0.0;    ///< the camera sees nothing from here, since its first picture ...
  double blind_s = 0.0;         ///< ... for this long
};

struct TrialRun {
  report::RunResult result{};
  report::RunFigures figures{};
  double fused_max_flat_m = 0.0;                      ///< largest fused error with the body level
  double fused_max_obstacle_m = 0.0;                  ///< ... and leaning on something
  double fused_rms_m = 0.0, fused_rms_yaw_rad = 0.0;  ///< outside the shoves
  double model_rms_m = 0.0, model_rms_yaw_rad = 0.0;
  double slowest_recovery_s = 0.0;  ///< infinite if it never recovered
};

/// All runs, one after the other.
std::vector<TrialRun> run_trial(const Trial& trial);

/// One figure over the runs.
Spread spread_of(const std::vector<TrialRun>& runs, double (*figure)(const TrialRun&));

/// Runs that were completed.
int completed(const std::vector<TrialRun>& runs);

}  // namespace tp100::sim
