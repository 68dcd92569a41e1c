#pragma once
// Checks the covariance that the daemon publishes: how often the true pose lies within two standard
// deviations of the estimated one.

#include <cstdint>
#include <string>
#include <vector>

#include "course/robot_file.h"
#include "sim/study/study.h"

namespace tp100::sim {

/// A robot with random placement error and gyro scale, both with the standard deviations that the
/// filter assumes. `uneven`: on a floor sampled from the seed, else on an even one.
course::Robot placed_by_hand(course::Robot robot, bool uneven);

/// Drives every bundled robot on 1-sharp and 2, with and without an overhead camera, on even and
/// uneven ground. `body`: ode or shear; on shear each robot is identified first and its file is
/// written to `folder`. Returns one study per ground and sensors, over all robots, courses and
/// seeds together: the shares within two standard deviations must be 90 to 99 %.
std::vector<CourseStudy> study_covariance(const std::string& body, const std::string& folder,
                                          std::uint64_t first_seed, int runs);

}  // namespace tp100::sim
