// Errors of the simpler forms of the model.

#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"
#include "report/baselines.h"
#include "report/metrics.h"

namespace tp100::report {
namespace {

constexpr std::size_t kDifferential = model::baseline("differential");
constexpr std::size_t kGyro = model::baseline("gyro");

Sample sample(double t_s, std::int64_t left, std::int64_t right, double gyro_radps) {
  Sample result;
  result.device_us = static_cast<DeviceUs>(std::llround(t_s * 1e6));
  result.left_counts = left;
  result.right_counts = right;
  result.gyro_radps[2] = gyro_radps;
  return result;
}

TEST(MeasuredMotion, TheBiasIsThatOfTheLastStandstill) {
  MeasuredMotion motion;
  for (int i = 0; i <= 200; ++i) motion.take(sample(i * 0.005, i % 2, 0, i % 2 == 0 ? 0.03 : 0.01));
  EXPECT_NEAR(motion.bias_radps(), 0.02, 1e-9);
  EXPECT_NEAR(motion.now().gyro_rad, 0.02, 1e-9);
  for (int i = 1; i <= 200; ++i) motion.take(sample(1.0 + i * 0.005, 10 * i, -10 * i, 0.52));
  EXPECT_NEAR(motion.bias_radps(), 0.02, 1e-9);
  EXPECT_NEAR(motion.now().gyro_rad, 0.02 + 0.52, 2e-3);
  EXPECT_EQ(motion.now().left_counts, 2000);
  // Too short a standstill, then one that is long enough.
  for (int i = 1; i <= 50; ++i) motion.take(sample(2.0 + i * 0.005, 2000, -2000, 0.05));
  EXPECT_NEAR(motion.bias_radps(), 0.02, 1e-9);
  for (int i = 51; i <= 100; ++i) motion.take(sample(2.0 + i * 0.005, 2000, -2000, 0.05));
  EXPECT_NEAR(motion.bias_radps(), 0.05, 3e-3);
}

TEST(MeasuredMotion, ABootBeginsAnew) {
  MeasuredMotion motion;
  motion.take(sample(5.0, 100, 100, 1.0));
  motion.take(sample(5.005, 100, 100, 1.0));
  const double before_rad = motion.now().gyro_rad;
  motion.take(sample(0.1, 0, 0, 1.0));
  EXPECT_EQ(motion.now().gyro_rad, before_rad);
}

TEST(Baselines, FormsThatWereNotFittedAreLeftOut) {
  course::Robot robot;
  robot.shape.gauge_m = 0.2;
  robot.baselines[kGyro].emplace().slip_left = 0.25;
  const Baselines baselines = baselines_of(robot, 0.07);
  ASSERT_TRUE(baselines.forms[kDifferential]);
  EXPECT_EQ(baselines.forms[kDifferential]->wheelbase_m, 0.2);
  ASSERT_TRUE(baselines.forms[kGyro]);
  EXPECT_EQ(baselines.forms[kGyro]->slip_left, 0.25);
  EXPECT_EQ(baselines.forms[kGyro]->turning_threshold_radps, 0.07);
  EXPECT_FALSE(baselines.forms[model::kEqsFitted]);
  EXPECT_TRUE(baselines.forms[model::kEqsPrinted]);
}

/// A metre straight ahead at 0.1 m/s with a slip of 0.2, 1000 counts a metre, a gyro that turns by
/// 0.01 rad/s too much, of which half is bias. Nothing pushes it.
RunResult straight_run() {
  RunResult run;
  run.setup = "flat";
  course::Robot robot;
  robot.drive.counts_per_metre = 1000.0;
  robot.baselines[kGyro] = model::kBaselines[kGyro].only({});
  run.baselines = baselines_of(robot, 0.05);
  run.baselines.gyro_bias_radps = 0.005;
  for (int i = 0; i <= 1000; ++i) {
    TrajectoryPoint point;
    point.t_s = i * 0.01;
    point.truth.x_m = 3.0 + 0.001 * i * 0.8;
    point.estimates[PoseSource::kModel].x_m = 3.0;
    point.measured = {.device_us = 7'000'000 + i * 10'000,
                      .left_counts = -50 + i,
                      .right_counts = 50 + i,
                      .gyro_rad = 1.0 + 0.01 * 0.01 * i};
    run.points.push_back(point);
  }
  return run;
}

course::Course metre() {
  course::Course course;
  course.path = {course::Line{1.0}};
  return course;
}

TEST(Baselines, ErrorsAreThoseOfTheFormOnTheCountsOfTheRun) {
  const RunResult run = straight_run();
  const RunFigures figures = report::figures(run, metre());
  ASSERT_TRUE(figures.baselines[kDifferential]);
  // Without slip it ends 0.2 m too far ahead.
  EXPECT_NEAR(figures.baselines[kDifferential]->max_position_error_m, 0.2, 1e-9);
  EXPECT_NEAR(figures.baselines[kDifferential]->final_position_error_m, 0.2, 1e-9);
  EXPECT_NEAR(figures.baselines[kDifferential]->mean_position_error_m, 0.1, 1e-9);
  EXPECT_NEAR(figures.baselines[kDifferential]->max_yaw_error_rad, 0.0, 1e-9);
  // 10 s at 0.005 rad/s; the default slip of 0.1 leaves 0.9 m of arc.
  ASSERT_TRUE(figures.baselines[kGyro]);
  EXPECT_NEAR(figures.baselines[kGyro]->max_yaw_error_rad, 0.05, 1e-9);
  EXPECT_NEAR(figures.baselines[kGyro]->final_position_error_m,
              std::hypot(std::sin(0.05) / 0.05 * 0.9 - 0.8, (1 - std::cos(0.05)) / 0.05 * 0.9),
              1e-9);
  EXPECT_FALSE(figures.baselines[model::kEqsFitted]);
}

TEST(Baselines, ADisturbanceBeginsANewPieceAndOnAStandThereIsNoTruth) {
  RunResult run = straight_run();
  run.disturbances = {{4.9, 5.0}};
  EXPECT_NEAR(report::figures(run, metre()).baselines[kDifferential]->max_position_error_m, 0.1,
              1e-3);
  run.setup = "stand";
  for (const auto& errors : report::figures(run, metre()).baselines) EXPECT_FALSE(errors);
}

}  // namespace
}  // namespace tp100::report
