#pragma once
// Of the lines between two wheels of a belt, the one that it stands on.

#include <array>
#include <cstddef>

namespace tp100::terrain {

/// Through the wheels at two places.
struct CarryingLine {
  /// In which the belt's underside is looked at.
  static constexpr std::size_t kPlaces = 41;

  std::size_t before = 0, after = 0;
  double rise = 0.0;    ///< from place to place
  double height = 0.0;  ///< where the centre of mass is
};

/// How high the centre of a wheel is at evenly spread places, rear end first.
using WheelHeights = std::array<double, CarryingLine::kPlaces>;

/// The line through one place up to `com` and one beyond that is highest at `com`, which counts
/// in places and may lie beyond the ends: it touches and cuts nothing. Bounded time, no allocation.
CarryingLine carrying_line(const WheelHeights& wheel, double com);

}  // namespace tp100::terrain
