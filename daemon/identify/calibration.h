#pragma once
// Which courses calibrate a robot.

#include <string>
#include <vector>

#include "course/robot.h"

namespace tp100::identify {

/// Bundled courses in driving order: straight, arcs and turns on the spot, both directions. The
/// arcs are wide turns for a robot of this size. Pure.
std::vector<std::string> calibration_courses(const course::ShapeValues& shape);

}  // namespace tp100::identify
