#include "course/path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arithmetic.h"

namespace tp100::course {
namespace {

PathPoint along(const PathPoint& begin, double offset_m) {
  PathPoint point = begin;
  point.s_m += offset_m;
  const double k = begin.curvature_1pm;
  if (k == 0.0) {
    point.x_m += offset_m * std::cos(begin.yaw_rad);
    point.y_m += offset_m * std::sin(begin.yaw_rad);
  } else {
    point.yaw_rad += k * offset_m;
    point.x_m += (std::sin(point.yaw_rad) - std::sin(begin.yaw_rad)) / k;
    point.y_m -= (std::cos(point.yaw_rad) - std::cos(begin.yaw_rad)) / k;
  }
  return point;
}

/// Offset in [0, length] of the point nearest to (x, y) on the line or arc that starts at `begin`;
/// on an arc only within half a turn of `about_m`.
double nearest_offset(const PathPoint& begin, double length_m, double x_m, double y_m,
                      double about_m) {
  const double dx = x_m - begin.x_m, dy = y_m - begin.y_m;
  const double c = std::cos(begin.yaw_rad), s = std::sin(begin.yaw_rad);
  const double k = begin.curvature_1pm;
  if (k == 0.0) return std::clamp(dx * c + dy * s, 0.0, length_m);
  // In the frame of `begin`, mirrored to a left turn, the centre lies at (0, radius).
  const double radius = 1.0 / std::abs(k);
  const double ahead = dx * c + dy * s;
  const double inward = (k > 0.0 ? 1.0 : -1.0) * (dy * c - dx * s);
  double angle = std::atan2(ahead, radius - inward);
  angle += 2.0 * kPi * std::round((about_m / radius - angle) / (2.0 * kPi));
  return std::clamp(angle * radius, 0.0, length_m);
}

struct Builder {
  PathPoint here;

  PathSegment operator()(const Line& line) const {
    return moved(PathSegment::Kind::kLine, line.length_m, 0.0);
  }

  PathSegment operator()(const Arc& arc) const {
    const double sign = arc.angle_rad < 0.0 ? -1.0 : 1.0;
    PathSegment segment =
        moved(PathSegment::Kind::kArc, arc.radius_m * std::abs(arc.angle_rad), sign / arc.radius_m);
    segment.end.yaw_rad = here.yaw_rad + arc.angle_rad;
    return segment;
  }

  PathSegment operator()(const Pivot& pivot) const {
    PathSegment segment = moved(PathSegment::Kind::kPivot, 0.0, 0.0);
    segment.end.yaw_rad += pivot.angle_rad;
    return segment;
  }

 private:
  PathSegment moved(PathSegment::Kind kind, double length_m, double curvature_1pm) const {
    PathSegment segment;
    segment.kind = kind;
    segment.begin = here;
    segment.begin.curvature_1pm = curvature_1pm;
    segment.end = along(segment.begin, length_m);
    segment.length_m = length_m;
    return segment;
  }
};

}  // namespace

Path::Path(const Course& course) {
  Builder builder;
  builder.here.x_m = course.start.x_m;
  builder.here.y_m = course.start.y_m;
  builder.here.yaw_rad = course.start.yaw_rad;
  segments_.reserve(course.path.size());
  for (const Segment& segment : course.path) {
    segments_.push_back(std::visit(builder, segment));
    builder.here = segments_.back().end;
  }
  length_m_ = builder.here.s_m;
}

PathPoint Path::at(std::size_t index, double offset_m) const {
  const PathSegment& segment = segments_[std::min(index, segments_.size() - 1)];
  return along(segment.begin, std::clamp(offset_m, 0.0, segment.length_m));
}

PathPoint Path::at(double s_m) const {
  std::size_t index = 0;
  while (index + 1 < segments_.size() && segments_[index].end.s_m < s_m) ++index;
  // At the end, a final pivot would hide the curvature and pose before it.
  while (index > 0 && segments_[index].kind == PathSegment::Kind::kPivot) --index;
  return at(index, s_m - segments_[index].begin.s_m);
}

double Path::project(std::size_t index, double x_m, double y_m) const {
  const PathSegment& segment = segments_[std::min(index, segments_.size() - 1)];
  return project(index, x_m, y_m, segment.length_m / 2.0);
}

double Path::project(std::size_t index, double x_m, double y_m, double about_m) const {
  const PathSegment& segment = segments_[std::min(index, segments_.size() - 1)];
  return nearest_offset(segment.begin, segment.length_m, x_m, y_m,
                        std::clamp(about_m, 0.0, segment.length_m));
}

double Path::distance(double x_m, double y_m, double s_from, double s_to) const {
  s_from = std::clamp(s_from, 0.0, length_m_);
  s_to = std::clamp(s_to, s_from, length_m_);
  double best = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : segments_) {
    if (segment.end.s_m < s_from || segment.begin.s_m > s_to) continue;
    const double from = std::max(0.0, s_from - segment.begin.s_m);
    const double to = std::clamp(s_to - segment.begin.s_m, from, std::max(from, segment.length_m));
    const PathPoint begin = along(segment.begin, from);
    const double length = to - from;
    const PathPoint near = along(begin, nearest_offset(begin, length, x_m, y_m, length / 2.0));
    best = std::min(best, magnitude(x_m - near.x_m, y_m - near.y_m));
  }
  return best;
}

std::optional<PathPoint> first_point_outside(const Path& path, const Fence& fence) {
  constexpr double kStepM = 0.005;
  constexpr int kMinSteps = 180, kMaxSteps = 20000;
  // A line between two points of a rectangle stays inside; an arc that leaves it does so for longer
  // than a coarse step.
  const bool rectangle = fence.corners.empty() && fence.keep_out.empty();
  for (std::size_t i = 0; i < path.segments().size(); ++i) {
    const double length_m = path.segments()[i].length_m;
    const int fine = rectangle ? 0 : static_cast<int>(length_m / kStepM);
    const int steps = std::clamp(fine, kMinSteps, kMaxSteps);
    for (int step = 0; step <= steps; ++step) {
      const PathPoint point = path.at(i, length_m * step / steps);
      if (!contains(fence, point.x_m, point.y_m)) return point;
    }
  }
  return std::nullopt;
}

}  // namespace tp100::course
