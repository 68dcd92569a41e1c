#pragma once
// Random courses that use the whole format: driven, monitored, and judged by a measure that shares
// no code with the tracker's progress or the report's figures.

#include <cstdint>
#include <string>

#include "sim/lab/study.h"

namespace tp100::sim {

/// Result of one random course.
struct RandomDrive {
  std::uint64_t seed = 0;
  std::string robot;
  std::string refused;  ///< why it was not driven; empty: it was driven
  bool completed = false;
  std::string cause;          ///< why it was not completed
  int false_alarms = 0;       ///< disturbances that were detected but did not occur
  double deviation_m = 0.0;   ///< largest distance of the true position from the path
  double unreported_m = 0.0;  ///< by how much it exceeds the run's own largest cross-track error
};

/// Drives random_course(seed) with one of the bundled robots, an overhead camera and the fused
/// pose; with every other seed its obstacles are real. Deviations count outside disturbances and
/// their recovery.
RandomDrive drive_random(std::uint64_t seed);

/// Studies `count` courses from `first_seed` on. Refused ones do not count as runs.
CourseStudy study_random(std::uint64_t first_seed, int count);

}  // namespace tp100::sim
