#pragma once
// The charts of the page of a reproduction.

#include <string>
#include <vector>

#include "sim/lab/reproduce.h"

namespace tp100::sim {

/// Charts of the first run of a study: path, yaw, errors of the estimates over time, and on
/// obstacles the climb angle. On a stand, where the body does not move, without errors. With
/// disturbances the model is shown as it is judged, restarted from the truth at the end of each.
std::vector<std::string> run_charts(const CourseStudy& study);

/// Pitch of the body, of the model and of eq 6 to the letter over travel, and the beginnings of the
/// model's phases.
std::string climb_chart(const ClimbCheck& climb);

/// Measured slip against slope beside the paper's, of the left and of the right track.
std::vector<std::string> slope_charts(const Reproduction& what);

}  // namespace tp100::sim
