#pragma once
// Checks the covariance that the daemon publishes: how often the true pose lies within two standard
// deviations of the estimated one.

#include <cstdint>
#include <string>
#include <vector>

#include "course/robot_file.h"
#include "sim/lab/study.h"

namespace tp100::sim {

/// A robot with random placement error, gyro scale and drift of the gyro with temperature, with the
/// standard deviations that the filter assumes. `uneven`: on a floor sampled from the seed, else on
/// an even one.
course::Robot placed_by_hand(course::Robot robot, bool uneven);

/// The bundled robots on a body, ode or shear. On shear each is identified there, and its file
/// written to `folder`. Throws UserError.
std::vector<course::Robot> robots_on(const std::string& body, const std::string& folder);

struct CovarianceStudy {
  bool uneven = false;
  bool camera = false;  ///< judges the fused pose; without: model and odometry
  std::uint64_t first_seed = 1;
  int runs = 1;  ///< of each robot, course and direction
};

/// Drives robots of one body on 1-sharp and 2. One study over all robots, courses and seeds
/// together: the shares within two standard deviations must be 90 to 99 %; the upper limit is not
/// judged for the model's yaw and, with a camera, for the position.
CourseStudy study_covariance(const std::vector<course::Robot>& robots, const CovarianceStudy& what);

}  // namespace tp100::sim
