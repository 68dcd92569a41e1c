#pragma once
// A course as data: path, terrain and disturbances. Lengths and radii that the paper does not print
// are marked `ours` in the file.

#include <string>
#include <variant>
#include <vector>

#include "core/pose.h"
#include "course/fence.h"
#include "course/terrain.h"

namespace tp100::course {

/// Shorter segments are none.
inline constexpr double kSmallestLengthM = 0.001, kSmallestTurnDeg = 0.1;

/// Straight segment. [m]
struct Line {
  double length_m;
};
/// Circular segment; a positive angle turns left.
struct Arc {
  double radius_m;
  double angle_rad;
};
/// Turn on the spot; a positive angle turns left.
struct Pivot {
  double angle_rad;
};
using Segment = std::variant<Line, Arc, Pivot>;

/// A disturbance: the robot is pushed sideways (left positive) and in yaw, once it has driven
/// `at_m` of the path.
struct Disturbance {
  double at_m;        ///< path length at which it happens
  double sideways_m;  ///< in the robot's own y direction
  double yaw_rad;
  double duration_s;  ///< the push is spread over this time
};

/// One course. The path starts at `start` and is followed at `speed_mps`.
struct Course {
  std::string name;  ///< file stem, e.g. "1-curve"
  std::string description;
  double speed_mps = 0.10;
  bool identifies = false;    ///< driven to find the robot's values: its turns are not known yet
  Pose start{};               ///< x, y, yaw
  std::vector<Segment> path;  ///< never empty
  std::vector<Disturbance> disturbances;  ///< ascending at_m
  Terrain terrain{};
  Fence fence{};
};

/// Parses a course file. `file` is only used in messages. Throws SetupError (file:line:column).
/// Pure: reads no file itself.
Course parse_course(const std::string& text, const std::string& file);

/// The course mirrored along its x axis: left is right, everything else is the same. Its name gets
/// "-mirrored". Pure.
Course mirrored(const Course& course);

}  // namespace tp100::course
