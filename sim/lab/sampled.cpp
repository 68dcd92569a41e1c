#include "sim/lab/sampled.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/path.h"

namespace tp100::sim {
namespace {

// Fence margin around the path: half the robot's length, the deviation that aborts a run, and some
// room.
constexpr double kMarginM = 0.3;
constexpr double kFenceStepM = 0.02;

class CourseDraw {
 public:
  explicit CourseDraw(std::uint64_t seed) {
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
  course::Disturbance disturbance(double at_m) {
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
    fence.min_x_m = std::min(fence.min_x_m, point.x_m - kMarginM);
    fence.max_x_m = std::max(fence.max_x_m, point.x_m + kMarginM);
    fence.min_y_m = std::min(fence.min_y_m, point.y_m - kMarginM);
    fence.max_y_m = std::max(fence.max_y_m, point.y_m + kMarginM);
  }
  course.fence = fence;
}

void add_obstacles(course::Course& course, CourseDraw& draw) {
  // On the line after the arc: first a block, then a ramp, clear of each other and of the ends.
  const course::Path path(course);
  const course::PathSegment& line = path.segments().back();
  const auto place = [&](double offset_m) {
    const course::PathPoint point = path.at(path.segments().size() - 1, offset_m);
    return course::Place{point.x_m, point.y_m, point.yaw_rad};
  };
  const course::Block block{.place = place(draw.between(0.28, 0.34)),
                            .height_m = draw.between(0.015, 0.037),
                            .depth_m = draw.between(0.10, 0.16),
                            .width_m = 0.4};
  const double slope_rad = draw.between(12.0, 28.0) * kRadPerDeg;
  course::Ramp ramp{.place = {},
                    .height_m = draw.between(0.04, 0.08),
                    .up_rad = slope_rad,
                    .top_m = draw.between(0.2, 0.3),
                    .down_rad = slope_rad,
                    .width_m = 0.4};
  ramp.place = place(line.length_m - 0.25 - ramp.length_m() / 2.0);
  course.terrain.obstacles = {ramp, block};
}

course::Segment random_segment(CourseDraw& draw) {
  constexpr double kLongestArcM = 2.5;
  const double kind = draw.between(0.0, 1.0);
  if (kind < 0.4) return draw.line(0.05, 1.5);
  if (kind < 0.6) return course::Pivot{draw.sign() * draw.between(5.0, 180.0) * kRadPerDeg};
  const double radius_m = 0.05 * std::pow(30.0, draw.between(0.0, 1.0));
  const double most_rad = std::min(2.0 * kPi, kLongestArcM / radius_m);
  return course::Arc{radius_m, draw.sign() * draw.between(0.1, 1.0) * most_rad};
}

void add_surfaces(course::Course& course, CourseDraw& draw) {
  const course::Path path(course);
  const double count = std::ceil(draw.between(-1.0, 3.0));
  for (int i = 0; i < count; ++i) {
    const course::PathPoint at = path.at(draw.between(0.0, path.length_m()));
    course.terrain.surfaces.push_back({.name = "patch",
                                       .place = {at.x_m, at.y_m, draw.between(-kPi, kPi)},
                                       .length_m = draw.between(0.05, 1.0),
                                       .width_m = draw.between(0.05, 1.0),
                                       .friction_factor = draw.between(0.6, 1.3),
                                       .slip_offset = draw.between(-0.03, 0.08)});
  }
}

void add_disturbances(course::Course& course, CourseDraw& draw) {
  const double length_m = course::Path(course).length_m();
  double at_m = draw.between(0.0, 2.0 * length_m);
  while (at_m < length_m) {
    course.disturbances.push_back(draw.disturbance(at_m));
    at_m += draw.between(1.0, 3.0);
  }
}

/// Whether another segment of the path than `on` comes near `place`.
bool passed_again(const course::Path& path, std::size_t on, const course::PathPoint& place) {
  constexpr double kNearM = 0.5;
  for (std::size_t i = 0; i < path.segments().size(); ++i) {
    if (i == on) continue;
    const double length_m = path.segments()[i].length_m;
    double s_m = 0.0;
    while (s_m <= length_m) {
      const course::PathPoint at = path.at(i, s_m);
      if (magnitude(at.x_m - place.x_m, at.y_m - place.y_m) < kNearM) return true;
      s_m += kFenceStepM;
    }
  }
  return false;
}

/// A block or a ramp in the middle of a line, clear of its ends and of the rest of the path.
void add_one_obstacle(course::Course& course, CourseDraw& draw) {
  const course::Path path(course);
  for (std::size_t i = 0; i < path.segments().size(); ++i) {
    const course::PathSegment& segment = path.segments()[i];
    if (!std::holds_alternative<course::Line>(course.path[i]) || segment.length_m < 1.0) continue;
    if (draw.sign() < 0.0) continue;
    const course::PathPoint at = path.at(i, segment.length_m / 2.0);
    if (passed_again(path, i, at)) continue;
    const course::Place place{at.x_m, at.y_m, at.yaw_rad};
    if (draw.sign() < 0.0) {
      course.terrain.obstacles = {
          course::Block{place, draw.between(0.005, 0.037), draw.between(0.05, 0.2), 0.4}};
    } else {
      const double up_rad = draw.between(5.0, 30.0) * kRadPerDeg;
      course.terrain.obstacles = {course::Ramp{place, draw.between(0.01, 0.04), up_rad,
                                               draw.between(0.0, 0.2), up_rad, 0.4}};
    }
    return;
  }
}

// The largest value that a robot file allows: the motors never reach it.
constexpr double kMaxCurrentLimitN = 100.0;

class RobotDraw {
 public:
  explicit RobotDraw(std::uint64_t number) {
    std::seed_seq sequence{static_cast<std::uint32_t>(number),
                           static_cast<std::uint32_t>(number >> 32), 0xD0B07u};
    random_.seed(sequence);
  }
  double share() { return static_cast<double>(random_()) / 4294967295.0; }
  double operator()(Sampled what) {
    const SampledRange& range = kSampledRanges.at(static_cast<std::size_t>(what));
    return range.low + (range.high - range.low) * share();
  }

 private:
  std::mt19937 random_;
};

}  // namespace

course::Course held_out_course(std::string_view kind, std::uint64_t seed) {
  CourseDraw draw(seed);
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
    course.disturbances.push_back(draw.disturbance(draw.between(0.4, 0.6)));
    const course::Path path(course);
    course.disturbances.push_back(draw.disturbance(path.length_m() - draw.between(0.5, 0.7)));
  } else if (kind == "3") {
    course.path = {draw.line(0.4, 1.4), draw.arc(60, 200), draw.line(2.0, 2.3)};
    add_obstacles(course, draw);
  } else if (kind == "spiral") {
    const double side = draw.sign(), first_m = draw.between(0.12, 0.18);
    for (int i = 0; i < 10; ++i)
      course.path.push_back(course::Arc{first_m + 0.1 * i, side * 180.0 * kRadPerDeg});
  } else if (kind == "squares") {
    const course::Line line = draw.line(0.8, 1.2);
    const course::Pivot corner{draw.sign() * 90.0 * kRadPerDeg};
    for (int i = 0; i < 8; ++i) course.path.insert(course.path.end(), {line, corner});
  } else if (kind == "wide") {
    const double side = draw.sign();
    course.path = {draw.line(0.2, 0.4),
                   course::Arc{draw.between(0.6, 0.8), side * draw.between(90, 180) * kRadPerDeg},
                   course::Arc{draw.between(1.3, 1.7), -side * draw.between(60, 120) * kRadPerDeg},
                   draw.line(0.2, 0.4)};
  } else {
    throw UserError(
        "no course of kind " + std::string(kind) +
        " to draw; there are 1-straight, 1-curve, 1-sharp, 2, 3, spiral, squares and wide");
  }
  fence_in(course);
  return course;
}

course::Course random_course(std::uint64_t seed) {
  CourseDraw draw(seed);
  course::Course course;
  course.name = "random-" + std::to_string(seed);
  course.speed_mps = draw.between(0.03, 0.15);
  course.start = {.x_m = draw.between(-5.0, 5.0),
                  .y_m = draw.between(-5.0, 5.0),
                  .yaw_rad = draw.between(-kPi, kPi)};
  const double segments = std::ceil(draw.between(0.0, 8.0));
  for (int i = 0; i < segments; ++i) course.path.push_back(random_segment(draw));
  add_surfaces(course, draw);
  add_disturbances(course, draw);
  add_one_obstacle(course, draw);
  fence_in(course);
  return course;
}

course::Robot sampled_robot(const course::Robot& end_loaded, std::uint64_t number) {
  RobotDraw draw(number);
  course::Robot robot = end_loaded;
  robot.name = "sampled-" + std::to_string(number);
  robot.description = "sampled by the number " + std::to_string(number);
  robot.model = {};
  robot.baselines = {};
  robot.origins.clear();

  const double size = draw(Sampled::kSize);
  course::ShapeValues& shape = robot.shape;
  for (double* length : {&shape.length_m, &shape.height_m, &shape.axle_spacing_m,
                         &shape.wheel_radius_m, &shape.gauge_m})
    *length *= size;
  course::EmulatedBody& body = robot.emulated.body;
  for (double* length : {&body.length_m, &body.width_m, &body.height_m, &body.axle_spacing_m,
                         &body.wheel_radius_m, &body.gauge_m, &body.shoe_width_m})
    *length *= size;
  const double heavier = draw(Sampled::kMass) * size * size * size;
  body.mass_kg *= heavier;
  body.mid_lift_m = draw(Sampled::kMidLift) * 1e-3;
  body.friction = draw(Sampled::kFriction);
  const double creep = draw(Sampled::kCreep), uneven = draw(Sampled::kCreepUneven);
  body.creep_left = creep * (1.0 + uneven / 2.0);
  body.creep_right = creep * (1.0 - uneven / 2.0);
  const double deficit = draw(Sampled::kDeficit), apart = draw(Sampled::kDeficitUneven);
  body.track_deficit_left = deficit + apart / 2.0;
  body.track_deficit_right = deficit - apart / 2.0;
  body.com_forward_m = shape.com_forward_m = draw(Sampled::kForward) * body.axle_spacing_m;
  body.com_left_m = draw(Sampled::kLeft) * body.gauge_m;
  body.com_height_m = shape.com_height_m = draw(Sampled::kHeight) * 1e-3 * size;

  course::EmulatedMotor& motor = robot.emulated.motor;
  motor.stall_n_per_v *= heavier;
  motor.friction_n *= heavier;
  motor.current_limit_n = std::min(motor.current_limit_n * heavier, kMaxCurrentLimitN);
  robot.emulated.battery.amps_per_n /= heavier;
  motor.left_gain = draw(Sampled::kMotor);
  motor.right_gain = draw(Sampled::kMotor);
  const SampledRange& counts = kSampledRanges.at(static_cast<std::size_t>(Sampled::kCounts));
  robot.emulated.encoder.counts_per_metre = robot.drive.counts_per_metre =
      std::round(counts.low * std::pow(counts.high / counts.low, draw.share()));
  robot.emulated.imu.gyro_scale_error = draw(Sampled::kGyroScale);
  const double wider = draw(Sampled::kGauge);
  shape.gauge_m *= wider;
  body.width_m *= wider;
  body.gauge_m *= wider * draw(Sampled::kContactGauge);
  return robot;
}

}  // namespace tp100::sim
