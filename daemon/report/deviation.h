#pragma once
// One true pose against the path.

#include <limits>

#include "course/path.h"
#include "report/run_result.h"

namespace tp100::report {

struct Deviation {
  double cross_track_m = std::numeric_limits<double>::infinity();  ///< distance; not negative
  bool left = false;                                         ///< of the path, looking along it
  double yaw_rad = std::numeric_limits<double>::infinity();  ///< against the tangent; not negative
};

/// The true pose of `point` against the part of the path around the controller's progress. While
/// turning on the spot, yaw is compared with the turn.
Deviation deviation(const course::Path& path, const TrackPoint& point);

}  // namespace tp100::report
