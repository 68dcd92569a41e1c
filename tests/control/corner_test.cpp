#include "control/corner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lagging_robot.h"

namespace tp100::control {
namespace {

constexpr double kRoomM = 0.5;

/// A line, a turn on the spot and a line, away from the axes.
course::Path path_with(double angle_rad) {
  course::Course course =
      make_course({course::Line{0.5}, course::Pivot{angle_rad}, course::Line{0.5}});
  course.start = {.x_m = 0.1, .y_m = -0.3, .yaw_rad = 0.5};
  return course::Path(course);
}

Corner corner_of(double angle_deg, double x_icr_m, double room_m = kRoomM) {
  return {path_with(angle_deg * kRadPerDeg).segments()[1], x_icr_m, room_m};
}

TEST(PivotProfile, SpeedsUpAndBrakesWithThePivotAccelerationUpToItsLimits) {
  const Parameters parameters;
  for (const double max_radps : {10.0, 0.35}) {
    for (const double angle_rad : {-kPi / 2, kPi / 2}) {
      const course::Path path = path_with(angle_rad);
      const course::PathSegment& turn = path.segments()[1];
      const double limit = std::min(parameters.pivot_rate_radps, max_radps);
      PivotProfile profile;
      profile.begin(turn, max_radps);
      double radps = 0.0, fastest_radps = 0.0, yaw_rad = turn.begin.yaw_rad;
      int steps = 0;
      for (; steps < 1000 && !profile.arrived(); ++steps) {
        const double before_radps = radps;
        profile.update(parameters, kDt);
        radps = std::abs(profile.rate_radps());
        fastest_radps = std::max(fastest_radps, radps);
        yaw_rad += profile.rate_radps() * kDt;
        if (radps < 0.05) continue;  // the last few steps are too coarse for it
        EXPECT_NEAR(profile.yaw_rad(), yaw_rad, 1e-12);
        EXPECT_LT(std::abs(radps - before_radps), 1.2 * parameters.pivot_acceleration_radps2 * kDt);
      }
      EXPECT_EQ(profile.rate_radps(), 0.0);
      EXPECT_EQ(profile.yaw_rad(), turn.end.yaw_rad);
      EXPECT_NEAR(fastest_radps, limit, 1e-9);
      // As long as at the limit, plus one ramp.
      EXPECT_NEAR(steps * kDt,
                  std::abs(angle_rad) / limit + limit / parameters.pivot_acceleration_radps2, 0.1);
    }
  }
}

TEST(PivotProfile, GoesOnFromTheYawThatTheRobotHas) {
  const course::Path path = path_with(1.0);
  PivotProfile profile;
  profile.begin(path.segments()[1], 10.0);
  profile.begin_at(0.8 + 2.0 * kPi);
  EXPECT_NEAR(profile.yaw_rad(), 0.8, 1e-12) << "on the path's branch";
  for (int i = 0; i < 40; ++i) profile.update({}, kDt);
  EXPECT_GT(profile.rate_radps(), 0.2);
  profile.halt_at(0.9 - 2.0 * kPi);
  EXPECT_NEAR(profile.yaw_rad(), 0.9, 1e-12);
  EXPECT_EQ(profile.rate_radps(), 0.0);
  profile.update({}, kDt);
  EXPECT_NEAR(profile.rate_radps(), Parameters{}.pivot_acceleration_radps2 * kDt, 1e-12);
}

/// A place beside the corner of path_with(), in the frame of its first line.
Pose beside_corner(double along_m, double left_m, double turned_rad) {
  const double c = std::cos(0.5), s = std::sin(0.5);
  return {.x_m = 0.1 + c * (0.5 + along_m) - s * left_m,
          .y_m = -0.3 + s * (0.5 + along_m) + c * left_m,
          .yaw_rad = 0.5 + turned_rad};
}

TEST(Corner, ARobotThatIsCarriedOffIsBroughtToTheNextLine) {
  const Corner left = corner_of(90.0, 0.0), right = corner_of(-90.0, 0.0);
  for (const double yaw : {0.0, 0.8, 0.8 + 2.0 * kPi}) {
    for (const double aside : {-0.01, 0.0, 0.01}) {
      EXPECT_GT(left.speed_mps(beside_corner(-0.01, aside, yaw), 0.6), 0.01);
      EXPECT_LT(left.speed_mps(beside_corner(0.01, aside, yaw), 0.6), -0.01);
      EXPECT_GT(right.speed_mps(beside_corner(-0.01, aside, -yaw), 0.6), 0.01);
    }
  }
  EXPECT_GE(left.speed_mps(beside_corner(0.2, 0.0, 0.0), 0.6), -0.05) << "slowly";
  // Along the next line it cannot be brought to it.
  EXPECT_NEAR(left.speed_mps(beside_corner(0.01, 0.1, kPi / 2), 0.6), 0.0, 1e-9);
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

/// A perfect robot, whose turning centre lies `x_icr_m` ahead, in the turn.
struct Guided {
  double worst_m = 0.0;  ///< greatest distance from the path
  double left_m = 0.0;   ///< distance from the next line at the end
  double reach_m = 0.0;  ///< from the corner, where the turn begins and where it ends
};
Guided guided(double angle_deg, double x_icr_m, const Corner& corner) {
  const course::Path path = path_with(angle_deg * kRadPerDeg);
  const double before_m = corner.stop_before_m();
  Pose pose = beside_corner(-before_m, 0.0, 0.0);
  Guided result;
  const double rate = std::copysign(0.5, angle_deg);
  const int steps = static_cast<int>(std::abs(angle_deg) * kRadPerDeg / 0.5 / 1e-3);
  for (int i = 0; i < steps; ++i) {
    const double speed = corner.speed_mps(pose, rate);
    pose.yaw_rad += rate * 0.5e-3;
    const double c = std::cos(pose.yaw_rad), s = std::sin(pose.yaw_rad);
    pose.x_m += (c * speed + s * x_icr_m * rate) * 1e-3;
    pose.y_m += (s * speed - c * x_icr_m * rate) * 1e-3;
    pose.yaw_rad += rate * 0.5e-3;
    result.worst_m = std::max(result.worst_m, path.distance(pose.x_m, pose.y_m, 0.0, 1.0));
  }
  const course::PathPoint& next = path.segments()[2].begin;
  const double dx = pose.x_m - next.x_m, dy = pose.y_m - next.y_m;
  result.left_m = -std::sin(next.yaw_rad) * dx + std::cos(next.yaw_rad) * dy;
  result.reach_m = std::max(before_m, std::hypot(dx, dy));
  return result;
}

TEST(Corner, GuidesARobotAroundNearerToThePathThanATurnOnTheSpot) {
  for (int angle_deg = -180; angle_deg <= 180; angle_deg += 10) {
    for (const double x_icr_m : {-0.045, -0.025, 0.0, 0.004, 0.025, 0.045}) {
      SCOPED_TRACE(testing::Message() << angle_deg << " deg, " << x_icr_m << " m");
      const Corner corner = corner_of(angle_deg, x_icr_m);
      ASSERT_GE(corner.stop_before_m(), 0.0);
      if (std::abs(angle_deg) < 15 || std::abs(angle_deg) > 165 || x_icr_m == 0.0) {
        EXPECT_EQ(corner.radius_m(), 0.0) << "nearly straight on or back, or about the point";
        EXPECT_EQ(corner.stop_before_m(), 0.0);
      }
      if (std::abs(angle_deg) == 90 && std::abs(x_icr_m) >= 0.025) {
        EXPECT_GT(corner.radius_m(), 0.0) << "wherever the turning centre is";
      }
      // Around a sharper one the robot cannot quite follow.
      if (corner.radius_m() == 0.0 || std::abs(angle_deg) > 140) continue;
      const Guided robot = guided(angle_deg, x_icr_m, corner);
      const double chord_m =
          2.0 * std::abs(x_icr_m) * std::sin(std::abs(angle_deg) * kRadPerDeg / 2.0);
      EXPECT_LE(robot.worst_m, std::max(chord_m, 0.0052)) << "worse than on the spot";
      if (std::abs(angle_deg) == 90) {
        EXPECT_LE(robot.worst_m, std::max(0.25 * std::abs(x_icr_m), 0.0052));
      }
      EXPECT_NEAR(robot.left_m, 0.0, 1e-3);
      EXPECT_LE(robot.reach_m, corner.reach_m() + 1e-3);
    }
  }
}

TEST(Corner, BetweenShortLinesIsNarrowerOrTheSpot) {
  const double reach_m = corner_of(90.0, 0.03).reach_m();
  EXPECT_GT(corner_of(90.0, 0.03).radius_m(), 0.0);
  EXPECT_EQ(corner_of(90.0, 0.03, reach_m).reach_m(), reach_m);
  EXPECT_LT(corner_of(90.0, 0.03, reach_m - 1e-6).reach_m(), reach_m);
  EXPECT_EQ(corner_of(90.0, 0.03, 0.05).radius_m(), 0.0);
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
