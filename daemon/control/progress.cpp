#include "control/progress.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arithmetic.h"

namespace tp100::control {
namespace {

// More than a robot drives in a step, less than the distance between two parts of a path.
constexpr double kWindowM = 0.05;

// A robot that stopped within this distance stands at the end of its segment.
constexpr double kAtEndM = 1e-3;

bool is_pivot(const course::PathSegment& segment) {
  return segment.kind == course::PathSegment::Kind::kPivot;
}

}  // namespace

void Progress::restart() {
  index_ = 0;
  offset_m_ = 0.0;
}

void Progress::resume(double s_m, double yaw_rad) {
  restart();
  const auto passed = [&](const course::PathSegment& segment) {
    if (s_m > segment.end.s_m + kAtEndM) return true;
    if (s_m < segment.end.s_m - kAtEndM) return false;
    return !is_pivot(segment) || std::abs(wrap_angle(yaw_rad - segment.end.yaw_rad)) <
                                     std::abs(wrap_angle(yaw_rad - segment.begin.yaw_rad));
  };
  while (passed(segment()) && next()) {
  }
  if (!is_pivot(segment()))
    offset_m_ = std::clamp(s_m - segment().begin.s_m, 0.0, segment().length_m);
}

/// True if the robot does not stop between segment `index` and the one after it.
bool Progress::joined(std::size_t index) const {
  const auto& segments = path_.segments();
  return index + 1 < segments.size() && !is_pivot(segments[index]) &&
         !is_pivot(segments[index + 1]);
}

bool Progress::next() {
  if (index_ + 1 == path_.segments().size()) return false;
  ++index_;
  offset_m_ = 0.0;
  return true;
}

void Progress::advance(double x_m, double y_m) {
  double max_m = offset_m_ + kWindowM;
  offset_m_ = std::clamp(path_.project(index_, x_m, y_m, offset_m_), offset_m_, max_m);
  while (offset_m_ >= segment().length_m && joined(index_)) {
    max_m -= segment().length_m;
    ++index_;
    offset_m_ = std::clamp(path_.project(index_, x_m, y_m, 0.0), 0.0, std::max(max_m, 0.0));
  }
}

void Progress::reproject(double x_m, double y_m, double window_m) {
  const double here_m = here().s_m;
  std::size_t first = index_, last = index_;
  while (first > 0 && joined(first - 1)) --first;
  while (joined(last)) ++last;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = first; i <= last; ++i) {
    const course::PathSegment& segment = path_.segments()[i];
    const double from_m = std::max(here_m - window_m - segment.begin.s_m, 0.0);
    const double to_m = std::min(here_m + window_m - segment.begin.s_m, segment.length_m);
    if (from_m > to_m) continue;
    const double about_m = here_m - segment.begin.s_m;
    const double offset_m = std::clamp(path_.project(i, x_m, y_m, about_m), from_m, to_m);
    const course::PathPoint point = path_.at(i, offset_m);
    const double distance_m = magnitude(x_m - point.x_m, y_m - point.y_m);
    if (distance_m >= nearest_m) continue;
    nearest_m = distance_m;
    index_ = i;
    offset_m_ = offset_m;
  }
}

course::PathPoint Progress::ahead(double distance_m) const {
  std::size_t index = index_;
  double offset_m = offset_m_ + distance_m;
  while (offset_m > path_.segments()[index].length_m && joined(index)) {
    offset_m -= path_.segments()[index].length_m;
    ++index;
  }
  course::PathPoint point = path_.at(index, offset_m);
  const double beyond_m = std::max(offset_m - path_.segments()[index].length_m, 0.0);
  point.s_m += beyond_m;
  point.x_m += beyond_m * std::cos(point.yaw_rad);
  point.y_m += beyond_m * std::sin(point.yaw_rad);
  return point;
}

std::size_t Progress::next_turn() const {
  std::size_t index = index_;
  while (index < path_.segments().size() && !is_pivot(path_.segments()[index])) ++index;
  return index;
}

double Progress::left_m() const {
  double left = segment().length_m - offset_m_;
  for (std::size_t i = index_; joined(i); ++i) left += path_.segments()[i + 1].length_m;
  return left;
}

}  // namespace tp100::control
