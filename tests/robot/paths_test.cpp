// Paths that use the whole course format: the emulated body follows them, and the monitor
// supervises the run.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/arithmetic.h"
#include "course/bundled_files.h"
#include "course/path.h"
#include "runs.h"

namespace tp100::sim {
namespace {

// Sanitized builds run the same code about ten times slower.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kSampled = 3;
#else
constexpr int kSampled = 30;
#endif
constexpr double kRoomM = 0.5;
// The allowance for the error of the estimate and for the motion within a step.
constexpr double kSlackM = 0.02;

course::Course course_of(std::vector<course::Segment> segments) {
  course::Course course;
  course.name = "sampled";
  course.path = std::move(segments);
  return course;
}

void fence_in(course::Course& course) {
  const course::Path path(course);
  course.fence = {1e9, -1e9, 1e9, -1e9};
  constexpr double kStepM = 0.005;
  for (double s_m = 0.0; s_m <= path.length_m() + kStepM; s_m += kStepM) {
    const course::PathPoint point = path.at(s_m);
    course.fence.min_x_m = std::min(course.fence.min_x_m, point.x_m - kRoomM);
    course.fence.max_x_m = std::max(course.fence.max_x_m, point.x_m + kRoomM);
    course.fence.min_y_m = std::min(course.fence.min_y_m, point.y_m - kRoomM);
    course.fence.max_y_m = std::max(course.fence.max_y_m, point.y_m + kRoomM);
  }
}

/// A run that the fused pose of the overhead camera steers.
LockstepSettings settings(course::Course course, const std::string& robot) {
  LockstepSettings run = seen_run_of("1-straight", robot);
  fence_in(course);
  run.course = std::move(course);
  return run;
}

/// The total angle by which the body has turned, including whole turns.
double turned_rad(const report::RunResult& run) {
  double sum = 0.0;
  for (std::size_t i = 1; i < run.points.size(); ++i)
    sum += wrap_angle(run.points[i].truth.yaw_rad - run.points[i - 1].truth.yaw_rad);
  return sum;
}

/// Expects a complete run. A robot that leaves out a turn has turned less.
void expect_driven_whole(const LockstepSettings& run, const report::RunResult& result) {
  ASSERT_TRUE(result.completed) << result.cause;
  const course::Path path(run.course);
  const std::vector<course::PathSegment>& segments = path.segments();
  EXPECT_NEAR(turned_rad(result), segments.back().end.yaw_rad - segments.front().begin.yaw_rad,
              30.0 * kRadPerDeg);
}

/// Expects that the body stays within the allowed distance from the path at the current progress,
/// however wrong the progress is.
void expect_watched(const LockstepSettings& run, const report::RunResult& result) {
  const course::Path path(run.course);
  const double most_m = run.configuration.parameters.control.max_cross_track_m + kSlackM;
  for (const report::TrajectoryPoint& point : result.points) {
    const course::PathPoint meant = path.at(point.progress_m);
    ASSERT_LE(std::hypot(point.truth.x_m - meant.x_m, point.truth.y_m - meant.y_m), most_m)
        << point.t_s << " s";
  }
}

/// Samples courses over the whole range that config/courses/1-straight.toml documents, limited to a
/// length that a robot completes in about twenty seconds.
class Draw {
 public:
  explicit Draw(std::uint32_t seed) : random_(seed) {}

  std::size_t below(std::size_t count) { return random_() % count; }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967295.0;
  }

  course::Course course() {
    course::Course course = course_of({});
    course.speed_mps = over(0.01, 0.3);
    course.start = {.x_m = between(-100.0, 100.0),
                    .y_m = between(-100.0, 100.0),
                    .yaw_rad = between(-3600.0, 3600.0) * kRadPerDeg};
    double left_s = kLastsS;
    for (std::size_t i = 1 + below(8); i > 0 && left_s > 0.1; --i)
      course.path.push_back(segment(course.speed_mps, left_s));
    return course;
  }

 private:
  static constexpr double kLastsS = 20.0;
  static constexpr double kTurnsRadps = 0.6;

  /// Samples every order of magnitude with the same probability.
  double over(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

  course::Segment segment(double speed_mps, double& left_s) {
    const double most_s = left_s * between(0.2, 1.0);
    const std::size_t kind = below(3);
    if (kind == 0) {
      const double length_m = std::clamp(speed_mps * most_s, 0.001, over(0.001, 100.0));
      left_s -= length_m / speed_mps;
      return course::Line{length_m};
    }
    const double radius_m = over(0.01, 100.0);
    // In narrow arcs the robot drives more slowly.
    const double rate_radps = kind == 1 ? kTurnsRadps : std::min(speed_mps / radius_m, kTurnsRadps);
    const double sign = below(2) == 0 ? 1.0 : -1.0;
    const double sampled_deg = below(2) == 0 ? over(0.1, 3600.0) : between(0.1, 3600.0);
    const double angle_rad =
        std::max(std::min(sampled_deg * kRadPerDeg, rate_radps * most_s), 0.1 * kRadPerDeg);
    left_s -= angle_rad / rate_radps;
    if (kind == 1) return course::Pivot{sign * angle_rad};
    return course::Arc{radius_m, sign * angle_rad};
  }

  std::mt19937 random_;
};

class SampledPaths : public testing::Test {
 protected:
  static LockstepSettings sampled(int seed) {
    Draw draw(static_cast<std::uint32_t>(seed));
    const std::vector<std::string> robots = course::bundled_names(course::Bundled::kRobots);
    LockstepSettings run = settings(draw.course(), robots[draw.below(robots.size())]);
    // The course must not ask for more than the robot's highest track speed.
    run.course.speed_mps = std::min(run.course.speed_mps, run.robot.drive.max_track_mps);
    return run;
  }
};

TEST_F(SampledPaths, AreDrivenToTheirEnd) {
  for (int seed = 1; seed <= kSampled; ++seed) {
    const LockstepSettings run = sampled(seed);
    SCOPED_TRACE(testing::Message() << "sampled by " << seed << ", " << run.robot.name);
    const report::RunResult result = run_lockstep(run);
    expect_driven_whole(run, result);
    expect_watched(run, result);
    // A robot may make many turns on the spot about a point that is not the reference point.
    EXPECT_LE(report::figures(result, run.course).tracking.max_cross_track_m, 0.1);
  }
}

}  // namespace
}  // namespace tp100::sim
