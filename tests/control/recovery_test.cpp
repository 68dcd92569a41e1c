// Finding that the robot was pushed, and bringing it back to the path.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "control/tracker.h"
#include "lagging_robot.h"

namespace tp100::control {
namespace {

TEST(DisturbanceDetector, ATurnIsOneThatDiffersFromTheTracksForFifteenMilliseconds) {
  for (const double side : {1.0, -1.0}) {
    DisturbanceDetector disturbance{Parameters{}};
    disturbance.restart(0);
    const auto update = [&](double differs_radps) {
      return disturbance.update({.gyro_radps = -0.2 + side * differs_radps, .tracks_radps = -0.2},
                                kDt);
    };
    for (int i = 0; i < 100; ++i) EXPECT_FALSE(update(0.499));
    for (int i = 0; i < 100; ++i) EXPECT_FALSE(update(i % 3 == 0 ? 0.0 : 2.0)) << "noise";
    for (const bool now : {false, false, true, true}) EXPECT_EQ(update(0.501), now);
    EXPECT_FALSE(update(0.0));
    EXPECT_FALSE(update(0.501));
    disturbance.restart(0);
    for (const bool now : {false, false, true}) EXPECT_EQ(update(0.501), now);
  }
}

TEST(DisturbanceDetector, TheCameraThatContradictsIsOneOnce) {
  DisturbanceDetector disturbance{Parameters{}};
  disturbance.restart(3);
  EXPECT_FALSE(disturbance.update({.contradictions = 3}, kDt));
  EXPECT_TRUE(disturbance.update({.contradictions = 4}, kDt));
  EXPECT_FALSE(disturbance.update({.contradictions = 4}, kDt));
}

TEST(Recovery, EndsOnceTheRobotHasBeenWithinACentimetreAndThreeDegreesForHalfASecond) {
  for (const double side : {1.0, -1.0}) {
    Recovery recovery;
    EXPECT_FALSE(recovery.active());
    const auto lasts = [&](double cross_track_m, double heading_deg, int steps) {
      for (int i = 0; i < steps; ++i)
        recovery.update(side * cross_track_m, side * heading_deg * kRadPerDeg, kDt);
      return recovery.active();
    };
    recovery.begin();
    EXPECT_TRUE(lasts(0.0101, 0.0, 1000));
    EXPECT_TRUE(lasts(0.0, 3.01, 1000));
    EXPECT_TRUE(lasts(0.0099, 2.99, 98));
    recovery.begin();
    EXPECT_TRUE(lasts(0.0099, 2.99, 98)) << "another disturbance begins the time anew";
    EXPECT_TRUE(lasts(0.0101, 0.0, 1)) << "and so does leaving";
    EXPECT_TRUE(lasts(0.0099, 2.99, 98));
    EXPECT_FALSE(lasts(0.0099, 2.99, 4));
    recovery.begin();
    recovery.restart();
    EXPECT_FALSE(recovery.active());
  }
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
  constexpr double kSoonS = 2.5 + Recovery::kRecoveredForS;
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
