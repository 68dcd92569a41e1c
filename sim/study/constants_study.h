#pragma once
// Which constants of the extended model pay: what an information criterion says of the model
// without each of them.

#include <cstdint>
#include <string>
#include <vector>

#include "sim/study/study.h"

namespace tp100::sim {

/// Identifies `robots` (names in config/robots or files) on `body` (ode or shear) from their
/// calibration drives: by the extended model, by that model without each constant of ours in turn,
/// and by eqs 1-5. Returns one
/// study per robot with the Schwarz criterion of each form less that of the extended model, and one
/// with the largest value over all robots: the constant brings nothing where it is below 0. The
/// criterion is n ln(variance) + k ln n, for position and yaw of n images that count as independent
/// (identify::IdentifySettings::correlated_s) and k constants.
std::vector<CourseStudy> study_constants(const std::vector<std::string>& robots,
                                         const std::string& body, std::uint64_t seed);

}  // namespace tp100::sim
