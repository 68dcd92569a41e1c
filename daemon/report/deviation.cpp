#include "report/deviation.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"

namespace tp100::report {
namespace {

// Part of the path around the controller's progress that a pose is compared with.
constexpr double kWindowM = 0.3;
// At a corner, neighbouring pieces are equally near but for the few millimetres the robot stops
// beside it.
constexpr double kCornerM = 0.01;

double yaw_error(const course::Piece& piece, const course::PathPoint& nearest, double yaw_rad) {
  if (piece.kind != course::Piece::Kind::kPivot)
    return std::abs(wrap_angle(yaw_rad - nearest.yaw_rad));
  const double half = std::abs(piece.end.yaw_rad - piece.begin.yaw_rad) / 2.0;
  const double middle = (piece.end.yaw_rad + piece.begin.yaw_rad) / 2.0;
  return std::max(0.0, std::abs(wrap_angle(yaw_rad - middle)) - half);
}

}  // namespace

Deviation deviation(const course::Path& path, const TrackPoint& point) {
  const double from = point.progress_m - kWindowM, to = point.progress_m + kWindowM;
  Deviation result;
  result.cross_track_m = path.distance(point.world.x_m, point.world.y_m, from, to);
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.pieces().size(); ++i) {
    const course::Piece& piece = path.pieces()[i];
    if (piece.end.s_m < from || piece.begin.s_m > to) continue;
    const course::PathPoint near = path.at(i, path.project(i, point.world.x_m, point.world.y_m));
    const double dx = point.world.x_m - near.x_m, dy = point.world.y_m - near.y_m;
    const double distance = std::hypot(dx, dy);
    if (distance > result.cross_track_m + kCornerM) continue;
    result.yaw_rad = std::min(result.yaw_rad, yaw_error(piece, near, point.world.yaw_rad));
    if (piece.kind == course::Piece::Kind::kPivot || distance >= nearest_m) continue;
    nearest_m = distance;
    result.left = dy * std::cos(near.yaw_rad) - dx * std::sin(near.yaw_rad) > 0.0;
  }
  if (!std::isfinite(result.yaw_rad)) result.yaw_rad = 0.0;
  return result;
}

}  // namespace tp100::report
