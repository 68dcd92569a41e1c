#pragma once
// A course that leads straight to a goal, as a file that a person could have written. Pure.

#include "core/pose.h"
#include "course/bundled_files.h"

namespace tp100::course {

/// Somewhere to drive to: x, y and yaw of both count.
struct Goal {
  Pose from{};
  Pose to{};
};

/// Name of the course that leads to a goal.
inline constexpr const char* kGoalCourse = "goal";

/// The course file `course` with another start and path: a pivot towards the goal, a line to it and
/// a pivot to its yaw. Fence, keep-out areas, terrain and speed stay; whether the path fits them is
/// for parse_course(). What is shorter than a course file's smallest segments (1 mm, 0.1 deg) is
/// left out. Throws SetupError: no course and so no fence, the robot is there already, or `course`
/// is not TOML.
TextFile course_to(const TextFile& course, const Goal& goal);

}  // namespace tp100::course
