#pragma once
// Static test, before any motion, whether a robot can climb the obstacles of its course.

#include "course/course.h"
#include "course/robot_file.h"

namespace tp100::terrain {

/// Throws UserError that names the first obstacle on the path that this robot cannot climb with any
/// amount of traction, and the limit. An obstacle counts as on the path if a track meets it.
/// Insufficient traction is found while driving.
void require_climbable(const course::Course& course, const course::Robot& robot);

}  // namespace tp100::terrain
