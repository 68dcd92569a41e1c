#pragma once
// Random sequences of hand commands inside a fence, and how far the robot leaves it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>

#include "core/arithmetic.h"
#include "course/course.h"
#include "hand_driven.h"

namespace tp100::sim {

struct FenceRun {
  double outside_m =
      -1.0;  ///< greatest distance of the true centre from the fence; negative: inside
  double estimated_outside_m = -1.0;  ///< the same for the steering pose
  double pose_error_m = 0.0;          ///< greatest error of that pose
  double driven_m = 0.0;
  double at_fence_s = 0.0;  ///< the fence limited the speed
  RunState end = RunState::kIdle;
  FaultMask faults = 0;
  std::string what;
};

inline double outside_m(const Pose& pose, const course::Fence& fence) {
  double out_m = std::max({fence.min_x_m - pose.x_m, pose.x_m - fence.max_x_m,
                           fence.min_y_m - pose.y_m, pose.y_m - fence.max_y_m});
  for (const course::Polygon& area : fence.keep_out) {
    double edge_m = 1e9;
    for (std::size_t i = 0; i < area.size(); ++i) {
      const course::Vertex point = course::nearest_on_edge(area, i, pose.x_m, pose.y_m);
      edge_m = std::min(edge_m, std::hypot(point.x_m - pose.x_m, point.y_m - pose.y_m));
    }
    out_m = std::max(out_m, course::contains(area, pose.x_m, pose.y_m) ? edge_m : -edge_m);
  }
  return out_m;
}

/// Corners of a concave area beside the start, in a direction that follows from `seed`.
inline course::Polygon area_beside_start(std::uint64_t seed) {
  std::mt19937_64 random(seed + 1000);
  const double angle = std::uniform_real_distribution<>(-kPi, kPi)(random);
  const double c = std::cos(angle), s = std::sin(angle);
  course::Polygon area;
  for (const auto& [ahead_m, left_m] :
       {std::pair{0.12, -0.15}, {0.32, -0.15}, {0.22, 0.0}, {0.32, 0.15}, {0.12, 0.15}})
    area.push_back({c * ahead_m - s * left_m, s * ahead_m + c * left_m});
  return area;
}

/// Drives for `duration_s`, with floor, robot and fence that follow from `seed`.
inline FenceRun drive_in_fence(std::uint64_t seed, double duration_s) {
  constexpr std::array<const char*, 6> kRobots = {"end-loaded", "uniform", "front-heavy",
                                                  "slippery",   "large",   "worn"};
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  Options options;
  options.robot = kRobots[seed % kRobots.size()];
  Loaded loaded = load(options);

  auto course = std::make_shared<course::Course>(load_course("1-straight"));
  course->terrain = {};
  course->disturbances.clear();
  course->start = {};
  const double width_m = between(0.5, 1.6), height_m = between(0.5, 1.6);
  const double x_m = between(0.15, 0.85) * width_m, y_m = between(0.15, 0.85) * height_m;
  course->fence = {-x_m, width_m - x_m, -y_m, height_m - y_m};
  std::string what = options.robot;
  if (seed % 3 == 0) {
    course->fence.keep_out = {area_beside_start(seed)};
    what += ", keep-out area";
  }
  // Some fences are the same rectangle as a polygon.
  if (seed % 4 == 0) course->fence.corners = course::corners_of(course->fence);
  if (seed % 2 == 0) {
    course::Surface surface;
    surface.friction_factor = between(0.5, 1.0);
    surface.slip_offset = 0.0;
    surface.length_m = surface.width_m = 4.0;
    surface.place = {};
    course->terrain.surfaces.push_back(surface);
    what += ", friction " + std::to_string(surface.friction_factor);
  }

  HandDriven drive({.loaded = loaded, .course = course, .seed = seed});
  FenceRun run{.what = what};
  const std::string token = drive.wait_until_ready() ? drive.take(1) : "never ready";
  if (drive.state() != RunState::kDriving) {
    run.what += ": " + token;
    return run;
  }
  Pose last = drive.robot().truth().pose;
  drive.after_physics = [&] {
    const Pose& truth = drive.robot().truth().pose;
    run.driven_m += std::hypot(truth.x_m - last.x_m, truth.y_m - last.y_m);
    last = truth;
    run.outside_m = std::max(run.outside_m, outside_m(truth, course->fence));
  };
  double speed_mps = 0.0, rate_radps = 0.0;
  HostNs change_ns = 0, silent_until_ns = 0;
  drive.before_step = [&](HostNs now) {
    if (now >= change_ns) {
      change_ns = now + from_s(between(0.1, between(0.2, 5.0)));
      const double most_mps = loaded.robot.drive.max_track_mps;
      switch (random() % 8) {
        case 0:
          speed_mps = between(-1.0, 1.0) * most_mps;
          rate_radps = 0.0;
          break;
        case 1:
          speed_mps = 0.0;
          rate_radps = between(-1.2, 1.2);
          break;
        case 2:
          speed_mps = random() % 2 == 0 ? most_mps : -most_mps;
          rate_radps = between(-0.3, 0.3);
          break;
        case 3:
        case 6:
          speed_mps = random() % 2 == 0 ? most_mps : -most_mps;
          rate_radps = 0.0;
          break;
        case 7:
          speed_mps = -speed_mps;
          break;
        case 4:
          silent_until_ns = now + from_s(between(0.0, 0.4));
          break;
        default:
          speed_mps = between(-1.5, 1.5) * most_mps;
          rate_radps = between(-1.5, 1.5);
      }
    }
    if (now >= silent_until_ns && now / HandDriven::kPeriodNs % 5 == 0)
      drive.drive(1, token, speed_mps, rate_radps);
  };
  drive.after_step = [&](const StepRecord& record) {
    const Pose& pose = record.snapshot.world;
    const Pose& truth = drive.robot().truth().pose;
    run.estimated_outside_m = std::max(run.estimated_outside_m, outside_m(pose, course->fence));
    run.pose_error_m =
        std::max(run.pose_error_m, std::hypot(pose.x_m - truth.x_m, pose.y_m - truth.y_m));
    if (record.snapshot.at_fence) run.at_fence_s += to_s(HandDriven::kPeriodNs);
  };
  drive.step_until([&] { return drive.state() != RunState::kDriving; }, duration_s);
  run.end = drive.state();
  run.faults = drive.record().snapshot.faults;
  return run;
}

}  // namespace tp100::sim
