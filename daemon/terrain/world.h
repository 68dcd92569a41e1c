#pragma once
// The virtual world: attitude and height of the robot on the course's obstacles. Statics only:
// getting onto a block and falling off it is left to the step climb model.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/arithmetic.h"
#include "core/estimates.h"
#include "core/pose.h"
#include "course/robot.h"
#include "course/terrain.h"

namespace tp100::terrain {

/// Shape of an obstacle of any kind, in its own frame: heights at places along its heading.
struct Outline {
  struct Point {
    double along_m, height_m;
  };
  ObstacleClass obstacle{};
  course::Place place{};
  /// Ascending; the first and the last lie equally far from the place.
  std::array<Point, 4> points{};
  double half_width_m = 0.0;

  double length_m() const { return points.back().along_m - points.front().along_m; }
  /// Of a circle around the footprint.
  double radius_m() const { return magnitude(points.back().along_m, half_width_m); }
  double height_m() const { return std::max(points[1].height_m, points[2].height_m); }
};
/// In the course's order.
std::vector<Outline> outlines_of(const course::Terrain& terrain);

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
  void lift(const Places& places, ObstacleClass what, std::span<double> wheel,
            std::span<ObstacleClass> ground) const;

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

/// Attitude and height of the robot.
struct ContactPose {
  double height_m = 0.0;   ///< of the reference point above the floor
  double slope_rad = 0.0;  ///< climb angle along the heading, nose-up positive
  double pitch_rad = 0.0;  ///< the same by REP-103: nose-up negative
  double roll_rad = 0.0;   ///< left side up positive
  ObstacleClass obstacle = ObstacleClass::kNone;
  const course::Surface* surface = nullptr;  ///< under the reference point; null: ordinary floor
};

/// A block on the line of the heading.
struct BlockAhead {
  const Outline* block = nullptr;
  double distance_m = 0.0;  ///< from the reference point to the near edge, negative once past it
};

/// Built once; queries allocate nothing, take bounded time and are safe in the real-time thread.
class World {
 public:
  World(const course::Terrain& terrain, const course::ShapeValues& shape);

  /// Contact of a robot at x, y and yaw of `pose`. Each track is a straight line between two wheels
  /// of the track's radius that rests on the ground below it: on the two contacts between which the
  /// centre of mass lies, which may be the wheels or an edge between them. Pitch is the mean of
  /// both tracks, roll their difference in height. Near an edge there are two solutions: the one
  /// nearer to `pose.pitch_rad`, the pitch until now, is taken. Tipping over takes no time here. A
  /// pose that is not finite is on the level floor.
  ContactPose at(const Pose& pose) const;

  /// Height of floor or obstacle at a place.
  double height_m(double x_m, double y_m) const;

  /// The nearest block ahead of the rear end of a robot at `pose`, at most `within_m` ahead of its
  /// reference point.
  std::optional<BlockAhead> next_block(const Pose& pose, double within_m) const;

  /// All obstacles; next_block() points into them.
  const std::vector<Outline>& pieces() const { return pieces_; }

  bool flat() const { return pieces_.empty(); }

 private:
  struct Support {
    double slope_rad;
    double height_m;  // of the reference point
    ObstacleClass obstacle;
  };
  bool near(const Outline& outline, double x_m, double y_m) const;
  Support support(double x_m, double y_m, double cos_yaw, double sin_yaw, double slope_rad) const;

  course::Terrain terrain_;
  course::ShapeValues shape_;
  std::vector<Outline> pieces_;
};

}  // namespace tp100::terrain
