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
  const PoseErrors errors = pose_errors(points, model_of);
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

TEST(PoseErrors, ADisturbanceThatTheModelCannotSeeDoesNotCountAgainstIt) {
  // The robot drives straight, is displaced by (0.04 m, 15 deg) and drives on. For the model, it
  // drives straight all the time.
  const double turn = 15 * kRadPerDeg;
  std::vector<TrajectoryPoint> points;
  for (int i = 0; i <= 400; ++i) {
    const double t = i * 0.01, s = 0.1 * t;
    Pose truth = pose(s, 0);
    if (t > 2.0) {
      const double part = std::min(1.0, (t - 2.0) / 0.3), after = std::max(0.0, s - 0.23);
      truth = pose(std::min(s, 0.23) + after * std::cos(turn), 0.04 * part + after * std::sin(turn),
                   turn * part);
    }
    points.push_back(point(t, truth, pose(s, 0)));
  }
  EXPECT_GT(pose_errors(points, model_of).max_position_error_m, 0.04);
  const PoseErrors between = pose_errors_between(points, {{2.0, 2.3}}, model_of);
  EXPECT_LT(between.max_position_error_m, 1e-3);
  EXPECT_LT(between.max_yaw_error_rad, 1e-9);
}

TEST(PoseErrors, ADisturbanceBetweenTwoPointsStillSetsTheModelOntoTheTruth) {
  const std::vector<TrajectoryPoint> points = {
      point(0, pose(0, 0), pose(0, 0)), point(1, pose(1, 1), pose(1, 0)),
      point(2, pose(2, 1), pose(2, 0)), point(3, pose(3, 1.5), pose(3, 0))};
  const PoseErrors errors = pose_errors_between(points, {{0.4, 0.6}, {0.7, 0.8}}, model_of);
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
  EXPECT_TRUE(errors.recovery_s.empty());
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

TEST(TrackingErrors, RecoveryRunsFromTheEndOfThePushToTheLastReturn) {
  std::vector<TrajectoryPoint> points;
  for (int i = 0; i <= 1000; ++i) {
    const double t = i * 0.01;
    double y = 0.0;
    if (t > 1.0 && t < 2.5) y = 0.04;
    if (t > 2.7 && t < 2.8) y = 0.02;  // within the band for 0.2 s only
    if (t > 5.0) y = 0.04;             // disturbed again, without a return
    points.push_back(point(t, pose(0.1 * t, y), {}));
    points.back().progress_m = 0.1 * t;
  }
  const TrackingErrors errors =
      tracking_errors(points, {{1.0, 1.3}, {5.0, 5.3}}, course::Path(straight(2.0)));
  ASSERT_EQ(errors.recovery_s.size(), 2u);
  ASSERT_TRUE(errors.recovery_s[0].has_value());
  EXPECT_NEAR(*errors.recovery_s[0], 1.5, 0.011);
  EXPECT_FALSE(errors.recovery_s[1].has_value());
}

}  // namespace
}  // namespace tp100::report
