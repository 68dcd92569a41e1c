#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/arithmetic.h"
#include "core/error.h"
#include "recovered.h"
#include "report/metrics.h"
#include "report/result_text.h"
#include "report/run_result.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"

namespace tp100::sim {
namespace {

LockstepSettings settings(const std::string& course, const std::string& robot,
                          PoseSource steering) {
  Options options;
  options.robot = robot;
  const Loaded loaded = load(options);
  LockstepSettings settings{.course = load_course(course),
                            .robot = loaded.robot,
                            .configuration = loaded.configuration,
                            .setup = loaded.setup,
                            .camera = load_camera("overhead")};
  settings.configuration.parameters.steering = steering;
  return settings;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct CameraCase {
  const char* course;
  const char* robot;
  double max_m;  ///< largest error of the fused pose, median over the seeds; 0: no limit
  double tracking_m;
  std::uint64_t seeds;
};

class FusedCourses : public testing::TestWithParam<CameraCase> {};

TEST_P(FusedCourses, FusedSteersAndKeepsItsLimits) {
  const CameraCase& which = GetParam();
  LockstepSettings run = settings(which.course, which.robot, PoseSource::kFused);
  std::vector<double> max_m, rms_m, yaw_rad, tracking_m;
  for (run.seed = 1; run.seed <= which.seeds; ++run.seed) {
    SCOPED_TRACE(testing::Message() << "seed " << run.seed);
    const report::RunResult result = run_lockstep(run);
    EXPECT_TRUE(result.completed) << result.cause;
    const report::RunFigures figures = report::figures(result, run.course);
    max_m.push_back(figures.estimates[PoseSource::kFused]->max_position_error_m);
    rms_m.push_back(figures.estimates[PoseSource::kFused]->rms_position_error_m);
    yaw_rad.push_back(std::sqrt(figures.estimates[PoseSource::kFused]->mse_yaw_rad2));
    tracking_m.push_back(figures.tracking.max_cross_track_m);
    expect_recovered(figures.tracking, run.course);
  }
  EXPECT_LE(median(rms_m), 0.010);
  EXPECT_LE(median(yaw_rad), 1.0 * kRadPerDeg);
  if (which.max_m > 0.0) {
    EXPECT_LE(median(max_m), which.max_m);
    EXPECT_LE(median(tracking_m), which.tracking_m);
  }
}

std::vector<CameraCase> cases(std::uint64_t seeds) {
  return {{"1-straight", "end-loaded", 0.006, 0.008, seeds},
          {"1-curve", "end-loaded", 0.006, 0.008, seeds},
          {"1-sharp", "end-loaded", 0.010, 0.015, seeds},
          {"2", "end-loaded", 0.0, 0.0, seeds},
          {"1-curve", "uniform", 0.006, 0.008, seeds},
          {"2", "uniform", 0.0, 0.0, seeds}};
}

std::string camera_case_name(const testing::TestParamInfo<CameraCase>& param) {
  std::string name = std::string(param.param.course) + "_" + param.param.robot;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Flat, FusedCourses, testing::ValuesIn(cases(3)), camera_case_name);
INSTANTIATE_TEST_SUITE_P(NightlyFlat, FusedCourses, testing::ValuesIn(cases(10)), camera_case_name);

TEST(CameraRun, ACameraChangesNothingOfARunThatOdometrySteers) {
  LockstepSettings run = settings("1-curve", "end-loaded", PoseSource::kOdometry);
  const auto text = [&run] {
    report::RunResult result = run_lockstep(run);
    result.realtime_factor = 0.0;
    result.loop.clear();
    auto json =
        nlohmann::json::parse(report::result_json(result, report::figures(result, run.course)));
    EXPECT_EQ(json.contains("fused"), run.camera.has_value());
    json.erase("fused");
    json.erase("camera");
    return json.dump();
  };
  const std::string seen = text();
  run.camera.reset();
  EXPECT_EQ(seen, text());
}

TEST(CameraRun, WithoutACameraTheFilterStillSteers) {
  LockstepSettings run = settings("1-sharp", "uniform", PoseSource::kFused);
  run.camera.reset();
  const report::RunResult result = run_lockstep(run);
  EXPECT_TRUE(result.completed) << result.cause;
  EXPECT_LT(report::figures(result, run.course).tracking.max_cross_track_m, 0.03);
}

TEST(CameraRun, OutliersAndLostFramesDoNotPullThePoseAway) {
  LockstepSettings run = settings("1-curve", "uniform", PoseSource::kFused);
  run.camera->outliers = 0.05;
  run.camera->dropped = 0.3;
  const report::RunResult result = run_lockstep(run);
  EXPECT_TRUE(result.completed) << result.cause;
  EXPECT_LT(report::figures(result, run.course).estimates[PoseSource::kFused]->max_position_error_m,
            0.006);
}

TEST(CameraRun, DetectionsOfThisDriveTakeTheEmulatedCamerasPlace) {
  constexpr std::size_t kEvery = 20;  // samples, of 200 a second
  LockstepSettings run = settings("1-curve", "uniform", PoseSource::kOdometry);
  run.camera.reset();
  const report::RunResult blind = run_lockstep(run);
  for (std::size_t i = 0; i < blind.points.size(); i += kEvery) {
    const report::TrajectoryPoint& point = blind.points[i];
    run.detections.push_back({.x_m = point.truth.x_m,
                              .y_m = point.truth.y_m,
                              .yaw_rad = wrap_angle(point.truth.yaw_rad),
                              .measured_ns = from_s(point.t_s),
                              .sequence = static_cast<std::uint32_t>(i)});
  }
  const report::RunResult seen = run_lockstep(run);
  ASSERT_EQ(seen.points.size(), blind.points.size());
  EXPECT_EQ(seen.points.back().truth.x_m, blind.points.back().truth.x_m);
  EXPECT_TRUE(seen.has_camera);
  EXPECT_EQ(seen.camera.rejected, 0U);
  // But for those that are under way at the end.
  EXPECT_GE(seen.camera.used + 2, run.detections.size());
  const auto error_m = [&run](const report::RunResult& result, PoseSource source) {
    return report::figures(result, run.course).estimates[source]->max_position_error_m;
  };
  EXPECT_LT(error_m(seen, PoseSource::kFused), 0.004);
  EXPECT_LT(error_m(seen, PoseSource::kFused), error_m(blind, PoseSource::kOdometry));
}

TEST(CameraRun, AStandIsNoPlaceForACamera) {
  LockstepSettings run = settings("1-curve", "end-loaded", PoseSource::kOdometry);
  run.setup = bridge::Setup::kStand;
  EXPECT_THROW(run_lockstep(run), SetupError);
}

}  // namespace
}  // namespace tp100::sim
