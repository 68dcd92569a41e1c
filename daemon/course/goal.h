#pragma once
// A course with another start and path, as a file that a person could have written: straight to a
// goal, or along any path. Pure.

#include <string>
#include <vector>

#include "core/pose.h"
#include "course/bundled_files.h"
#include "course/course.h"

namespace tp100::course {

/// A drive from one pose to another: x, y and yaw of both are used.
struct Goal {
  Pose from{};
  Pose to{};
};

/// Name of the course that leads to a goal.
inline constexpr const char* kGoalCourse = "goal";

/// The course file `course` with another start and path: a pivot towards the goal, a line to it and
/// a pivot to its yaw. Fence, keep-out areas, terrain and speed stay; whether the path fits them is
/// checked by parse_course(). Segments below a course file's smallest (1 mm, 0.1 deg) are left out.
/// Throws UserError: no course and so no fence, the robot is there already, or `course` is not
/// TOML.
TextFile course_to(const TextFile& course, const Goal& goal);

/// The content that replaces the rest of a course file.
struct OtherPath {
  std::string name;         ///< of the course
  std::string description;  ///< one line
  double speed_mps = 0.10;
  bool identifies = false;
  Pose start{};
  std::vector<Segment> path;
};

/// The course file `course` with another path. Fence, keep-out areas and terrain stay; whether the
/// path fits them is checked by parse_course(). Throws UserError: no course, or it is not TOML.
TextFile course_along(const TextFile& course, const OtherPath& other);

}  // namespace tp100::course
