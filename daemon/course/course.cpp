#include "course/course.h"

#include <algorithm>

namespace tp100::course {
namespace {

const Vertex& after(const Polygon& polygon, std::size_t index) {
  return polygon[index + 1 < polygon.size() ? index + 1 : 0];
}

/// Twice the area of a, b, c; positive: c lies left of the line from a to b.
double side(const Vertex& a, const Vertex& b, const Vertex& c) {
  return (b.x_m - a.x_m) * (c.y_m - a.y_m) - (b.y_m - a.y_m) * (c.x_m - a.x_m);
}

/// c, which lies on the line through a and b, lies between them.
bool between(const Vertex& a, const Vertex& b, const Vertex& c) {
  return c.x_m >= std::min(a.x_m, b.x_m) && c.x_m <= std::max(a.x_m, b.x_m) &&
         c.y_m >= std::min(a.y_m, b.y_m) && c.y_m <= std::max(a.y_m, b.y_m);
}

bool meet(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  const double c_side = side(a, b, c), d_side = side(a, b, d);
  const double a_side = side(c, d, a), b_side = side(c, d, b);
  if (c_side * d_side < 0.0 && a_side * b_side < 0.0) return true;
  return (c_side == 0.0 && between(a, b, c)) || (d_side == 0.0 && between(a, b, d)) ||
         (a_side == 0.0 && between(c, d, a)) || (b_side == 0.0 && between(c, d, b));
}

void mirror(Place& place) {
  place.y_m = -place.y_m;
  place.heading_rad = -place.heading_rad;
}

}  // namespace

// A ray to the right crosses the edges an odd number of times.
bool contains(const Polygon& polygon, double x_m, double y_m) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex &a = polygon[i], &b = after(polygon, i);
    if ((a.y_m > y_m) == (b.y_m > y_m)) continue;
    const double cross_x_m = a.x_m + (y_m - a.y_m) / (b.y_m - a.y_m) * (b.x_m - a.x_m);
    if (x_m < cross_x_m) inside = !inside;
  }
  return inside;
}

bool contains(const Fence& fence, double x_m, double y_m) {
  if (x_m < fence.min_x_m || x_m > fence.max_x_m || y_m < fence.min_y_m || y_m > fence.max_y_m)
    return false;
  if (!fence.corners.empty() && !contains(fence.corners, x_m, y_m)) return false;
  return std::none_of(fence.keep_out.begin(), fence.keep_out.end(),
                      [&](const Polygon& area) { return contains(area, x_m, y_m); });
}

double outside_m(const Fence& fence, double x_m, double y_m) {
  if (contains(fence, x_m, y_m)) return 0.0;
  const auto to_edge_m = [&](const Polygon& polygon) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vertex edge = nearest_on_edge(polygon, i, x_m, y_m);
      nearest_m = std::min(nearest_m, magnitude(edge.x_m - x_m, edge.y_m - y_m));
    }
    return nearest_m;
  };
  double out_m = 0.0;
  if (fence.corners.empty()) {
    out_m = magnitude(std::max({fence.min_x_m - x_m, 0.0, x_m - fence.max_x_m}),
                      std::max({fence.min_y_m - y_m, 0.0, y_m - fence.max_y_m}));
  } else if (!contains(fence.corners, x_m, y_m)) {
    out_m = to_edge_m(fence.corners);
  }
  for (const Polygon& area : fence.keep_out)
    if (contains(area, x_m, y_m)) out_m = std::max(out_m, to_edge_m(area));
  return out_m;
}

bool crosses_itself(const Polygon& polygon) {
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vertex &a = polygon[i], &b = after(polygon, i);
    // The next edge begins at b; it may not lead back along this one.
    const Vertex& c = after(polygon, i + 1 < count ? i + 1 : 0);
    const bool back = (c.x_m - b.x_m) * (a.x_m - b.x_m) + (c.y_m - b.y_m) * (a.y_m - b.y_m) > 0.0;
    if ((a.x_m == b.x_m && a.y_m == b.y_m) || (side(a, b, c) == 0.0 && back)) return true;
    for (std::size_t k = i + 2; k < count; ++k) {
      if (i == 0 && k + 1 == count) continue;
      if (meet(a, b, polygon[k], after(polygon, k))) return true;
    }
  }
  return false;
}

Polygon corners_of(const Fence& fence) {
  if (!fence.corners.empty()) return fence.corners;
  return {{fence.min_x_m, fence.min_y_m},
          {fence.max_x_m, fence.min_y_m},
          {fence.max_x_m, fence.max_y_m},
          {fence.min_x_m, fence.max_y_m}};
}

Vertex nearest_on_edge(const Polygon& polygon, std::size_t index, double x_m, double y_m) {
  const Vertex &a = polygon[index], &b = after(polygon, index);
  const double x = b.x_m - a.x_m, y = b.y_m - a.y_m;
  const double square = x * x + y * y;
  const double along =
      square > 0.0 ? std::clamp(((x_m - a.x_m) * x + (y_m - a.y_m) * y) / square, 0.0, 1.0) : 0.0;
  return {a.x_m + along * x, a.y_m + along * y};
}

Course mirrored(const Course& course) {
  Course other = course;
  other.name += "-mirrored";
  other.start.y_m = -other.start.y_m;
  other.start.yaw_rad = -other.start.yaw_rad;
  for (Segment& segment : other.path) mirror(segment);
  for (Disturbance& disturbance : other.disturbances) {
    disturbance.sideways_m = -disturbance.sideways_m;
    disturbance.yaw_rad = -disturbance.yaw_rad;
  }
  for (Obstacle& obstacle : other.terrain.obstacles)
    std::visit([](auto& of) { mirror(of.place); }, obstacle);
  for (Surface& surface : other.terrain.surfaces) mirror(surface.place);
  other.fence.min_y_m = -course.fence.max_y_m;
  other.fence.max_y_m = -course.fence.min_y_m;
  for (Vertex& corner : other.fence.corners) corner.y_m = -corner.y_m;
  for (Polygon& area : other.fence.keep_out)
    for (Vertex& corner : area) corner.y_m = -corner.y_m;
  return other;
}

}  // namespace tp100::course
