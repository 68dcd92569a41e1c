#pragma once
// Trajectories in the TUM format, which evo and rpg_trajectory_evaluation read: one line a pose,
// `time x y z qx qy qz qw`, seconds and metres.

#include <string>

#include "core/pose.h"

namespace tp100::report {

/// One line with its line feed. Microseconds and micrometres are kept.
std::string tum_line(double t_s, const Pose& pose);

}  // namespace tp100::report
