#pragma once
// The geometry of a course's path: the reference pose, and the nearest point of the path.

#include <cstddef>
#include <optional>
#include <vector>

#include "course/course.h"

namespace tp100::course {

/// A point of the path.
struct PathPoint {
  double s_m = 0.0;  ///< length from the start; pivots add none
  double x_m = 0.0, y_m = 0.0;
  double yaw_rad = 0.0;        ///< tangent, unwrapped along the path
  double curvature_1pm = 0.0;  ///< left positive
};

/// A segment of the course in its place on the path. The robot stops before and after every pivot.
struct PathSegment {
  using Kind = SegmentKind;
  Kind kind = Kind::kLine;
  PathPoint begin{};
  PathPoint end{};        ///< for a pivot: same place, yaw turned
  double length_m = 0.0;  ///< 0 for a pivot
};

/// The path in closed form. Built once; queries allocate nothing and are safe in the real-time
/// thread.
class Path {
 public:
  explicit Path(const Course& course);

  /// Never empty.
  const std::vector<PathSegment>& segments() const { return segments_; }
  double length_m() const { return length_m_; }

  /// Point `offset_m` into segment `index`, offset clamped to the segment.
  PathPoint at(std::size_t index, double offset_m) const;
  /// Point at length `s_m` from the start, clamped; at a pivot, the pose before it.
  PathPoint at(double s_m) const;

  /// Offset in [0, length] of the point of segment `index` nearest to (x, y): of an arc, only the
  /// part within half a turn of the known offset `about_m`.
  double project(std::size_t index, double x_m, double y_m, double about_m) const;

  /// Smallest distance from (x, y) to the part of the path between lengths s_from and s_to.
  double distance(double x_m, double y_m, double s_from, double s_to) const;

 private:
  std::vector<PathSegment> segments_;
  double length_m_ = 0.0;
};

/// The first point of the path at which the reference point may not be: exact for the edges of
/// polygons, which the path may not touch; for a rectangle the first of 181 points a segment. Takes
/// at most some 10 ns for each pair of a segment and an edge, however long they are.
std::optional<PathPoint> first_point_outside(const Path& path, const Fence& fence);

}  // namespace tp100::course
