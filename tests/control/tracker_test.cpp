#include "control/tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
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

/// A line, an arc of `angle_deg` and another line.
course::Course circling(double angle_deg) {
  return make_course(
      {course::Line{0.2}, course::Arc{0.3, angle_deg * kRadPerDeg}, course::Line{0.2}});
}

TEST(Tracker, GoesAroundAsOftenAsTheCourseSays) {
  for (const double angle_deg : {359.0, -359.0, 360.0, -360.0, 400.0, -400.0, 720.0, 3600.0}) {
    SCOPED_TRACE(angle_deg);
    const course::Course course = circling(angle_deg);
    const course::PathPoint end = course::Path(course).segments().back().end;
    const Outcome outcome = drive(course);
    ASSERT_TRUE(outcome.done);
    EXPECT_LT(outcome.max_cross_track_m, 0.008);
    EXPECT_NEAR(outcome.end.x_m, end.x_m, 0.01);
    EXPECT_NEAR(outcome.end.y_m, end.y_m, 0.01);
    EXPECT_NEAR(outcome.end.yaw_rad, angle_deg * kRadPerDeg, 0.05);
  }
}

TEST(Tracker, CrossesItsOwnPathWithoutACut) {
  std::vector<course::Segment> spiral;
  for (int i = 1; i <= 3; ++i) spiral.emplace_back(course::Arc{0.15 * i, 2.0 * kPi});
  for (const course::Course& course :
       {make_course({course::Arc{0.3, 2.0 * kPi}, course::Arc{0.3, -2.0 * kPi}}),
        make_course({course::Line{0.3}, course::Arc{0.25, 1.5 * kPi}, course::Line{0.5},
                     course::Arc{0.25, -1.5 * kPi}, course::Line{0.5}}),
        make_course(spiral)}) {
    const course::Path path(course);
    const course::PathPoint end = path.segments().back().end;
    const Outcome outcome = drive(course);
    ASSERT_TRUE(outcome.done);
    EXPECT_LT(outcome.max_cross_track_m, 0.008);
    EXPECT_NEAR(outcome.duration_s, path.length_m() / course.speed_mps,
                0.1 * path.length_m() / course.speed_mps);
    EXPECT_NEAR(outcome.end.yaw_rad, end.yaw_rad, 0.05);
  }
}

/// From a progress of `after_progress_m` the robot ignores its commands and drives straight ahead
/// for `for_m`. Returns the distance off the path.
double off_path_of_a_runaway_m(const course::Course& course, double speed_mps,
                               double after_progress_m, double for_m) {
  const course::Path path(course);
  Tracker tracker(Parameters{}, path, {.speed_mps = course.speed_mps});
  LaggingRobot robot;
  const Target* target = &tracker.update(robot.pose, robot.twist, kDt);
  while (target->progress_m < after_progress_m) {
    robot.obey(*target);
    target = &tracker.update(robot.pose, robot.twist, kDt);
  }
  robot.twist = {.vx_mps = speed_mps};
  double off_path_m = 0.0;
  for (double distance_m = 0.0; distance_m < for_m; distance_m += std::abs(speed_mps) * kDt) {
    robot.pose.x_m += speed_mps * kDt * std::cos(robot.pose.yaw_rad);
    robot.pose.y_m += speed_mps * kDt * std::sin(robot.pose.yaw_rad);
    off_path_m = tracker.update(robot.pose, robot.twist, kDt).off_path_m;
  }
  return off_path_m;
}

TEST(Tracker, SeesThatTheRobotLeavesThePathAlongIt) {
  const course::Course line = make_course({course::Line{0.5}});
  EXPECT_NEAR(off_path_of_a_runaway_m(line, 0.1, 0.4, 0.4), 0.3, 0.01)
      << "past the end of the path";
  EXPECT_NEAR(off_path_of_a_runaway_m(line, -0.1, 0.4, 0.3), 0.3, 0.01) << "back towards its start";
}

TEST(Tracker, SeesThatTheRobotLeavesATurnOnTheSpot) {
  const course::Course corner =
      make_course({course::Line{0.5}, course::Pivot{2.0}, course::Line{0.5}});
  EXPECT_NEAR(off_path_of_a_runaway_m(corner, 0.1, 0.497, 0.3), 0.3, 0.01);
}

TEST(Tracker, OffThePathIsAsFarAsAcrossItWhereProgressIsRight) {
  const course::Course course =
      make_course({course::Line{0.3}, course::Arc{0.3, 7.0}, course::Line{0.3}});
  const course::Path path(course);
  Tracker tracker(Parameters{}, path, {.speed_mps = course.speed_mps});
  LaggingRobot robot;
  robot.pose.y_m = 0.02;
  for (int i = 0; i < 10000; ++i) {
    const Target& target = tracker.update(robot.pose, robot.twist, kDt);
    if (target.done) return;
    // The robot may overrun the end slightly when it stops.
    ASSERT_NEAR(target.off_path_m, std::abs(target.cross_track_m), 1e-3) << target.progress_m;
    robot.obey(target);
  }
  FAIL() << "the course was not finished";
}

// The yaw of an estimate may contain any number of whole turns. Two of the laws are linear in the
// heading error.
TEST(Tracker, AWholeTurnMoreOfThePosesYawChangesNothing) {
  const course::Course course = make_course(
      {course::Line{0.3}, course::Arc{0.3, 4.0}, course::Pivot{-2.0}, course::Line{0.3}});
  const course::Path path(course);
  for (const auto& [law, name] : kLawNames) {
    for (const double turns : {-2.0, 1.0}) {
      SCOPED_TRACE(testing::Message() << name << " " << turns);
      Parameters parameters;
      parameters.law = law;
      Tracker plain(parameters, path, {.speed_mps = course.speed_mps});
      Tracker turned(parameters, path, {.speed_mps = course.speed_mps});
      LaggingRobot robot;
      robot.pose.y_m = 0.02;
      bool done = false;
      for (int i = 0; i < 10000 && !done; ++i) {
        const bool pushed = i == 300;
        if (pushed) robot.pose.y_m += 0.05;
        Pose elsewhere = robot.pose;
        elsewhere.yaw_rad += turns * 2.0 * kPi;
        const Target& target = plain.update(robot.pose, robot.twist, kDt, pushed);
        const Target& same = turned.update(elsewhere, robot.twist, kDt, pushed);
        ASSERT_NEAR(same.speed_mps, target.speed_mps, 1e-9) << i;
        ASSERT_NEAR(same.yaw_rate_radps, target.yaw_rate_radps, 1e-9) << i;
        ASSERT_NEAR(same.heading_error_rad, target.heading_error_rad, 1e-9) << i;
        ASSERT_EQ(same.recovering, target.recovering) << i;
        robot.obey(target);
        done = target.done;
      }
      EXPECT_TRUE(done);
    }
  }
}

TEST(Tracker, ReturnsToThePathAfterADisturbance) {
  bool disturbed = false;
  double worst_late_m = 0.0;
  const Outcome outcome =
      drive(make_course({course::Line{1.5}}), [&](LaggingRobot& robot, double time_s) {
        if (!disturbed && robot.pose.x_m > 0.5) {
          robot.pose.y_m += 0.04;
          robot.pose.yaw_rad += 15 * kRadPerDeg;
          disturbed = true;
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

TEST(Tracker, TheNominalDurationOfALineIsItsDriveItsStartAndItsEnd) {
  const course::Course course = make_course({course::Line{1.7}});
  const course::Path path(course);
  const Parameters p;
  const Tracker tracker(p, path, {.speed_mps = 0.15});
  EXPECT_NEAR(tracker.nominal_duration_s(), 1.7 / 0.15 + 0.15 / p.acceleration_mps2 + p.settle_s,
              1e-9);
}

TEST(Tracker, TheNominalDurationKnowsThatNarrowArcsAreDrivenSlowly) {
  const course::Course course = make_course({course::Arc{0.03, 10.0 * kPi}});
  const course::Path path(course);
  const Tracker tracker(Parameters{}, path, {.speed_mps = course.speed_mps});
  const Outcome outcome = drive(course);
  ASSERT_TRUE(outcome.done);
  EXPECT_NEAR(outcome.duration_s, tracker.nominal_duration_s(), 0.2 * tracker.nominal_duration_s());
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
