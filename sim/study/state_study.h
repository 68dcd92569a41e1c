#pragma once
// What the daemon says of slope, obstacle and camera noise, judged: the lines of `tp100-sim
// reproduce` that are about state and not about place.

#include <cstdint>
#include <vector>

#include "course/robot.h"
#include "sim/study/reproduce.h"

namespace tp100::sim {

/// Three studies: the five courses on a flat floor (5 x `runs` drives; the slope's state must never
/// change), course 3 with its obstacles on the floor, and the step climb model against the body
/// without slip.
std::vector<CourseStudy> study_state(const course::Robot& robot, std::uint64_t first_seed,
                                     int runs);

}  // namespace tp100::sim
