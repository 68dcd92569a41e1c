#pragma once
// Cross-section of one ramp or block in the vertical plane of a track.

#include <array>
#include <cstddef>
#include <span>

#include "core/estimates.h"
#include "course/terrain.h"

namespace tp100::terrain {

/// Outline of a piece from above, in its own frame: heights at places along its heading.
struct Outline {
  struct Point {
    double along_m, height_m;
  };
  course::Place place{};
  std::array<Point, 4> points{};
  double half_width_m = 0.0;
  double radius_m = 0.0;  ///< of a circle around the footprint
};
Outline outline_of(const course::Ramp& ramp);
Outline outline_of(const course::Block& block);

/// The cut through an outline: a polyline over the distance along the plane. No allocation.
class Profile {
 public:
  /// Plane through (x, y) in the direction (cos, sin); distances count from (x, y).
  Profile(const Outline& outline, double x_m, double y_m, double cos_yaw, double sin_yaw);

  bool empty() const { return count_ == 0; }
  double begin_m() const { return points_[0].along_m; }
  double end_m() const { return points_[count_ - 1].along_m; }
  /// Height of the piece at a distance; 0 outside it. At a wall, the top.
  double height_m(double at_m) const;
  /// Wheel positions, evenly spaced along the plane.
  struct Places {
    double first_m, step_m;  ///< the step is above 0
    double radius_m;         ///< of the wheels
  };
  /// Raises the centres of wheels that would cut into the piece, an obstacle of class `what`, until
  /// they touch it, and records that in `ground`, which is as long as `wheel`.
  void lift(const Places& places, Obstacle what, std::span<double> wheel,
            std::span<Obstacle> ground) const;

 private:
  using Point = Outline::Point;
  /// A segment between two points that are not above each other.
  struct Edge {
    double begin_m, end_m;      ///< along the plane
    double height_m, slope;     ///< at the beginning, and rise per distance
    double sin_rise, cos_rise;  ///< of the angle of the slope
  };
  void add(double along_m, double height_m) { points_[count_++] = {along_m, height_m}; }
  void join();

  std::array<Point, 6> points_{};
  std::size_t count_ = 0;
  std::array<Edge, 5> edges_{};
  std::size_t edge_count_ = 0;
};

}  // namespace tp100::terrain
