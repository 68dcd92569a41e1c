#pragma once
// Which constants of the extended model pay: what an information criterion says of the model
// without each of them.

#include <cstdint>
#include <string>
#include <vector>

#include "sim/lab/study.h"

namespace tp100::sim {

/// Identifies `robot` (a name in config/robots or a file) on `body` (ode or shear) from its
/// identification drives: by the extended model, by that model without each constant of ours in
/// turn, and by eqs 1-5. Returns the Schwarz criterion of each form less that of the extended
/// model: a constant brings nothing where it is below 0. The criterion is n ln(variance) + k ln n,
/// for position and yaw of n images that count as independent
/// (identify::IdentifySettings::correlated_s) and k constants.
CourseStudy study_constants(const std::string& robot, const std::string& body, std::uint64_t seed);

/// The largest value of each criterion over all robots, from those of `studies` that
/// study_constants() returned. Precondition: there is one.
CourseStudy largest_criteria(const std::vector<CourseStudy>& studies);

}  // namespace tp100::sim
