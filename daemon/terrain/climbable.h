#pragma once
// Whether a robot can climb what stands on its course: the static test before anything moves.

#include "course/course.h"
#include "course/robot.h"
#include "model/climb_geometry.h"

namespace tp100::terrain {

/// The robot as the step climb model sees it.
model::ClimbGeometry climb_geometry(const course::ShapeValues& shape);

/// Throws SetupError that names the first block on the path, or ramp, that this robot cannot climb
/// however much grip it has, with the limit. A block counts as on the path if a belt meets it.
/// Too little grip is found while driving.
void require_climbable(const course::Course& course, const course::Robot& robot);

}  // namespace tp100::terrain
