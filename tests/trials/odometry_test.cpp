// Odometry against the two sensors that it fuses, each alone, and its covariance against a camera:
// on courses that are not bundled, with every robot, on even and uneven floors.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "course/bundled_files.h"
#include "course/path.h"
#include "report/metrics.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"

namespace tp100::sim {
namespace {

using Path = std::vector<course::Segment>;

Path times(int count, const Path& piece) {
  Path all;
  for (int i = 0; i < count; ++i) all.insert(all.end(), piece.begin(), piece.end());
  return all;
}
Path joined(Path path, const Path& more) {
  path.insert(path.end(), more.begin(), more.end());
  return path;
}
course::Line line(double length_m) { return {length_m}; }
course::Arc arc(double radius_m, double angle_deg) { return {radius_m, angle_deg * kRadPerDeg}; }
course::Pivot pivot(double angle_deg) { return {angle_deg * kRadPerDeg}; }

course::Course course_of(const std::string& name, const Path& path, double speed_mps = 0.1) {
  constexpr double kMarginM = 0.3, kStepM = 0.05;
  course::Course course;
  course.name = name;
  course.speed_mps = speed_mps;
  course.path = path;
  course::Fence fence{0.0, 0.0, 0.0, 0.0};
  const course::Path laid(course);
  for (int i = 0; i * kStepM <= laid.length_m(); ++i) {
    const course::PathPoint at = laid.at(i * kStepM);
    fence.min_x_m = std::min(fence.min_x_m, at.x_m - kMarginM);
    fence.max_x_m = std::max(fence.max_x_m, at.x_m + kMarginM);
    fence.min_y_m = std::min(fence.min_y_m, at.y_m - kMarginM);
    fence.max_y_m = std::max(fence.max_y_m, at.y_m + kMarginM);
  }
  course.fence = fence;
  return course;
}

course::Surface patch(double x_m, double y_m, double friction, double slip) {
  return {.name = "patch",
          .place = {x_m, y_m, 0.0},
          .length_m = 0.5,
          .width_m = 0.6,
          .friction_factor = friction,
          .slip_offset = slip};
}

std::vector<course::Course> courses() {
  Path spiral;
  for (int i = 0; i < 10; ++i) spiral.emplace_back(arc(0.15 + 0.1 * i, 180.0));
  std::vector<course::Course> all = {
      course_of("straight", {line(12.0)}),
      course_of("s-curves", times(4, {arc(0.5, 90.0), arc(0.5, -90.0)})),
      course_of("slalom", times(8, {arc(0.25, 70.0), arc(0.25, -70.0)})),
      course_of("zigzag", times(6, {line(0.4), pivot(70.0), line(0.4), pivot(-70.0)})),
      course_of("surfaces",
                joined(times(2, {line(1.2), pivot(90.0), line(0.6), pivot(90.0)}),
                       {line(0.8), arc(0.4, 180.0), line(1.0), pivot(-120.0), line(1.0)})),
      course_of("ice", joined(times(3, {arc(0.5, 90.0), arc(0.5, -90.0)}), {line(1.0)})),
      course_of("pushed", {line(2.0), arc(0.5, 90.0), line(2.0)}),
      course_of("circle", {arc(0.4, 720.0)}),
      course_of("eight", times(2, {arc(0.35, 360.0), arc(0.35, -360.0)})),
      course_of("tight", times(4, {line(0.3), arc(0.14, 180.0), line(0.3), arc(0.14, -180.0)})),
      course_of("fast", times(2, {line(1.5), arc(0.6, 180.0)}), 0.15),
      course_of("slow", {line(0.8), arc(0.4, 120.0), line(0.8)}, 0.04),
      course_of("spins", times(6, {pivot(180.0), line(0.25), pivot(-180.0), line(0.25)})),
      course_of("star", times(5, {line(0.8), pivot(144.0)})),
      course_of("long-curve", {line(3.0), arc(1.5, 90.0), line(3.0)}),
      course_of("spiral", spiral),
      course_of("squares", times(8, {line(1.0), pivot(90.0)})),
      course_of("wide", {line(0.3), arc(0.7, 135.0), arc(1.5, -90.0), line(0.3)})};
  const auto named = [&](const char* name) -> course::Course& {
    return *std::ranges::find(all, name, &course::Course::name);
  };
  named("surfaces").terrain.surfaces = {patch(0.6, 0.0, 0.6, 0.05), patch(1.2, 0.4, 1.3, -0.02),
                                        patch(0.6, 0.6, 0.65, 0.08), patch(0.0, 0.3, 0.9, 0.04)};
  named("ice").terrain.surfaces = {patch(0.5, 0.5, 0.6, 0.06), patch(1.5, 1.5, 0.6, -0.03),
                                   patch(2.5, 2.5, 0.7, 0.08)};
  named("pushed").disturbances = {{0.6, 0.03, 8.0 * kRadPerDeg, 0.4},
                                  {3.6, -0.03, -8.0 * kRadPerDeg, 0.4}};
  return all;
}

constexpr double kShare = 1.2, kMoreM = 0.01, kMoreRad = 1.0 * kRadPerDeg;

struct Drive {
  std::string what;
  bool completed = false;
  /// Largest errors of odometry, the bare gyro and the encoders.
  report::PoseErrors odometry{}, gyro{}, encoders{};
  double off_path_m = 0.0;
  report::CameraFigures camera{};

  /// Not more than 1.2 times the better sensor's error, and a little.
  bool good() const {
    const auto within = [&](double report::PoseErrors::*figure, double more) {
      return odometry.*figure <= kShare * std::min(gyro.*figure, encoders.*figure) + more;
    };
    return within(&report::PoseErrors::max_position_error_m, kMoreM) &&
           within(&report::PoseErrors::max_yaw_error_rad, kMoreRad);
  }
  bool nis_in_band() const {
    return std::abs(camera.nis_mean - kNisDegrees) < camera.nis_half_band();
  }
  void print() const {
    std::printf(
        "%-36s position %5.1f (gyro %5.1f, encoders %5.1f) cm  yaw %5.1f (%5.1f, %5.1f) "
        "deg  off the path %4.1f cm  NIS %.2f +- %.2f%s%s%s\n",
        what.c_str(), 100.0 * odometry.max_position_error_m, 100.0 * gyro.max_position_error_m,
        100.0 * encoders.max_position_error_m, odometry.max_yaw_error_rad * kDegPerRad,
        gyro.max_yaw_error_rad * kDegPerRad, encoders.max_yaw_error_rad * kDegPerRad,
        100.0 * off_path_m, camera.nis_mean, camera.nis_half_band(), good() ? "" : "  WORSE",
        nis_in_band() ? "" : "  NIS", completed ? "" : "  not completed");
  }
};

Drive drive(LockstepSettings& settings, const course::Course& course) {
  settings.course = course;
  const report::RunResult result = run_lockstep(settings);
  const report::RunFigures figures = report::figures(result, course);
  const auto errors_of = [&](PoseSource source) {
    return report::pose_errors(result.points, result.disturbances,
                               [source](const report::TrajectoryPoint& at) -> const Pose& {
                                 return at.estimates[source];
                               });
  };
  return {.what = course.name + " " + settings.robot.name + " " +
                  std::string(to_string(settings.robot.emulated.floor)) + " " +
                  std::to_string(settings.seed),
          .completed = result.completed,
          .odometry = errors_of(PoseSource::kOdometry),
          .gyro = figures.baselines[model::baseline("gyro")].value_or(report::PoseErrors{}),
          .encoders = errors_of(PoseSource::kModel),
          .off_path_m = figures.tracking.max_cross_track_m,
          .camera = result.camera};
}

constexpr std::uint64_t kFirstSeed = 9001;

/// One robot on one floor, on the courses from `first` on, one in `every`; a camera watches.
struct Sweep {
  std::string robot;
  course::Floor floor = course::Floor::kEven;
  PoseSource steering = PoseSource::kFused;
  std::size_t first = 0, every = 1;
  std::uint64_t seeds = 5;

  std::vector<Drive> drives() const {
    LockstepSettings settings;
    Options options;
    options.robot = robot;
    settings.robot = load(options).robot;
    settings.robot.emulated.floor = floor;
    settings.camera = course::EmulatedCamera{};
    settings.configuration.parameters.steering = steering;
    const std::vector<course::Course> all = courses();
    std::vector<Drive> drives;
    for (std::size_t i = first; i < all.size(); i += every) {
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        settings.seed = kFirstSeed + seed;
        drives.push_back(drive(settings, all[i]));
        drives.back().print();
      }
    }
    return drives;
  }
};

/// The share of good drives. Over an uneven floor one of the sensors may be right by chance.
void expect_good(const std::vector<Drive>& drives, double share) {
  double good = 0.0, in_band = 0.0, odometry = 0.0, gyro = 0.0, encoders = 0.0;
  for (const Drive& one : drives) {
    EXPECT_TRUE(one.completed) << one.what;
    good += one.good() ? 1.0 : 0.0;
    in_band += one.nis_in_band() ? 1.0 : 0.0;
    odometry += one.odometry.max_yaw_error_rad;
    gyro += one.gyro.max_yaw_error_rad;
    encoders += one.encoders.max_yaw_error_rad;
  }
  const auto count = static_cast<double>(drives.size());
  EXPECT_GE(good / count, share);
  EXPECT_GE(in_band / count, share);
  EXPECT_LT(odometry, std::max(0.9 * gyro, 1.2 * encoders + count * kMoreRad));
}

TEST(Odometry, IsNoWorseThanTheBetterOfItsSensors) {
  std::vector<Drive> all;
  std::size_t first = 0;
  for (const std::string& robot : course::bundled_names(course::Bundled::kRobots)) {
    const Sweep sweep{.robot = robot,
                      .floor = first % 2 == 0 ? course::Floor::kUneven : course::Floor::kEven,
                      .first = first,
                      .every = 9,
                      .seeds = 1};
    for (Drive& one : sweep.drives()) all.push_back(std::move(one));
    ++first;
  }
  expect_good(all, 0.75);
}

class OdometrySweep : public testing::TestWithParam<std::tuple<std::string, course::Floor>> {
 protected:
  Sweep sweep() const {
    return {.robot = std::get<0>(GetParam()), .floor = std::get<1>(GetParam())};
  }
};

TEST_P(OdometrySweep, IsNoWorseThanTheBetterOfItsSensorsOnAnyCourse) {
  expect_good(sweep().drives(), 0.7);
}

TEST_P(OdometrySweep, SteersNoFartherOffThePathThanTheGyroWouldAndSomeCentimetres) {
  Sweep steered = sweep();
  steered.steering = PoseSource::kOdometry;
  steered.seeds = 1;
  for (const Drive& one : steered.drives()) {
    EXPECT_TRUE(one.completed) << one.what;
    EXPECT_LT(one.off_path_m, 1.2 * one.gyro.max_position_error_m + 0.05) << one.what;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Nightly, OdometrySweep,
    testing::Combine(testing::ValuesIn(course::bundled_names(course::Bundled::kRobots)),
                     testing::Values(course::Floor::kEven, course::Floor::kUneven)));

}  // namespace
}  // namespace tp100::sim
