#include "control/corner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lagging_robot.h"

namespace tp100::control {
namespace {

constexpr double kRoomM = 0.5;

Corner corner_of(double angle_deg, double x_icr_m, double room_m = kRoomM) {
  const course::Path path(
      make_course({course::Line{0.5}, course::Pivot{angle_deg * kRadPerDeg}, course::Line{0.5}}));
  return {path.segments()[1], x_icr_m, room_m};
}

/// Largest distance from the path of a robot that turns about a point ahead of its reference point,
/// around sharp corners to both sides. `known`: the tracker knows this point.
double largest_distance_m(double x_icr_m, bool known) {
  const course::Course course = make_course(
      {course::Line{0.5}, course::Pivot{kPi / 2}, course::Line{0.4}, course::Pivot{-kPi / 2},
       course::Line{0.5}, course::Pivot{-2.0}, course::Line{0.4}});
  const course::Path path(course);
  Tracker tracker(Parameters{}, path,
                  {.speed_mps = course.speed_mps, .tracks = {.x_icr_m = known ? x_icr_m : 0.0}});
  LaggingRobot robot;
  robot.x_icr_m = x_icr_m;
  double largest_m = 0.0;
  for (int i = 0; i < 16000; ++i) {
    const Target& target = tracker.update(robot.pose, robot.twist, kDt);
    if (target.done) return largest_m;
    robot.obey(target);
    largest_m =
        std::max(largest_m, path.distance(robot.pose.x_m, robot.pose.y_m, target.progress_m - 0.3,
                                          target.progress_m + 0.3));
  }
  ADD_FAILURE() << "the course was not finished";
  return largest_m;
}

TEST(PivotProfile, SpeedsUpAndBrakesWithThePivotAcceleration) {
  const Parameters parameters;
  for (const double angle_rad : {-kPi / 2, kPi / 2}) {
    const course::Path path(
        make_course({course::Line{0.5}, course::Pivot{angle_rad}, course::Line{0.5}}));
    PivotProfile profile;
    profile.begin(path.segments()[1], 10.0);
    double before_radps = 0.0, fastest_radps = 0.0;
    for (int i = 0; i < 1000 && !profile.arrived(); ++i) {
      profile.update(parameters, kDt);
      const double radps = std::abs(profile.rate_radps());
      // The last few steps are too coarse for it.
      if (radps > 0.05) {
        EXPECT_LT(std::abs(radps - before_radps), 1.2 * parameters.pivot_acceleration_radps2 * kDt)
            << radps;
      }
      fastest_radps = std::max(fastest_radps, radps);
      before_radps = radps;
    }
    EXPECT_TRUE(profile.arrived());
    EXPECT_EQ(profile.yaw_rad(), angle_rad);
    EXPECT_NEAR(fastest_radps, parameters.pivot_rate_radps, 1e-9);
  }
}

TEST(Corner, OfARobotThatTurnsAboutItsReferencePointIsTheSpot) {
  const Corner corner = corner_of(90.0, 0.0);
  EXPECT_EQ(corner.radius_m(), 0.0);
  EXPECT_EQ(corner.stop_before_m(), 0.0);
  EXPECT_EQ(corner.speed_mps({.x_m = 0.5}, 0.6), 0.0);
}

TEST(Corner, ARobotThatIsCarriedOffIsBroughtToTheNextLine) {
  const Corner left = corner_of(90.0, 0.0), right = corner_of(-90.0, 0.0);
  for (const double yaw : {0.0, 0.8}) {
    for (const double aside : {-0.01, 0.0, 0.01}) {
      EXPECT_GT(left.speed_mps({.x_m = 0.49, .y_m = aside, .yaw_rad = yaw}, 0.6), 0.01);
      EXPECT_LT(left.speed_mps({.x_m = 0.51, .y_m = aside, .yaw_rad = yaw}, 0.6), -0.01);
      EXPECT_GT(right.speed_mps({.x_m = 0.49, .y_m = aside, .yaw_rad = -yaw}, 0.6), 0.01);
    }
  }
  EXPECT_GE(left.speed_mps({.x_m = 0.7}, 0.6), -0.05) << "the speed back must be low";
}

TEST(Corner, ARobotThatLooksAlongTheNextLineCannotBeBroughtToIt) {
  const Corner corner = corner_of(90.0, 0.0);
  EXPECT_NEAR(corner.speed_mps({.x_m = 0.51, .y_m = 0.1, .yaw_rad = kPi / 2}, 0.6), 0.0, 1e-9);
}

TEST(Corner, ThatIsNoneDrawsTheRobotNowhere) {
  EXPECT_EQ(Corner{}.speed_mps({.x_m = 0.4}, 0.6), 0.0);
}

TEST(Corner, IsATurnBetweenTwoLinesOnly) {
  const auto speed_mps = [](const course::Segment& before, const course::Segment& after) {
    const course::Path path(make_course({before, course::Pivot{kPi / 2}, after}));
    Tracker tracker(Parameters{}, path, {});
    const course::PathPoint& at = path.segments()[1].begin;
    tracker.resume(at.s_m, at.yaw_rad);
    const Pose short_of_it{at.x_m - 0.01 * std::cos(at.yaw_rad),
                           at.y_m - 0.01 * std::sin(at.yaw_rad), at.yaw_rad};
    return tracker.update(short_of_it, {}, kDt).speed_mps;
  };
  const course::Line line{0.5};
  const course::Arc arc{0.5, 1.0};
  EXPECT_GT(speed_mps(line, line), 0.01);
  EXPECT_EQ(speed_mps(line, arc), 0.0);
  EXPECT_EQ(speed_mps(arc, line), 0.0);
  EXPECT_EQ(speed_mps(arc, arc), 0.0);
}

TEST(Corner, ARightAngleLeavesThePathByLessThanAQuarterOfTheCentresDistance) {
  for (const double x_icr_m : {-0.045, -0.025, 0.025, 0.045}) {
    for (const double angle_deg : {-90.0, 90.0}) {
      const Corner corner = corner_of(angle_deg, x_icr_m);
      EXPECT_LE(corner.worst_m(), std::max(0.25 * std::abs(x_icr_m), 0.0051)) << x_icr_m;
      EXPECT_GE(corner.stop_before_m(), 0.0);
    }
  }
}

TEST(Corner, IsNeverWorseThanTheSpot) {
  for (int angle_deg = 5; angle_deg <= 180; angle_deg += 5) {
    for (const double x_icr_m : {-0.03, 0.004, 0.03}) {
      const double chord_m = 2.0 * std::abs(x_icr_m) * std::sin(angle_deg * kRadPerDeg / 2.0);
      const Corner corner = corner_of(angle_deg, x_icr_m);
      EXPECT_LE(corner.worst_m(), std::max(chord_m, 0.005) + 1e-9) << angle_deg << ' ' << x_icr_m;
      EXPECT_GE(corner.stop_before_m(), 0.0) << angle_deg << ' ' << x_icr_m;
    }
  }
}

TEST(Corner, BetweenShortLinesIsTheSpot) {
  EXPECT_GT(corner_of(90.0, 0.03).radius_m(), 0.0);
  EXPECT_EQ(corner_of(90.0, 0.03, 0.05).radius_m(), 0.0);
}

TEST(Corner, TheTrackerKeepsSuchARobotOnThePath) {
  for (const double x_icr_m : {-0.04, -0.02, 0.02, 0.04}) {
    EXPECT_GT(largest_distance_m(x_icr_m, false), 0.5 * std::abs(x_icr_m)) << x_icr_m;
    EXPECT_LT(largest_distance_m(x_icr_m, true), 0.012) << x_icr_m;
  }
}

TEST(Corner, AnArcIsDrivenWithTheHeadingThatTheTurningCentreNeeds) {
  const course::Course course = make_course({course::Line{0.2}, course::Arc{0.3, kPi}});
  const course::Path path(course);
  for (const double x_icr_m : {-0.03, 0.03}) {
    Tracker tracker(Parameters{}, path,
                    {.speed_mps = course.speed_mps, .tracks = {.x_icr_m = x_icr_m}});
    LaggingRobot robot;
    robot.x_icr_m = x_icr_m;
    double late_m = 0.0;
    for (int i = 0; i < 2200; ++i) {
      const Target& target = tracker.update(robot.pose, robot.twist, kDt);
      if (target.progress_m > 0.6) late_m = std::max(late_m, std::abs(target.cross_track_m));
      robot.obey(target);
    }
    EXPECT_LT(late_m, 0.002) << x_icr_m;
  }
}

}  // namespace
}  // namespace tp100::control
