#pragma once
// Where on its path a run goes on that starts from where the robot is.

#include <optional>

#include "core/pose.h"
#include "course/path.h"

namespace tp100::bridge {

/// Length from the start of the path: where the last run ended (`ended_m`; 0: none did), as long as
/// the robot is within `reach_m` of it; otherwise the nearest part of the path within reach.
/// Nothing: there is none, or nothing is left of the path. No allocation; safe in the real-time
/// thread.
std::optional<double> onward_m(const course::Path& path, const Pose& pose, double ended_m,
                               double reach_m);

}  // namespace tp100::bridge
