#include <gtest/gtest.h>

#include <cmath>

#include "control/tracker.h"
#include "lagging_robot.h"

namespace tp100::control {
namespace {

TEST(DisturbanceDetector, ATurnThatTheTracksDoNotMakeIsNoticedWithinFourSteps) {
  DisturbanceDetector disturbance{Parameters{}};
  disturbance.restart(0);
  int steps = 0;
  while (!disturbance.update({.gyro_radps = 0.9, .tracks_radps = 0.1}, kDt)) ASSERT_LT(++steps, 4);
}

TEST(DisturbanceDetector, WhatTheTracksMakeThemselvesIsNone) {
  DisturbanceDetector disturbance{Parameters{}};
  for (int i = 0; i < 200; ++i)
    EXPECT_FALSE(disturbance.update({.gyro_radps = 1.2, .tracks_radps = 1.5}, kDt));
}

TEST(DisturbanceDetector, OneNoisySampleIsNone) {
  DisturbanceDetector disturbance{Parameters{}};
  for (int i = 0; i < 200; ++i)
    EXPECT_FALSE(disturbance.update({.gyro_radps = i % 3 == 0 ? 2.0 : 0.0}, kDt));
}

TEST(DisturbanceDetector, TheCameraThatContradictsIsOneOnce) {
  DisturbanceDetector disturbance{Parameters{}};
  disturbance.restart(3);
  EXPECT_FALSE(disturbance.update({.contradictions = 3}, kDt));
  EXPECT_TRUE(disturbance.update({.contradictions = 4}, kDt));
  EXPECT_FALSE(disturbance.update({.contradictions = 4}, kDt));
}

TEST(Recovery, EndsAfterHalfASecondInside) {
  Recovery recovery;
  recovery.begin();
  double inside_s = 0.0;
  while (recovery.active()) {
    recovery.update(0.005, 0.01, kDt);
    inside_s += kDt;
    ASSERT_LT(inside_s, 1.0);
  }
  EXPECT_NEAR(inside_s, Recovery::kRecoveredForS, 2 * kDt);
}

TEST(Recovery, LeavingTheBandStartsTheTimeAnew) {
  Recovery recovery;
  recovery.begin();
  for (int i = 0; i < 90; ++i) recovery.update(0.005, 0.01, kDt);
  recovery.update(0.011, 0.0, kDt);
  for (int i = 0; i < 90; ++i) recovery.update(0.005, 0.01, kDt);
  recovery.update(0.0, 3.1 * kRadPerDeg, kDt);
  for (int i = 0; i < 90; ++i) recovery.update(0.005, 0.01, kDt);
  EXPECT_TRUE(recovery.active());
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
