#pragma once
// The fence of a course: where on the floor the reference point may be.

#include <cstddef>
#include <vector>

namespace tp100::course {

/// A corner of a polygon, in the world frame.
struct Vertex {
  double x_m = 0.0, y_m = 0.0;
};
/// At least three corners in order, either way around; the last one is joined to the first. Its
/// edges do not cross.
using Polygon = std::vector<Vertex>;

/// A boundary, and areas inside it that the reference point may not enter.
struct Fence {
  double min_x_m, max_x_m, min_y_m, max_y_m;  ///< the boundary, or the bounds of its corners
  Polygon corners{};                          ///< of the boundary; empty: it is a rectangle
  std::vector<Polygon> keep_out{};
};

// No allocation but in corners_of(); safe in the real-time thread.

/// Whether a place lies inside a polygon. On its edge either may be the answer.
bool contains(const Polygon& polygon, double x_m, double y_m);

/// Whether the reference point may be there: inside the boundary or on a rectangle's edge, and in
/// no keep-out area.
bool contains(const Fence& fence, double x_m, double y_m);

/// Whether two edges of the polygon cross or touch, but for neighbours at their corner.
bool crosses_itself(const Polygon& polygon);

/// The corners of the boundary, of a rectangle too.
Polygon corners_of(const Fence& fence);

/// The point of the edge behind corner `index` that is nearest to a place.
Vertex nearest_on_edge(const Polygon& polygon, std::size_t index, double x_m, double y_m);

}  // namespace tp100::course
