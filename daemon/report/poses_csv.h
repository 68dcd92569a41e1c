#pragma once
// Every pose of a run, with the truth, as CSV.

#include <string>

#include "report/run_result.h"

namespace tp100::report {

/// Header t_s, then x_m, y_m, z_m, pitch_rad and yaw_rad with the prefixes truth_, model_,
/// odometry_ and, with a camera, fused_. One row an instant, full double precision.
std::string poses_csv(const RunResult& result);

}  // namespace tp100::report
