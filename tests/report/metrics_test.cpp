// Errors of estimates and tracking, and what a push costs.

#include "report/metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"

namespace tp100::report {
namespace {

const Pose& model_of(const TrajectoryPoint& point) { return point.estimates[PoseSource::kModel]; }

TrajectoryPoint point(double t_s, const Pose& truth, const Pose& model) {
  TrajectoryPoint result;
  result.t_s = t_s;
  result.truth = result.world = truth;
  result.estimates[PoseSource::kModel] = model;
  return result;
}

Pose pose(double x_m, double y_m, double yaw_rad = 0.0) {
  return {.x_m = x_m, .y_m = y_m, .yaw_rad = yaw_rad};
}

course::Course straight(double length_m) {
  course::Course course;
  course.path = {course::Line{length_m}};
  return course;
}

TEST(Coverage, IsTheShareWithinTwoStandardDeviations) {
  std::vector<TrajectoryPoint> points(4);
  for (TrajectoryPoint& one : points) {
    one.sd[PoseSource::kFused] = {.x_m = 0.01, .y_m = 0.02, .yaw_rad = 0.1};
    one.truth.yaw_rad = kPi;
  }
  points[0].truth.x_m = 0.019;
  points[1].truth.x_m = -0.021;
  points[2].truth.y_m = 0.039;
  points[3].truth.y_m = -0.041;
  // The same direction, a turn apart.
  points[0].estimates[PoseSource::kFused].yaw_rad = -kPi - 0.19;
  for (std::size_t i = 1; i < points.size(); ++i)
    points[i].estimates[PoseSource::kFused].yaw_rad = kPi + 0.21;
  EXPECT_EQ(coverage(points, PoseSource::kFused).position, 0.75);
  EXPECT_EQ(coverage(points, PoseSource::kFused).yaw, 0.25);
}

TEST(Coverage, OfTheModelEndsWhereADisturbanceBeginsAndOnAStandThereIsNone) {
  RunResult run;
  run.setup = "flat";
  for (int i = 0; i < 4; ++i) {
    run.points.push_back(point(i, pose(0.1 * i, i < 2 ? 0.0 : 0.05), pose(0.1 * i, 0.0)));
    run.points.back().estimates[PoseSource::kOdometry] = pose(0.1 * i, 0.0);
    run.points.back().sd = same_for_all(PoseSd{.x_m = 0.01, .y_m = 0.01, .yaw_rad = 0.1});
  }
  run.disturbances = {{1.5, 1.8}};
  const auto within = [&] { return figures(run, straight(1.0)).within_2_sd; };
  EXPECT_EQ(within()[PoseSource::kModel]->position, 1.0);
  EXPECT_EQ(within()[PoseSource::kOdometry]->position, 0.75);
  EXPECT_FALSE(within()[PoseSource::kFused]) << "no camera";
  run.disturbances = {{0.0, 0.3}};
  EXPECT_FALSE(within()[PoseSource::kModel]) << "nothing before it";
  run.setup = "stand";
  EXPECT_FALSE(within()[PoseSource::kOdometry]);
}

TEST(PoseErrors, FollowEquation8AndMeanSquares) {
  const std::vector<TrajectoryPoint> points = {
      point(0, pose(0, 0), pose(0, 0)),
      point(1, pose(1, 1, 0.1), pose(1.03, 1.04, -0.1)),
      point(2, pose(2, 1, 3.1), pose(2.0, 0.99, -3.1)),
  };
  const PoseErrors errors = pose_errors(points, {}, model_of);
  EXPECT_NEAR(errors.max_position_error_m, 0.05, 1e-12);
  EXPECT_NEAR(errors.mean_position_error_m, 0.06 / 3, 1e-12);
  EXPECT_NEAR(errors.rms_position_error_m, std::sqrt((0.0025 + 0.0001) / 3), 1e-12);
  EXPECT_NEAR(errors.final_position_error_m, 0.01, 1e-12);
  EXPECT_NEAR(errors.mse_x_m2, 0.0009 / 3, 1e-12);
  EXPECT_NEAR(errors.mse_y_m2, 0.0017 / 3, 1e-12);
  const double across = 2 * kPi - 6.2;  // the angle between 3.1 and -3.1
  EXPECT_NEAR(errors.max_yaw_error_rad, 0.2, 1e-12);
  EXPECT_NEAR(errors.mse_yaw_rad2, (0.04 + across * across) / 3, 1e-12);
}

TEST(PoseErrors, ADisturbanceBetweenTwoPointsStillSetsTheModelOntoTheTruth) {
  const std::vector<TrajectoryPoint> points = {
      point(0, pose(0, 0), pose(0, 0)), point(1, pose(1, 1), pose(1, 0)),
      point(2, pose(2, 1), pose(2, 0)), point(3, pose(3, 1.5), pose(3, 0))};
  const PoseErrors errors = pose_errors(points, {{0.4, 0.6}, {0.7, 0.8}}, model_of);
  EXPECT_NEAR(errors.max_position_error_m, 0.5, 1e-12);
  EXPECT_NEAR(errors.mean_position_error_m, 0.125, 1e-12);
}

TEST(TrackingErrors, MeasureTheDistanceToThePathAndTheYawToItsTangent) {
  std::vector<TrajectoryPoint> points = {point(0, pose(0, 0), {}),
                                         point(1, pose(0.5, 0.03, 0.1), {}),
                                         point(2, pose(1.04, 0.0, -0.2), {})};
  points[1].progress_m = 0.5;
  points[2].progress_m = 1.0;
  const TrackingErrors errors = tracking_errors(points, {}, course::Path(straight(1.0)));
  EXPECT_NEAR(errors.max_cross_track_m, 0.04, 1e-12);
  EXPECT_NEAR(errors.rms_cross_track_m, std::sqrt(0.0025 / 3), 1e-12);
  EXPECT_NEAR(errors.max_yaw_error_rad, 0.2, 1e-12);
  EXPECT_TRUE(errors.recovery.empty());
}

TEST(TrackingErrors, ATurnOnTheSpotIsNoYawError) {
  course::Course course;
  course.path = {course::Line{1.0}, course::Pivot{kPi / 2}, course::Line{1.0}};
  std::vector<TrajectoryPoint> points;
  for (int i = 0; i <= 10; ++i) {
    points.push_back(point(i, pose(1.0, 0.0, i * kPi / 20 + 2 * kPi), {}));
    points.back().progress_m = 1.0;
  }
  EXPECT_NEAR(tracking_errors(points, {}, course::Path(course)).max_yaw_error_rad, 0.0, 1e-12);
  points.back().world.yaw_rad += 0.3;
  EXPECT_NEAR(tracking_errors(points, {}, course::Path(course)).max_yaw_error_rad, 0.3, 1e-12);
}

TEST(TrackingErrors, ACrossingPathIsComparedNearTheProgressOnly) {
  course::Course course;  // a line, an arc, and a line that crosses the first one
  course.path = {course::Line{1.0}, course::Arc{0.5, 1.5 * kPi}, course::Line{1.5}};
  const course::Path path(course);
  TrajectoryPoint crossing = point(0, pose(0.5, 0.0, 0.0), {});
  crossing.progress_m = 0.5;
  EXPECT_NEAR(tracking_errors({crossing}, {}, path).max_cross_track_m, 0.0, 1e-12);
  crossing.world.y_m = 0.4;  // close to the arc, but that part of the path comes much later
  EXPECT_NEAR(tracking_errors({crossing}, {}, path).max_cross_track_m, 0.4, 1e-9);
}

TEST(TrackingErrors, AFoldedCornerIsComparedInTheOrderOfThePath) {
  course::Course course;  // out, and back at 30 degrees beside it
  course.path = {course::Line{1.0}, course::Pivot{150 * kRadPerDeg}, course::Line{1.0}};
  const course::Path path(course);
  // Back on the second leg, 8 cm from the corner and 3 cm beside it, where the first leg is nearer.
  const double yaw = 150 * kRadPerDeg;
  TrajectoryPoint back = point(0, {}, {});
  back.world = pose(1.0 + 0.08 * std::cos(yaw) - 0.03 * std::sin(yaw),
                    0.08 * std::sin(yaw) + 0.03 * std::cos(yaw), yaw);
  back.progress_m = 1.08;
  const TrackingErrors errors = tracking_errors({back}, {}, path);
  EXPECT_NEAR(errors.max_cross_track_m, 0.03, 1e-12);
  EXPECT_NEAR(errors.max_yaw_error_rad, 0.0, 1e-12);
  EXPECT_TRUE(deviations(path, {back}).front().left);
}

TEST(TrackingErrors, TheCornerItselfHasToBeReached) {
  course::Course course;
  course.path = {course::Line{1.0}, course::Pivot{kPi / 2}, course::Line{1.0}};
  // Every pose lies on a leg, but the corner is cut by 3 cm.
  std::vector<TrajectoryPoint> points = {
      point(0, pose(0.9, 0.0), {}), point(1, pose(0.97, 0.0, 0.2), {}),
      point(2, pose(1.0, 0.04, 1.2), {}), point(3, pose(1.0, 0.1, kPi / 2), {})};
  points[0].progress_m = 0.9;
  points[1].progress_m = points[2].progress_m = 1.0;
  points[3].progress_m = 1.1;
  const TrackingErrors errors = tracking_errors(points, {}, course::Path(course));
  EXPECT_NEAR(errors.max_cross_track_m, 0.03, 1e-12);
  EXPECT_NEAR(errors.rms_cross_track_m, 0.015, 1e-12);
  EXPECT_NEAR(errors.max_yaw_error_rad, 0.0, 1e-12);
}

constexpr double kPointS = 0.01;
constexpr DisturbanceWindow kDisturbance{2.0, 2.3};

/// A run along a line of 2 m at 0.1 m/s with a given distance to the left of the line.
template <class Left>
std::vector<TrajectoryPoint> drive(Left left_m, double duration_s = 10.0) {
  std::vector<TrajectoryPoint> points;
  for (int i = 0; i * kPointS <= duration_s; ++i) {
    TrajectoryPoint point;
    point.t_s = i * kPointS;
    point.world.x_m = 0.1 * point.t_s;
    point.world.y_m = left_m(point.t_s);
    point.progress_m = point.world.x_m;
    points.push_back(point);
  }
  return points;
}

/// Displaced by 4 cm to the left, back on the path at 4 s, then 3 mm too far, and on the path from
/// 5 s on.
double disturbed_left(double t_s) {
  if (t_s < 2.0) return 0.0;
  if (t_s < 2.3) return 0.04 * (t_s - 2.0) / 0.3;
  if (t_s < 4.0) return 0.04 * (4.0 - t_s) / 1.7;
  if (t_s < 4.3) return -0.01 * (t_s - 4.0);
  return t_s < 5.0 ? -0.003 : 0.0;
}

TrackingErrors judged(const std::vector<TrajectoryPoint>& points) {
  course::Course line;
  line.path = {course::Line{2.0}};
  return tracking_errors(points, {kDisturbance}, course::Path(line));
}

TEST(DisturbanceResponse, TellsDetectionPeakSettlingAndOvershoot) {
  std::vector<TrajectoryPoint> points = drive(disturbed_left);
  for (TrajectoryPoint& point : points) {
    point.recovering = point.t_s >= 2.05 && point.t_s < 4.5;
    if (point.t_s >= 2.3 && point.t_s < 3.0) point.world.yaw_rad = -0.3;
  }
  const TrackingErrors errors = judged(points);
  ASSERT_EQ(errors.recovery.size(), 1u);
  const DisturbanceResponse& recovery = errors.recovery[0];
  EXPECT_DOUBLE_EQ(recovery.begin_s, 2.0);
  ASSERT_TRUE(recovery.detection_s.has_value());
  EXPECT_NEAR(*recovery.detection_s, 0.05, 0.011);
  EXPECT_NEAR(recovery.peak_cross_track_m, 0.04, 0.001);
  EXPECT_NEAR(recovery.peak_yaw_error_rad, 0.3, 1e-9);
  ASSERT_TRUE(recovery.settling_s.has_value());
  EXPECT_NEAR(*recovery.settling_s, 4.0 - 0.01 / 0.04 * 1.7 - 2.3, 0.011);
  EXPECT_NEAR(recovery.overshoot_m, 0.001, 0.0003)
      << "it counts only until half a second within the band has passed";
  EXPECT_LT(recovery.shortcut_m, 1e-9);
  EXPECT_EQ(errors.false_alarms, 0);
}

TEST(DisturbanceResponse, APushToTheRightMirrorsIt) {
  const DisturbanceResponse left = judged(drive(disturbed_left)).recovery[0];
  const DisturbanceResponse right =
      judged(drive([](double t_s) { return -disturbed_left(t_s); })).recovery[0];
  EXPECT_DOUBLE_EQ(left.overshoot_m, right.overshoot_m);
  EXPECT_DOUBLE_EQ(left.peak_cross_track_m, right.peak_cross_track_m);
  EXPECT_GT(right.overshoot_m, 0.0);
}

TEST(DisturbanceResponse, WhatWasNeverNoticedNeverSettledOrNeverReachedSaysSo) {
  const auto pushed = [](double t_s) { return t_s < 2.0 ? 0.0 : 0.05; };
  const DisturbanceResponse recovery = judged(drive(pushed)).recovery[0];
  EXPECT_FALSE(recovery.detection_s.has_value());
  EXPECT_FALSE(recovery.settling_s.has_value());
  EXPECT_NEAR(recovery.peak_cross_track_m, 0.05, 1e-9);
  const DisturbanceResponse unreached = judged(drive(pushed, 1.0)).recovery[0];
  EXPECT_DOUBLE_EQ(unreached.begin_s, 2.0);
  EXPECT_FALSE(unreached.settling_s.has_value());
}

TEST(DisturbanceResponse, ThePartOfThePathThatWasLeftOutIsAShortcut) {
  std::vector<TrajectoryPoint> points = drive(disturbed_left);
  for (TrajectoryPoint& point : points) {
    if (point.t_s >= 2.3) point.progress_m += 0.5;
  }
  // The skipped part of the path lies beside this part.
  for (TrajectoryPoint& point : points) point.world.x_m = point.progress_m;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].t_s >= 2.3) points[i].world.x_m -= 0.5;
  const DisturbanceResponse recovery = judged(points).recovery[0];
  EXPECT_NEAR(recovery.shortcut_m, 0.5, 0.09);
}

TEST(DisturbanceResponse, ADisturbanceThatNobodyMadeIsAFalseAlarm) {
  std::vector<TrajectoryPoint> points = drive([](double) { return 0.0; });
  for (TrajectoryPoint& point : points) {
    point.recovering = (point.t_s > 0.5 && point.t_s < 1.0) ||
                       (point.t_s > 2.1 && point.t_s < 3.0) || (point.t_s > 6.0 && point.t_s < 6.5);
  }
  EXPECT_EQ(judged(points).false_alarms, 2);
}

}  // namespace
}  // namespace tp100::report
