#include <gtest/gtest.h>

#include <cmath>

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

struct Displacement {
  double along_m = 0.0, left_m = 0.0, yaw_rad = 0.0;
};

/// The point about which a robot turns, as a distance ahead of it: the true one, and the one that
/// the tracker uses.
struct TurningCentre {
  double ahead_m = 0.0, assumed_m = 0.0;
};

/// Drives `course`; at 6 s the robot is displaced, and the tracker is notified. Returns the
/// duration of the recovery, -1 if there is none.
double recovered_after_s(const course::Course& course, const Displacement& disturbance,
                         double speed_share, double* fastest_mps = nullptr,
                         double* furthest_jump_m = nullptr, const TurningCentre& centre = {}) {
  Parameters parameters;
  parameters.recovery_speed_share = speed_share;
  const course::Path path(course);
  Tracker tracker(parameters, path,
                  {.speed_mps = course.speed_mps, .tracks = {.x_icr_m = centre.assumed_m}});
  LaggingRobot robot;
  robot.x_icr_m = centre.ahead_m;
  double recovered_s = -1.0, progress_m = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const bool now = i == 1200;
    if (now) {
      const double c = std::cos(robot.pose.yaw_rad), s = std::sin(robot.pose.yaw_rad);
      robot.pose.x_m += c * disturbance.along_m - s * disturbance.left_m;
      robot.pose.y_m += s * disturbance.along_m + c * disturbance.left_m;
      robot.pose.yaw_rad += disturbance.yaw_rad;
    }
    const Target& target = tracker.update(robot.pose, robot.twist, kDt, now);
    if (target.done) break;
    if (now) {
      EXPECT_TRUE(target.recovering);
    }
    if (furthest_jump_m != nullptr)
      *furthest_jump_m = std::max(*furthest_jump_m, std::abs(target.progress_m - progress_m));
    progress_m = target.progress_m;
    if (target.recovering && std::abs(target.heading_error_rad) > 0.4 && fastest_mps != nullptr)
      *fastest_mps = std::max(*fastest_mps, target.speed_mps);
    if (i > 1200 && recovered_s < 0.0 && !target.recovering) recovered_s = (i - 1200) * kDt;
    robot.obey(target);
  }
  return recovered_s;
}

TEST(RecoveryDrive, BringsTheRobotBackFromEitherSide) {
  for (const double side : {-1.0, 1.0}) {
    for (const double yaw_deg : {-15.0, 15.0}) {
      const double took_s =
          recovered_after_s(make_course({course::Line{1.8}}),
                            {.left_m = side * 0.04, .yaw_rad = yaw_deg * kRadPerDeg}, 0.5);
      EXPECT_GT(took_s, 0.5);
      EXPECT_LT(took_s, 2.5 + Recovery::kRecoveredForS) << side << ' ' << yaw_deg;
    }
  }
}

// Turning back moves such a robot sideways, so the turning centre must be brought back.
TEST(RecoveryDrive, BringsARobotBackSoonThatTurnsAboutAPointAheadOfIt) {
  const course::Course course = make_course({course::Line{1.8}});
  const Displacement disturbance{.left_m = 0.04, .yaw_rad = 15.0 * kRadPerDeg};
  const double known_s =
      recovered_after_s(course, disturbance, 0.5, nullptr, nullptr, {0.03, 0.03});
  const double unknown_s =
      recovered_after_s(course, disturbance, 0.5, nullptr, nullptr, {0.03, 0.0});
  EXPECT_GT(known_s, 0.5);
  EXPECT_LT(known_s, 2.5 + Recovery::kRecoveredForS);
  EXPECT_GT(unknown_s, known_s + 0.3);
}

TEST(RecoveryDrive, GoesSlowlyUntilItLooksBack) {
  double fastest_mps = 0.0;
  recovered_after_s(make_course({course::Line{1.8}}), {.left_m = 0.04, .yaw_rad = 0.4}, 0.5,
                    &fastest_mps);
  EXPECT_GT(fastest_mps, 0.0);
  EXPECT_LE(fastest_mps, 0.5 * 0.10);
}

TEST(RecoveryDrive, PushedBackItDrivesThatPartAgain) {
  const course::Course course = make_course({course::Line{1.2}});
  const course::Path path(course);
  Tracker tracker(Parameters{}, path, {.speed_mps = 0.1});
  LaggingRobot robot;
  for (int i = 0; i < 1200; ++i) robot.obey(tracker.update(robot.pose, robot.twist, kDt));
  const double before_m = tracker.update(robot.pose, robot.twist, kDt).progress_m;
  robot.pose.x_m -= 0.06;
  EXPECT_NEAR(tracker.update(robot.pose, robot.twist, kDt, true).progress_m, before_m - 0.06, 1e-6);
}

// The two lines run side by side in opposite directions, 6 cm apart: the nearest point of the path
// is on the wrong one.
TEST(RecoveryDrive, DoesNotJumpToAPartOfThePathThatLiesBeside) {
  const course::Course course =
      make_course({course::Line{0.8}, course::Arc{0.03, kPi}, course::Line{0.8}});
  double furthest_jump_m = 0.0;
  recovered_after_s(course, {.left_m = 0.05}, 0.5, nullptr, &furthest_jump_m);
  EXPECT_LT(furthest_jump_m, 0.11);
}

}  // namespace
}  // namespace tp100::control
