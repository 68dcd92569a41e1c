#include "bridge/onward.h"

#include <cmath>
#include <cstddef>
#include <limits>

#include "core/arithmetic.h"

namespace tp100::bridge {
namespace {

// What is left of the path where a run may go on: a run ends within this distance of its end.
constexpr double kLeastLeftM = 0.02;
// Of two parts of a path beside the robot, it stands on the one whose direction it has: a
// difference of one radian counts as much as this distance.
constexpr double kTurnedMPerRad = 0.05;

}  // namespace

std::optional<double> onward_m(const course::Path& path, const Pose& pose, double ended_m,
                               double reach_m) {
  const double last_m = path.length_m() - kLeastLeftM;
  const auto off_m = [&](const course::PathPoint& point) {
    return magnitude(pose.x_m - point.x_m, pose.y_m - point.y_m);
  };
  if (ended_m > 0.0 && ended_m < last_m && off_m(path.at(ended_m)) <= reach_m) return ended_m;
  std::optional<double> best_m;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.segments().size(); ++i) {
    const course::PathSegment& segment = path.segments()[i];
    // Beyond reach as a whole: in most steps, what is beside the robot is a small part of the path.
    if (off_m(segment.begin) > segment.length_m + reach_m) continue;
    const course::PathPoint point =
        path.at(i, path.project(i, pose.x_m, pose.y_m, segment.length_m / 2.0));
    const double turned_rad = std::abs(wrap_angle(pose.yaw_rad - point.yaw_rad));
    const double cost = off_m(point) + kTurnedMPerRad * turned_rad;
    if (off_m(point) > reach_m || cost >= least) continue;
    least = cost;
    best_m = point.s_m;
  }
  if (best_m && *best_m > last_m) best_m.reset();
  return best_m;
}

}  // namespace tp100::bridge
