#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"
#include "report/metrics.h"

namespace tp100::report {
namespace {

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
  EXPECT_EQ(errors.recovery_s[0], recovery.settling_s);
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

TEST(DisturbanceResponse, WhatWasNeverNoticedAndNeverSettledSaysSo) {
  const DisturbanceResponse recovery =
      judged(drive([](double t_s) { return t_s < 2.0 ? 0.0 : 0.05; })).recovery[0];
  EXPECT_FALSE(recovery.detection_s.has_value());
  EXPECT_FALSE(recovery.settling_s.has_value());
  EXPECT_NEAR(recovery.peak_cross_track_m, 0.05, 1e-9);
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

TEST(DisturbanceResponse, APushThatTheRunDidNotReachIsThereWithoutFigures) {
  const DisturbanceResponse recovery = judged(drive(disturbed_left, 1.0)).recovery[0];
  EXPECT_DOUBLE_EQ(recovery.begin_s, 2.0);
  EXPECT_FALSE(recovery.settling_s.has_value());
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
