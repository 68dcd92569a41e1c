#pragma once
// A course as data: path, terrain, fence and disturbances. Lengths and radii that the paper does
// not print are marked `ours` in the file.

#include <cstddef>
#include <string>
#include <vector>

#include "core/fields.h"
#include "core/pose.h"
#include "course/segment.h"
#include "course/terrain.h"

namespace tp100::course {

// The fence: where on the floor the reference point may be.

/// A corner of a polygon, in the world frame.
struct Vertex {
  double x_m = 0.0, y_m = 0.0;
};
TP100_FIELDS(Vertex, x_m, y_m)
/// At least three corners in order, either way around; the last one is joined to the first. Its
/// edges do not cross.
using Polygon = std::vector<Vertex>;

/// A boundary, and areas inside it that the reference point may not enter.
struct Fence {
  double min_x_m, max_x_m, min_y_m, max_y_m;  ///< the boundary, or the bounds of its corners
  Polygon corners{};                          ///< of the boundary; empty: it is a rectangle
  std::vector<Polygon> keep_out{};
};

// No allocation except in corners_of(); the others are safe in the real-time thread.

/// Whether a place lies inside a polygon; on its edge the result may be either.
bool contains(const Polygon& polygon, double x_m, double y_m);

/// Whether the reference point may be there: inside the boundary or on a rectangle's edge, and in
/// no keep-out area.
bool contains(const Fence& fence, double x_m, double y_m);

/// How far from the nearest place where the reference point may be; 0: it may be there. In an area
/// that overlaps another one or the boundary this is the larger of both distances.
double outside_m(const Fence& fence, double x_m, double y_m);

/// Whether two edges of the polygon cross or touch, except neighbours at their corner.
bool crosses_itself(const Polygon& polygon);

/// The corners of the boundary, also of a rectangle.
Polygon corners_of(const Fence& fence);

/// The point nearest to a place on the edge that follows corner `index`.
Vertex nearest_on_edge(const Polygon& polygon, std::size_t index, double x_m, double y_m);

/// Longer paths are invalid: what viewers get of a course grows with its path.
inline constexpr double kLongestPathM = 1000.0;

/// A disturbance: the robot is pushed sideways (left positive) and in yaw, once it has driven
/// `at_m` of the path.
struct Disturbance {
  double at_m;        ///< path length at which it happens
  double sideways_m;  ///< in the robot's own y direction
  double yaw_rad;
  double duration_s;  ///< the push is spread over this time
};
TP100_FIELDS(Disturbance, at_m, sideways_m, yaw_rad, duration_s)

/// One course. The path starts at `start` and is followed at `speed_mps`.
struct Course {
  std::string name;  ///< file stem, e.g. "1-curve"
  std::string description;
  double speed_mps = 0.10;
  bool identifies = false;    ///< driven to identify the robot, whose turns are not known yet
  Pose start{};               ///< x, y, yaw
  std::vector<Segment> path;  ///< never empty
  std::vector<Disturbance> disturbances;  ///< ascending at_m
  Terrain terrain{};
  Fence fence{};
};

/// Parses a course file. `file` is only used in messages. Throws UserError (file:line:column).
/// Pure: reads no file itself.
Course parse_course(const std::string& text, const std::string& file);

/// A course that may not be driven as long as it has an error.
struct Draft {
  Course course;      ///< its path and disturbances may lie anywhere
  std::string error;  ///< empty: none
};
/// Same, but throws only if pieces cannot be read; whether they fit together is told by `error`.
Draft parse_draft(const std::string& text, const std::string& file);

/// The course mirrored along its x axis: left is right, everything else is the same. Its name gets
/// "-mirrored". Pure.
Course mirrored(const Course& course);

}  // namespace tp100::course
