#include "terrain/profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arithmetic.h"

namespace tp100::terrain {
namespace {

constexpr double kParallel = 1e-9;

double interpolate(const Outline::Point& a, const Outline::Point& b, double at_m) {
  const double span = b.along_m - a.along_m;
  if (span <= kParallel) return std::max(a.height_m, b.height_m);
  return a.height_m + (b.height_m - a.height_m) * (at_m - a.along_m) / span;
}

/// Height of a polyline with ascending positions; 0 outside it, the top at a wall.
template <class Points>
double height_of(const Points& points, std::size_t count, double at_m) {
  double height = 0.0;
  for (std::size_t i = 0; i + 1 < count; ++i)
    if (at_m >= points[i].along_m && at_m <= points[i + 1].along_m)
      height = std::max(height, interpolate(points[i], points[i + 1], at_m));
  return height;
}

}  // namespace

Outline outline_of(const course::Ramp& ramp) {
  const double half = ramp.length_m() / 2.0;
  return {ramp.place,
          {{{-half, 0.0},
            {-half + ramp.up_length_m(), ramp.height_m},
            {half - ramp.down_length_m(), ramp.height_m},
            {half, 0.0}}},
          ramp.width_m / 2.0,
          magnitude(half, ramp.width_m / 2.0)};
}

Outline outline_of(const course::Block& block) {
  const double half = block.depth_m / 2.0;
  return {block.place,
          {{{-half, 0.0}, {-half, block.height_m}, {half, block.height_m}, {half, 0.0}}},
          block.width_m / 2.0,
          magnitude(half, block.width_m / 2.0)};
}

Profile::Profile(const Outline& outline, double x_m, double y_m, double cos_yaw, double sin_yaw) {
  const double c = std::cos(outline.place.heading_rad);
  const double s = std::sin(outline.place.heading_rad);
  const double dx = x_m - outline.place.x_m;
  const double dy = y_m - outline.place.y_m;
  const double u = c * dx + s * dy;
  const double v = c * dy - s * dx;
  const double du = c * cos_yaw + s * sin_yaw;
  const double dv = c * sin_yaw - s * cos_yaw;

  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  const auto clip = [&](double at, double step, double low, double high) {
    if (std::abs(step) < kParallel) {
      if (at < low || at > high) to = from;
      return;
    }
    const double a = (low - at) / step;
    const double b = (high - at) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  };
  clip(u, du, outline.points.front().along_m, outline.points.back().along_m);
  clip(v, dv, -outline.half_width_m, outline.half_width_m);
  if (!(to > from)) return;

  const auto height = [&](double at) { return height_of(outline.points, 4, u + at * du); };
  add(from, height(from));
  if (std::abs(du) >= kParallel) {
    for (std::size_t i = 1; i <= 2; ++i) {
      const Outline::Point& point = outline.points[du > 0.0 ? i : 3 - i];
      const double at = (point.along_m - u) / du;
      if (at > from && at < to) add(at, point.height_m);
    }
  }
  add(to, height(to));
  join();
}

// A track queries many positions: values independent of the position are computed once.
void Profile::join() {
  for (std::size_t i = 0; i + 1 < count_; ++i) {
    const Point& a = points_[i];
    const double span = points_[i + 1].along_m - a.along_m;
    const double rise = points_[i + 1].height_m - a.height_m;
    if (span <= kParallel) continue;
    const double length = std::sqrt(span * span + rise * rise);
    edges_[edge_count_++] = {a.along_m,   a.along_m + span, a.height_m,
                             rise / span, rise / length,    span / length};
  }
}

double Profile::height_m(double at_m) const { return height_of(points_, count_, at_m); }

void Profile::lift(const Places& places, Obstacle what, std::span<double> wheel,
                   std::span<Obstacle> ground) const {
  const double radius = places.radius_m;
  const double last = static_cast<double>(wheel.size()) - 1.0;
  // Each corner and each edge is below a few neighbouring positions only.
  const auto each = [&](double from_m, double to_m, const auto& height_at) {
    const double from = std::max(std::ceil((from_m - places.first_m) / places.step_m), 0.0);
    const double to = std::min(std::floor((to_m - places.first_m) / places.step_m), last);
    for (double at = from; at <= to; at += 1.0) {
      const double height = height_at(places.first_m + at * places.step_m);
      const auto i = static_cast<std::size_t>(at);
      if (height <= wheel[i]) continue;
      wheel[i] = height;
      ground[i] = what;
    }
  };
  for (std::size_t i = 0; i < count_; ++i) {
    const Point& point = points_[i];
    each(point.along_m - radius, point.along_m + radius, [&](double at_m) {
      const double away = at_m - point.along_m;
      return point.height_m + std::sqrt(std::max(radius * radius - away * away, 0.0));
    });
  }
  for (std::size_t i = 0; i < edge_count_; ++i) {
    const Edge& edge = edges_[i];
    const double ahead = radius * edge.sin_rise;
    each(edge.begin_m - ahead, edge.end_m - ahead, [&](double at_m) {
      return edge.height_m + edge.slope * (at_m + ahead - edge.begin_m) + radius * edge.cos_rise;
    });
  }
}

}  // namespace tp100::terrain
