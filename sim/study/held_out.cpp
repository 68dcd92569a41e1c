#include "sim/study/held_out.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "core/angle.h"
#include "core/error.h"
#include "course/path.h"

namespace tp100::sim {
namespace {

// Room around the path: the robot's half length, an aborting deviation and some.
constexpr double kRoomM = 0.3;
constexpr double kFenceStepM = 0.02;

class Draw {
 public:
  explicit Draw(std::uint64_t seed) {
    std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                           0x4E1D0u};
    random_.seed(sequence);
  }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967295.0;
  }
  double sign() { return random_() % 2 == 0 ? 1.0 : -1.0; }
  course::Line line(double low_m, double high_m) { return {between(low_m, high_m)}; }
  course::Arc arc(double low_deg, double high_deg) {
    return {between(0.28, 0.5), sign() * between(low_deg, high_deg) * kRadPerDeg};
  }
  course::Pivot pivot() { return {sign() * between(45.0, 135.0) * kRadPerDeg}; }
  course::Shove shove(double at_m) {
    return {at_m, sign() * between(0.02, 0.04), sign() * between(5.0, 15.0) * kRadPerDeg, 0.3};
  }

 private:
  std::mt19937 random_;
};

void fence_in(course::Course& course) {
  const course::Path path(course);
  course::Fence fence{1e9, -1e9, 1e9, -1e9};
  const int steps = static_cast<int>(path.length_m() / kFenceStepM) + 1;
  for (int i = 0; i <= steps; ++i) {
    const course::PathPoint point = path.at(i * kFenceStepM);
    fence.min_x_m = std::min(fence.min_x_m, point.x_m - kRoomM);
    fence.max_x_m = std::max(fence.max_x_m, point.x_m + kRoomM);
    fence.min_y_m = std::min(fence.min_y_m, point.y_m - kRoomM);
    fence.max_y_m = std::max(fence.max_y_m, point.y_m + kRoomM);
  }
  course.fence = fence;
}

void add_obstacles(course::Course& course, Draw& draw) {
  // On the line behind the arc, block first, then ramp, clear of each other and of the ends.
  const course::Path path(course);
  const course::Piece& line = path.pieces().back();
  const auto place = [&](double offset_m) {
    const course::PathPoint point = path.at(path.pieces().size() - 1, offset_m);
    return course::Place{point.x_m, point.y_m, point.yaw_rad};
  };
  course.terrain.blocks.push_back({.place = place(draw.between(0.28, 0.34)),
                                   .height_m = draw.between(0.015, 0.037),
                                   .depth_m = draw.between(0.10, 0.16),
                                   .width_m = 0.4});
  const double slope_rad = draw.between(12.0, 28.0) * kRadPerDeg;
  course::Ramp ramp{.place = {},
                    .height_m = draw.between(0.04, 0.08),
                    .up_rad = slope_rad,
                    .top_m = draw.between(0.2, 0.3),
                    .down_rad = slope_rad,
                    .width_m = 0.4};
  ramp.place = place(line.length_m - 0.25 - ramp.length_m() / 2.0);
  course.terrain.ramps.push_back(ramp);
}

}  // namespace

course::Course held_out_course(std::string_view kind, std::uint64_t seed) {
  Draw draw(seed);
  course::Course course;
  course.name = std::string(kind) + "-held-out-" + std::to_string(seed);
  if (kind == "1-straight") {
    course.path = {draw.line(1.2, 1.8)};
  } else if (kind == "1-curve") {
    course.path = {draw.line(0.3, 0.6), draw.arc(60, 200), draw.line(0.3, 0.6)};
  } else if (kind == "1-sharp") {
    course.path = {draw.line(0.3, 0.6), draw.pivot(), draw.line(0.3, 0.6), draw.pivot(),
                   draw.line(0.3, 0.6), draw.pivot(), draw.line(0.3, 0.4)};
  } else if (kind == "2") {
    course.path = {draw.line(1.0, 1.4), draw.arc(60, 120), draw.line(0.2, 0.3), draw.pivot(),
                   draw.line(1.1, 1.4)};
    course.shoves.push_back(draw.shove(draw.between(0.4, 0.6)));
    const course::Path path(course);
    course.shoves.push_back(draw.shove(path.length_m() - draw.between(0.5, 0.7)));
  } else if (kind == "3") {
    course.path = {draw.line(0.4, 1.4), draw.arc(60, 200), draw.line(2.0, 2.3)};
    add_obstacles(course, draw);
  } else {
    throw SetupError("no course of kind " + std::string(kind) +
                     " to draw; there are 1-straight, 1-curve, 1-sharp, 2 and 3");
  }
  fence_in(course);
  return course;
}

}  // namespace tp100::sim
