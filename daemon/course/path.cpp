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
  angle += whole_turns(angle, about_m / radius);
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

constexpr double kNever = std::numeric_limits<double>::infinity();

/// A segment as edges are compared with it: in the frame of its begin, u ahead and v to the left,
/// mirrored to a left turn.
class Crossing {
 public:
  explicit Crossing(const PathSegment& segment)
      : begin_(segment.begin),
        length_m_(segment.length_m),
        cosine_(std::cos(begin_.yaw_rad)),
        sine_(std::sin(begin_.yaw_rad)),
        side_(begin_.curvature_1pm < 0.0 ? -1.0 : 1.0) {
    const PathPoint& end = segment.end;
    min_x_m_ = std::min(begin_.x_m, end.x_m), max_x_m_ = std::max(begin_.x_m, end.x_m);
    min_y_m_ = std::min(begin_.y_m, end.y_m), max_y_m_ = std::max(begin_.y_m, end.y_m);
    if (begin_.curvature_1pm == 0.0) return;
    radius_m_ = 1.0 / std::abs(begin_.curvature_1pm);
    const double x_m = begin_.x_m - side_ * radius_m_ * sine_,
                 y_m = begin_.y_m + side_ * radius_m_ * cosine_;
    min_x_m_ = x_m - radius_m_, max_x_m_ = x_m + radius_m_;
    min_y_m_ = y_m - radius_m_, max_y_m_ = y_m + radius_m_;
  }

  /// Offset of the segment's first point on the edge from `a` to `b`; kNever: there is none.
  double first_m(const Vertex& a, const Vertex& b) const {
    if (std::max(a.x_m, b.x_m) < min_x_m_ || std::min(a.x_m, b.x_m) > max_x_m_ ||
        std::max(a.y_m, b.y_m) < min_y_m_ || std::min(a.y_m, b.y_m) > max_y_m_)
      return kNever;
    const double dx = a.x_m - begin_.x_m, dy = a.y_m - begin_.y_m;
    const double ex = b.x_m - a.x_m, ey = b.y_m - a.y_m;
    const double u = dx * cosine_ + dy * sine_, v = side_ * (dy * cosine_ - dx * sine_);
    const double du = ex * cosine_ + ey * sine_, dv = side_ * (ey * cosine_ - ex * sine_);
    return radius_m_ == 0.0 ? on_line(u, v, du, dv) : on_arc(u, v, du, dv);
  }

 private:
  double on_line(double u, double v, double du, double dv) const {
    if (dv == 0.0) return kNever;  // parallel: the path meets one of the neighbouring edges
    const double part = -v / dv, offset_m = u + part * du;
    const bool meets = part >= 0.0 && part <= 1.0 && offset_m >= 0.0 && offset_m <= length_m_;
    return meets ? offset_m : kNever;
  }
  double on_arc(double u, double v, double du, double dv) const {
    // (u + part du)^2 + (v + part dv - radius)^2 = radius^2
    const double squared = du * du + dv * dv, half = u * du + (v - radius_m_) * dv;
    const double under_root = half * half - squared * (u * u + v * v - 2.0 * v * radius_m_);
    if (squared == 0.0 || under_root < 0.0) return kNever;
    double first = kNever;
    for (const double root : {-std::sqrt(under_root), std::sqrt(under_root)}) {
      const double part = (root - half) / squared;
      if (part < 0.0 || part > 1.0) continue;
      double angle = std::atan2(u + part * du, radius_m_ - v - part * dv);
      if (angle < 0.0) angle += 2.0 * kPi;
      if (angle * radius_m_ <= length_m_) first = std::min(first, angle * radius_m_);
    }
    return first;
  }

  PathPoint begin_;
  double length_m_, cosine_, sine_, side_;
  double radius_m_ = 0.0;                         // 0: a line
  double min_x_m_, max_x_m_, min_y_m_, max_y_m_;  // of an arc: of its whole circle
};

/// Offset of the first of 181 points that lies outside of a rectangular fence.
double first_outside_bounds(const PathSegment& segment, const Fence& fence) {
  constexpr int kSteps = 180;
  for (int step = 0; step <= kSteps; ++step) {
    const double offset_m = segment.length_m * step / kSteps;
    const PathPoint point = along(segment.begin, offset_m);
    if (point.x_m < fence.min_x_m || point.x_m > fence.max_x_m || point.y_m < fence.min_y_m ||
        point.y_m > fence.max_y_m)
      return offset_m;
  }
  return kNever;
}

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
  const PathPoint& start = path.segments().front().begin;
  if (!contains(fence, start.x_m, start.y_m)) return start;
  for (std::size_t i = 0; i < path.segments().size(); ++i) {
    const PathSegment& segment = path.segments()[i];
    double first_m = kNever;
    if (fence.corners.empty()) first_m = first_outside_bounds(segment, fence);
    const Crossing crossing(segment);
    const auto cross = [&](const Polygon& polygon) {
      for (std::size_t k = 0; k < polygon.size(); ++k)
        first_m = std::min(
            first_m, crossing.first_m(polygon[k], polygon[k + 1 < polygon.size() ? k + 1 : 0]));
    };
    cross(fence.corners);
    for (const Polygon& area : fence.keep_out) cross(area);
    if (first_m <= segment.length_m) return path.at(i, first_m);
  }
  return std::nullopt;
}

}  // namespace tp100::course
