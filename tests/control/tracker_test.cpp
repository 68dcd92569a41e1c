#include "control/tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "lagging_robot.h"

namespace tp100::control {
namespace {

struct Outcome {
  bool done = false;
  double duration_s = 0.0;
  double max_cross_track_m = 0.0;
  Pose end{};
};

template <class EachStep>
Outcome drive(const course::Course& course, EachStep each_step) {
  const course::Path path(course);
  Tracker tracker(Parameters{}, path, {.speed_mps = course.speed_mps});
  LaggingRobot robot;
  Outcome outcome;
  double progress = 0.0;
  while (outcome.duration_s < 3.0 * tracker.nominal_duration_s() + 5.0) {
    const Target& target = tracker.update(robot.pose, robot.twist, kDt);
    if (target.done) {
      outcome.done = true;
      break;
    }
    EXPECT_GE(target.progress_m, progress - 1e-9) << "progress must not go back";
    progress = target.progress_m;
    outcome.max_cross_track_m = std::max(outcome.max_cross_track_m, std::abs(target.cross_track_m));
    robot.obey(target);
    outcome.duration_s += kDt;
    each_step(robot, outcome.duration_s);
  }
  outcome.end = robot.pose;
  return outcome;
}

Outcome drive(const course::Course& course) {
  return drive(course, [](LaggingRobot&, double) {});
}

TEST(Tracker, DrivesALineToItsEndAndStopsThere) {
  const Outcome outcome = drive(make_course({course::Line{1.0}}));
  ASSERT_TRUE(outcome.done);
  EXPECT_NEAR(outcome.end.x_m, 1.0, 0.006);
  EXPECT_NEAR(outcome.end.y_m, 0.0, 1e-6);
}

TEST(Tracker, AnArcBetweenLinesStaysWithinMillimetres) {
  const Outcome outcome =
      drive(make_course({course::Line{0.4}, course::Arc{0.35, kPi}, course::Line{0.4}}));
  ASSERT_TRUE(outcome.done);
  EXPECT_LT(outcome.max_cross_track_m, 0.008);
  EXPECT_NEAR(outcome.end.x_m, 0.0, 0.01);
  EXPECT_NEAR(outcome.end.y_m, 0.7, 0.008);
  EXPECT_NEAR(outcome.end.yaw_rad, kPi, 0.05);
}

TEST(Tracker, APivotTurnsOnTheSpotBothWays) {
  const Outcome outcome =
      drive(make_course({course::Line{0.3}, course::Pivot{kPi / 2}, course::Line{0.3},
                         course::Pivot{-kPi / 2}, course::Line{0.3}}));
  ASSERT_TRUE(outcome.done);
  EXPECT_NEAR(outcome.end.x_m, 0.6, 0.01);
  EXPECT_NEAR(outcome.end.y_m, 0.3, 0.01);
  EXPECT_NEAR(outcome.end.yaw_rad, 0.0, 0.02);
}

TEST(Tracker, ReturnsToThePathAfterAShove) {
  bool shoved = false;
  double worst_late_m = 0.0;
  const Outcome outcome =
      drive(make_course({course::Line{1.5}}), [&](LaggingRobot& robot, double time_s) {
        if (!shoved && robot.pose.x_m > 0.5) {
          robot.pose.y_m += 0.04;
          robot.pose.yaw_rad += 15 * kRadPerDeg;
          shoved = true;
        }
        if (robot.pose.x_m > 0.9) worst_late_m = std::max(worst_late_m, std::abs(robot.pose.y_m));
        (void)time_s;
      });
  ASSERT_TRUE(outcome.done);
  EXPECT_LT(worst_late_m, 0.01);
}

TEST(Tracker, TakesTheNominalDurationWithinATenth) {
  const course::Course course = make_course({course::Line{1.7}});
  const course::Path path(course);
  const Tracker tracker(Parameters{}, path, {.speed_mps = course.speed_mps});
  const Outcome outcome = drive(course);
  EXPECT_NEAR(outcome.duration_s, tracker.nominal_duration_s(), 0.1 * tracker.nominal_duration_s());
}

TEST(Tracker, RestartBeginsThePathAnew) {
  const course::Course course = make_course({course::Line{0.2}, course::Pivot{1.0}});
  const course::Path path(course);
  Tracker tracker(Parameters{}, path, {.speed_mps = course.speed_mps});
  LaggingRobot robot;
  for (int i = 0; i < 4000 && !tracker.update(robot.pose, robot.twist, kDt).done; ++i) {
    robot.obey(tracker.update(robot.pose, robot.twist, kDt));
  }
  tracker.restart();
  const Target& target = tracker.update(Pose{}, Twist{}, kDt);
  EXPECT_FALSE(target.done);
  EXPECT_EQ(target.progress_m, 0.0);
}

}  // namespace
}  // namespace tp100::control
