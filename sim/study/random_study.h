#pragma once
// Courses of the whole format, sampled from a number: tracked, monitored, and judged by a measure
// that shares no code with the tracker's progress or the report's figures.

#include <cstdint>
#include <string>

#include "sim/study/study.h"

namespace tp100::sim {

/// What became of one random course.
struct RandomDrive {
  std::uint64_t seed = 0;
  std::string robot;
  std::string refused;  ///< why it was not begun; empty: it was driven
  bool completed = false;
  std::string cause;          ///< why it was not completed
  int false_alarms = 0;       ///< disturbances that were detected but did not occur
  double deviation_m = 0.0;   ///< largest distance of the true position from the path
  double unreported_m = 0.0;  ///< what the run's own largest cross-track error leaves out of it
};

/// Drives random_course(seed) with one of the bundled robots, an overhead camera and the fused
/// pose; its obstacles are really there for every other seed. Deviations count outside disturbances
/// and their recovery.
RandomDrive drive_random(std::uint64_t seed);

/// As a study: `count` courses from `first_seed` on. Refused ones do not count as runs.
CourseStudy study_random(std::uint64_t first_seed, int count);

}  // namespace tp100::sim
