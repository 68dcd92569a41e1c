// What an overhead camera changes of a run, and what it does not.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "report/result_text.h"
#include "runs.h"

namespace tp100::sim {
namespace {

TEST(CameraRun, ACameraChangesNothingOfARunThatOdometrySteers) {
  LockstepSettings run = seen_run_of("1-curve", "end-loaded", PoseSource::kOdometry);
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
  LockstepSettings run = seen_run_of("1-sharp", "uniform");
  run.camera.reset();
  const report::RunResult result = run_lockstep(run);
  EXPECT_TRUE(result.completed) << result.cause;
  EXPECT_LT(report::figures(result, run.course).tracking.max_cross_track_m, 0.03);
}

TEST(CameraRun, OutliersAndLostFramesDoNotPullThePoseAway) {
  LockstepSettings run = seen_run_of("1-curve", "uniform");
  run.camera->outliers = 0.05;
  run.camera->dropped = 0.3;
  const report::RunResult result = run_lockstep(run);
  EXPECT_TRUE(result.completed) << result.cause;
  EXPECT_LT(max_position_error_m(result, run.course, PoseSource::kFused), 0.006);
}

TEST(CameraRun, DetectionsOfThisDriveTakeTheEmulatedCamerasPlace) {
  constexpr std::size_t kEvery = 20;  // samples, of 200 a second
  LockstepSettings run = run_of("1-curve", "uniform");
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
  const double fused_m = max_position_error_m(seen, run.course, PoseSource::kFused);
  EXPECT_LT(fused_m, 0.004);
  EXPECT_LT(fused_m, max_position_error_m(blind, run.course, PoseSource::kOdometry));
}

TEST(CameraRun, AStandIsNoPlaceForACamera) {
  LockstepSettings run = seen_run_of("1-curve", "end-loaded");
  run.setup = bridge::Setup::kStand;
  EXPECT_THROW(run_lockstep(run), SetupError);
}

}  // namespace
}  // namespace tp100::sim
