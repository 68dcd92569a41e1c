#pragma once
// Obstacles and surfaces on the floor, as data. Both the daemon's virtual world and the emulated
// robot's physical one are built from it; they share nothing else.

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "core/estimates.h"
#include "core/fields.h"

namespace tp100::course {

/// Where a piece lies: the centre of its footprint and the direction of its own x axis, world
/// frame.
struct Place {
  double x_m = 0.0, y_m = 0.0;
  double heading_rad = 0.0;
};
TP100_FIELDS(Place, x_m, y_m, heading_rad)

/// Up, flat top, down. A robot driving along its heading meets the up side first.
struct Ramp {
  static constexpr ObstacleClass kClass = ObstacleClass::kRamp;
  Place place{};
  double height_m;
  double up_rad;  ///< slope of the side that is met first; 90 deg would be a block
  double top_m;   ///< length of the flat top, may be 0
  double down_rad;
  double width_m;

  double up_length_m() const;    ///< of the footprint under the up side
  double down_length_m() const;  ///< of the footprint under the down side
  double length_m() const;       ///< of the whole footprint
};

/// A box: a step up and a step down.
struct Block {
  static constexpr ObstacleClass kClass = ObstacleClass::kBlock;
  Place place{};
  double height_m;
  double depth_m;  ///< along its heading
  double width_m;
};

/// Every kind has a class of its own, a place and a width.
using Obstacle = std::variant<Ramp, Block>;

/// A rectangle of another surface; it also covers obstacles on it.
struct Surface {
  std::string name;
  Place place{};
  double length_m;  ///< along its heading
  double width_m;
  double friction_factor = 1.0;  ///< relative to the usual friction coefficient of track and floor
  double slip_offset = 0.0;      ///< added to the slip ratio of both tracks

  bool covers(double x_m, double y_m) const;
};
TP100_FIELDS(Surface, name, place, length_m, width_m, friction_factor, slip_offset)

struct Terrain {
  std::vector<Obstacle> obstacles;  ///< of a file: kind by kind, each in the file's order
  std::vector<Surface> surfaces;    ///< where several overlap, the last one is on top

  bool flat() const { return obstacles.empty(); }
  /// The surface at a place of the floor; null: the ordinary floor.
  const Surface* surface_at(double x_m, double y_m) const;
};

inline double Ramp::up_length_m() const { return height_m / std::tan(up_rad); }
inline double Ramp::down_length_m() const { return height_m / std::tan(down_rad); }
inline double Ramp::length_m() const { return up_length_m() + top_m + down_length_m(); }

inline bool Surface::covers(double x_m, double y_m) const {
  const double dx = x_m - place.x_m;
  const double dy = y_m - place.y_m;
  const double c = std::cos(place.heading_rad);
  const double s = std::sin(place.heading_rad);
  return std::abs(c * dx + s * dy) <= length_m / 2.0 && std::abs(c * dy - s * dx) <= width_m / 2.0;
}

inline const Surface* Terrain::surface_at(double x_m, double y_m) const {
  for (auto surface = surfaces.rbegin(); surface != surfaces.rend(); ++surface)
    if (surface->covers(x_m, y_m)) return &*surface;
  return nullptr;
}

}  // namespace tp100::course
