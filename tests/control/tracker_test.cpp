// Following a path, and coming back to it after a push.

#include "control/tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "lagging_robot.h"

namespace tp100::control {
namespace {

TEST(Tracker, DrivesTurnsCirclesAndCrossingsToTheirEndWithoutACut) {
  using course::Arc, course::Line, course::Pivot;
  const auto around = [](double deg) {
    return std::vector<course::Segment>{Line{0.2}, Arc{0.3, deg * kRadPerDeg}, Line{0.2}};
  };
  const std::vector<course::Segment> paths[] = {
      around(359.0),
      around(-360.0),
      around(400.0),
      around(-720.0),
      around(3600.0),
      {Line{0.3}, Pivot{kPi / 2}, Line{0.3}, Pivot{-kPi / 2}, Line{0.3}},
      {Arc{0.3, 2.0 * kPi}, Arc{0.3, -2.0 * kPi}},
      {Line{0.3}, Arc{0.25, 1.5 * kPi}, Line{0.5}, Arc{0.25, -1.5 * kPi}, Line{0.5}},
      {Arc{0.15, 2.0 * kPi}, Arc{0.3, 2.0 * kPi}, Arc{0.45, 2.0 * kPi}}};
  for (std::size_t i = 0; i < std::size(paths); ++i) {
    SCOPED_TRACE(i);
    const course::Path path(make_course(paths[i]));
    const course::PathPoint end = path.segments().back().end;
    Tracker tracker(Parameters{}, path, {.speed_mps = 0.1});
    LaggingRobot robot;
    double after_s = 0.0, progress_m = 0.0;
    for (; after_s < 1000.0; after_s += kDt) {
      const Target& target = tracker.update(robot.pose, robot.twist, kDt);
      if (target.done) break;
      ASSERT_GE(target.progress_m, progress_m - 1e-9) << "progress must not go back";
      progress_m = target.progress_m;
      ASSERT_LT(std::abs(target.cross_track_m), 0.008);
      robot.obey(target);
    }
    EXPECT_NEAR(after_s, tracker.nominal_duration_s(), 0.12 * tracker.nominal_duration_s());
    EXPECT_NEAR(robot.pose.x_m, end.x_m, 0.01);
    EXPECT_NEAR(robot.pose.y_m, end.y_m, 0.01);
    EXPECT_NEAR(robot.pose.yaw_rad, end.yaw_rad, 0.05);
  }
}

TEST(Tracker, RetunedDuringADriveSteersAsIfItHadBegunSo) {
  const course::Path path(make_course({course::Line{1.0}}));
  Parameters changed;
  changed.cross_track_gain_1ps *= 2.0;
  changed.preview_s *= 2.0;
  Tracker before({}, path, {}), retuned({}, path, {}), anew(changed, path, {});
  retuned.retune(changed);
  const auto yaw_rad = [](Tracker& tracker) {
    return tracker.update({.x_m = 0.01, .y_m = 0.002}, {}, kDt).desired_yaw_rad;
  };
  const double now_rad = yaw_rad(retuned);
  EXPECT_EQ(now_rad, yaw_rad(anew));
  EXPECT_NE(now_rad, yaw_rad(before));
}

TEST(Tracker, SeesThatTheRobotLeavesThePathAlongItAndInATurnOnTheSpot) {
  const course::Path path(make_course({course::Line{0.5}, course::Pivot{2.0}, course::Line{0.5}}));
  const auto off_path_m = [&](double from_m, double to_m) {
    Tracker tracker(Parameters{}, path, {});
    tracker.resume(from_m, 0.0);
    double off_m = 0.0;
    for (double share = 0.0; share < 1.0; share += 1e-3)
      off_m = tracker.update({.x_m = std::lerp(from_m, to_m, share)}, {}, kDt).off_path_m;
    return off_m;
  };
  EXPECT_NEAR(off_path_m(0.4, 0.8), 0.3, 0.01) << "past the end of the line";
  EXPECT_NEAR(off_path_m(0.4, 0.1), 0.3, 0.01) << "back towards its start";
  EXPECT_NEAR(off_path_m(0.5, 0.8), 0.3, 0.01) << "in the turn";
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

/// Lines, arcs and turns of all sizes, to both sides, away from the axes.
course::Path winding_path() {
  course::Course course = make_course(
      {course::Line{0.24}, course::Arc{0.3, 1.1}, course::Arc{0.08, -1.4}, course::Line{0.21},
       course::Pivot{1.3}, course::Line{0.17}, course::Pivot{-2.2}, course::Line{0.26}});
  course.start = {.x_m = 0.31, .y_m = -0.17, .yaw_rad = 0.6};
  return course::Path(course);
}

TEST(Tracker, SpeedsUpAndBrakesWithTheAccelerationForStopsAndNarrowCurves) {
  const course::Path path = winding_path();
  const Parameters p;
  Tracker tracker(p, path, {.speed_mps = 0.12});
  LaggingRobot robot;
  robot.pose = {.x_m = 0.31, .y_m = -0.17, .yaw_rad = 0.6};
  double most_mps = 0.0, fastest_mps = 0.0, done_s = 0.0;
  const double stop_m = path.segments()[4].begin.s_m;
  for (int i = 0; i < 8000; ++i, done_s += kDt) {
    const Target target = tracker.update(robot.pose, robot.twist, kDt);
    if (target.done) break;
    robot.obey(target);
    most_mps = target.speed_mps == 0.0 ? 0.0 : std::min(0.12, most_mps + p.acceleration_mps2 * kDt);
    ASSERT_LE(target.speed_mps, most_mps + 1e-9) << i;
    fastest_mps = std::max(fastest_mps, target.speed_mps);
    const double left_m = stop_m - target.progress_m;
    if (left_m > 0.0) {
      ASSERT_LE(target.speed_mps,
                std::max(p.min_speed_mps, std::sqrt(2.0 * p.acceleration_mps2 * left_m)) + 1e-6)
          << i;
    }
    if (std::abs(path.at(target.progress_m).curvature_1pm) > 10.0) {
      ASSERT_LE(target.speed_mps, 0.12 * 0.08 / p.full_speed_radius_m + 0.002) << i;
    }
  }
  EXPECT_NEAR(fastest_mps, 0.12, 1e-9);
  EXPECT_NEAR(done_s, tracker.nominal_duration_s(), 0.15 * tracker.nominal_duration_s());
}

TEST(Tracker, APausedRobotSlowsDownOnThePathStandsThereAndGoesOn) {
  const course::Path path = winding_path();
  const Parameters p;
  Tracker tracker(p, path, {.speed_mps = 0.1});
  LaggingRobot robot;
  robot.pose = {.x_m = 0.31, .y_m = -0.17, .yaw_rad = 0.6};
  const auto run = [&](int steps) {
    Target target;
    for (int i = 0; i < steps; ++i) {
      target = tracker.update(robot.pose, robot.twist, kDt);
      robot.obey(target);
    }
    return target;
  };
  EXPECT_NEAR(run(400).speed_mps, 0.1, 1e-9);
  tracker.pause(true);
  EXPECT_NEAR(run(67).speed_mps, 0.1 - 67 * p.acceleration_mps2 * kDt, 1e-6);
  const Target standing = run(200);
  EXPECT_EQ(standing.speed_mps, 0.0);
  EXPECT_EQ(standing.yaw_rate_radps, 0.0);
  EXPECT_NEAR(run(200).progress_m, standing.progress_m, 1e-4);
  tracker.pause(false);
  EXPECT_NEAR(run(60).speed_mps, 60 * p.acceleration_mps2 * kDt, 1e-6);
  while (run(1).yaw_rate_radps < 0.4 || run(1).speed_mps > 0.01) ASSERT_FALSE(run(1).done);
  tracker.pause(true);  // in the turn
  run(100);
  const double yaw_rad = robot.pose.yaw_rad;
  EXPECT_EQ(run(100).yaw_rate_radps, 0.0);
  EXPECT_NEAR(robot.pose.yaw_rad, yaw_rad, 1e-4);
  tracker.pause(false);
  EXPECT_TRUE(run(6000).done);
}

/// Time until a robot that stands at the end of `segment`, with these errors, is done; 9: never.
double settles_s(const course::Segment& segment, const Twist& twist, double short_of_m,
                 double yaw_error_rad) {
  const course::Path path(make_course({segment}));
  Tracker tracker(Parameters{}, path, {});
  const course::PathPoint end = path.segments().back().end;
  tracker.resume(0.97 * path.length_m(), end.yaw_rad);
  const Pose pose{
      .x_m = end.x_m - short_of_m, .y_m = end.y_m, .yaw_rad = end.yaw_rad + yaw_error_rad};
  double after_s = 0.0;
  while (!tracker.update(pose, twist, kDt).done && after_s < 9.0) after_s += kDt;
  return after_s;
}

// A standstill is less than 5 mm/s and 0.05 rad/s. A turn ends within 0.9 deg, or after 2 s, since
// a yaw loop that cannot close the last fraction of a degree must not block the run for ever.
TEST(Tracker, ASegmentEndsOnceTheRobotHasStoodForThreeTenthsOfASecond) {
  constexpr double kSettledS = 0.3, kTolerance = 0.011;
  for (const double sign : {1.0, -1.0}) {
    const course::Segment line = course::Line{0.4}, turn = course::Pivot{sign * 0.8};
    for (const course::Segment& segment : {line, turn}) {
      EXPECT_NEAR(settles_s(segment, {.vx_mps = sign * 0.0049}, 0.0, 0.0), kSettledS, kTolerance);
      EXPECT_GE(settles_s(segment, {.vx_mps = sign * 0.0051}, 0.0, 0.0), 8.9);
      EXPECT_NEAR(settles_s(segment, {.yaw_rate_radps = sign * 0.049}, 0.0, 0.0), kSettledS,
                  kTolerance);
      EXPECT_GE(settles_s(segment, {.yaw_rate_radps = sign * 0.051}, 0.0, 0.0), 8.9);
    }
    EXPECT_NEAR(settles_s(line, {}, 0.0029, sign * 0.2), kSettledS, kTolerance)
        << "any yaw will do";
    EXPECT_GE(settles_s(line, {}, 0.0031, 0.0), 8.9) << "it is not there yet";
    EXPECT_NEAR(settles_s(turn, {}, 0.0, sign * 0.89 * kRadPerDeg), kSettledS, kTolerance);
    EXPECT_NEAR(settles_s(turn, {}, 0.0, sign * 0.91 * kRadPerDeg), 2.0, kTolerance);
  }
}

// Whatever happened before: a pause, a push, a stop.
TEST(Tracker, ARestartedOrResumedTrackerIsOneThatWasJustMade) {
  const course::Path path = winding_path();
  const DriveModel drive{.speed_mps = 0.12, .tracks = {.x_icr_m = 0.02}};
  for (int i = 0; i < 12; ++i) {
    Tracker used(Parameters{}, path, drive), fresh(Parameters{}, path, drive);
    LaggingRobot robot;
    robot.pose = {.x_m = 0.31, .y_m = -0.17, .yaw_rad = 0.6};
    for (int n = 0; n < 350 * (i + 1); ++n)
      robot.obey(used.update(robot.pose, robot.twist, kDt, n % 340 == 330));
    if (i % 2 == 0) used.pause(true);
    const double progress_m = 0.07 * i;
    const course::PathPoint at = path.at(i % 3 == 0 ? 0.0 : progress_m);
    robot.pose = {.x_m = at.x_m + 0.004, .y_m = at.y_m - 0.003, .yaw_rad = at.yaw_rad + 0.1};
    robot.twist = {};
    if (i % 3 == 0) {
      used.restart();
    } else {
      for (Tracker* each : {&used, &fresh}) each->resume(progress_m, robot.pose.yaw_rad);
      EXPECT_NEAR(used.update(robot.pose, {}, kDt).progress_m, progress_m, 0.02);
      fresh.update(robot.pose, {}, kDt);
    }
    for (int n = 0; n < 200; ++n) {
      const Target target = used.update(robot.pose, robot.twist, kDt);
      const Target same = fresh.update(robot.pose, robot.twist, kDt);
      ASSERT_EQ(target.desired_yaw_rad, same.desired_yaw_rad) << i << " " << n;
      ASSERT_EQ(target.speed_mps, same.speed_mps) << i << " " << n;
      ASSERT_EQ(target.progress_m, same.progress_m) << i << " " << n;
      ASSERT_EQ(target.recovering, same.recovering) << i << " " << n;
      robot.obey(target);
    }
  }
}

TEST(Tracker, APlaceIsAsFarOffAsFromThePathNearbyWithinTheSlack) {
  const course::Path path(make_course({course::Line{1.0}}));
  Tracker tracker(Parameters{}, path, {});
  tracker.resume(0.5, 0.0);
  tracker.update({.x_m = 0.5}, {}, kDt);
  EXPECT_NEAR(tracker.off_path_m(0.53, 0.04), 0.05, 1e-9);
  EXPECT_NEAR(tracker.off_path_m(0.47, 0.04), 0.05, 1e-9);
  EXPECT_NEAR(tracker.off_path_m(0.53, 0.04, 0.1), 0.04, 1e-9);
  EXPECT_NEAR(tracker.off_path_m(0.64, 0.03, 0.1), 0.05, 1e-9);
  EXPECT_NEAR(tracker.off_path_m(0.36, 0.03, 0.1), 0.05, 1e-9);
}

/// A drive along `path`, during which the robot is displaced at 6 s and the tracker is notified.
/// The robot turns about a point `ahead_m` ahead of it, which the tracker takes for `assumed_m`.
struct Displaced {
  Displaced(std::vector<course::Segment> segments, double left_m, double yaw_rad,
            double ahead_m = 0.0, double assumed_m = 0.0) {
    const course::Path path(make_course(std::move(segments)));
    Tracker tracker(Parameters{}, path, {.speed_mps = 0.1, .tracks = {.x_icr_m = assumed_m}});
    LaggingRobot robot;
    robot.x_icr_m = ahead_m;
    double progress_m = 0.0;
    for (int i = 0; i < 4000; ++i) {
      const bool now = i == 1200;
      if (now) {
        robot.pose.x_m -= std::sin(robot.pose.yaw_rad) * left_m;
        robot.pose.y_m += std::cos(robot.pose.yaw_rad) * left_m;
        robot.pose.yaw_rad += yaw_rad;
      }
      const Target& target = tracker.update(robot.pose, robot.twist, kDt, now);
      if (target.done) break;
      EXPECT_TRUE(target.recovering || !now);
      jump_m = std::max(jump_m, std::abs(target.progress_m - progress_m));
      progress_m = target.progress_m;
      if (target.recovering && std::abs(target.heading_error_rad) > 0.4)
        fastest_mps = std::max(fastest_mps, target.speed_mps);
      if (i > 1200 && recovered_s < 0.0 && !target.recovering) recovered_s = (i - 1200) * kDt;
      robot.obey(target);
    }
  }

  double recovered_s = -1.0;  ///< duration of the recovery
  double fastest_mps = 0.0;   ///< while the robot looks elsewhere
  double jump_m = 0.0;        ///< greatest change of the progress in one step
};

// Turning back moves a robot with its turning centre ahead sideways, so that must be brought back.
TEST(RecoveryDrive, BringsTheRobotBackSoonFromEitherSideWhereverItTurns) {
  constexpr double kSoonS = 2.5 + kRecoveredForS;
  for (const double side : {-1.0, 1.0}) {
    for (const double yaw_rad : {-0.26, 0.26}) {
      for (const double ahead_m : {0.0, 0.03}) {
        const Displaced robot({course::Line{1.8}}, side * 0.04, yaw_rad, ahead_m, ahead_m);
        EXPECT_GT(robot.recovered_s, 0.5);
        EXPECT_LT(robot.recovered_s, kSoonS) << side << ' ' << yaw_rad << ' ' << ahead_m;
      }
    }
  }
  EXPECT_GT(Displaced({course::Line{1.8}}, 0.04, 0.26, 0.03).recovered_s,
            Displaced({course::Line{1.8}}, 0.04, 0.26, 0.03, 0.03).recovered_s + 0.3);
}

TEST(RecoveryDrive, GoesSlowlyUntilItLooksBack) {
  const Displaced robot({course::Line{1.8}}, 0.04, 0.4);
  EXPECT_GT(robot.fastest_mps, 0.0);
  EXPECT_LE(robot.fastest_mps, Parameters{}.recovery_speed_share * 0.1);
}

TEST(RecoveryDrive, PushedBackItDrivesThatPartAgain) {
  const course::Path path(make_course({course::Line{1.2}}));
  Tracker tracker(Parameters{}, path, {.speed_mps = 0.1});
  tracker.resume(0.5, 0.0);
  tracker.update({.x_m = 0.5}, {}, kDt);
  EXPECT_NEAR(tracker.update({.x_m = 0.44}, {}, kDt).progress_m, 0.5, 1e-9);
  EXPECT_NEAR(tracker.update({.x_m = 0.44}, {}, kDt, true).progress_m, 0.44, 1e-9);
}

// The two lines run side by side in opposite directions, 6 cm apart: the nearest point of the path
// is on the wrong one.
TEST(RecoveryDrive, DoesNotJumpToAPartOfThePathThatLiesBeside) {
  EXPECT_LT(
      Displaced({course::Line{0.8}, course::Arc{0.03, kPi}, course::Line{0.8}}, 0.05, 0.0).jump_m,
      0.11);
}

}  // namespace
}  // namespace tp100::control
