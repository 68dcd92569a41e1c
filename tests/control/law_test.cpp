#include "control/law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>

#include "lagging_robot.h"

namespace tp100::control {
namespace {

class EveryLaw : public testing::TestWithParam<EnumName<LawName>> {
 protected:
  Parameters parameters() const {
    Parameters parameters;
    parameters.law = GetParam().value;
    return parameters;
  }
};

std::string name_of(const testing::TestParamInfo<EnumName<LawName>>& param) {
  std::string name = param.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

TEST_P(EveryLaw, OnAStraightPathAsksForNothingWhenThereIsNoError) {
  const auto law = make_law(parameters(), {});
  const LawOutput steering =
      law->steer({.speed_mps = 0.1, .ahead = {.along_m = law->look_ahead_m(0.1)}});
  EXPECT_NEAR(steering.yaw_rad, 0.0, 1e-12);
  EXPECT_NEAR(steering.yaw_rate_radps, 0.0, 1e-12);
}

TEST_P(EveryLaw, IsMirroredLeftAndRight) {
  const auto law = make_law(parameters(), {});
  const PathErrors left{
      .cross_track_m = 0.03,
      .heading_rad = -0.2,
      .yaw_rate_radps = 0.1,
      .speed_mps = 0.1,
      .curvature_1pm = 2.0,
      .ahead = {.along_m = 0.05, .left_m = 0.0025, .yaw_rad = 0.1, .curvature_1pm = 2.0}};
  const PathErrors right{
      .cross_track_m = -0.03,
      .heading_rad = 0.2,
      .yaw_rate_radps = -0.1,
      .speed_mps = 0.1,
      .curvature_1pm = -2.0,
      .ahead = {.along_m = 0.05, .left_m = -0.0025, .yaw_rad = -0.1, .curvature_1pm = -2.0}};
  EXPECT_NEAR(law->steer(left).yaw_rad, -law->steer(right).yaw_rad, 1e-12);
  EXPECT_NEAR(law->steer(left).yaw_rate_radps, -law->steer(right).yaw_rate_radps, 1e-12);
}

TEST(Stanley, ItsDesiredYawTurnsAsFastAsItsAngleOfApproachFalls) {
  Parameters parameters;
  parameters.law = LawName::kStanley;
  const auto law = make_law(parameters, {});
  PathErrors errors{.cross_track_m = 0.01, .heading_rad = -0.2, .speed_mps = 0.1};
  constexpr double kShortS = 1e-6;
  const LawOutput before = law->steer(errors);
  errors.cross_track_m += errors.speed_mps * std::sin(errors.heading_rad) * kShortS;
  const LawOutput after = law->steer(errors);
  EXPECT_GT(before.yaw_rate_radps, 0.1);
  EXPECT_NEAR(before.yaw_rate_radps, (after.yaw_rad - before.yaw_rad) / kShortS, 1e-4);
}

TEST(Lqr, SteersByTheTurnThatIsNotThePathsOwn) {
  Parameters parameters;
  parameters.law = LawName::kLqr;
  const auto law = make_law(parameters, {});
  // The robot follows an arc of the path exactly, so there is nothing to correct.
  const PathErrors errors{.yaw_rate_radps = 0.2,
                          .speed_mps = 0.1,
                          .curvature_1pm = 2.0,
                          .ahead = {.curvature_1pm = 2.0}};
  EXPECT_NEAR(law->steer(errors).yaw_rad, 0.0, 1e-12);
}

TEST_P(EveryLaw, StaysBoundedForAnyErrors) {
  const Parameters values = parameters();
  const auto law = make_law(values, {});
  for (const double e : {-1e6, -0.3, 0.0, 0.01, 5.0, 1e6}) {
    for (const double heading : {-kPi, -1.5, 0.0, 0.4, kPi}) {
      for (const double speed : {0.0, 0.02, 0.1, 1.0, 5.0}) {
        for (const double curvature : {-20.0, 0.0, 3.0}) {
          for (const auto& [rate, crab] : std::initializer_list<std::pair<double, double>>{
                   {-10.0, 0.1}, {0.0, 0.0}, {0.0, -0.3}, {10.0, 0.3}}) {
            const double along = law->look_ahead_m(speed);
            ASSERT_TRUE(std::isfinite(along));
            ASSERT_GE(along, 0.0);
            const LawOutput steering =
                law->steer({.cross_track_m = e,
                            .heading_rad = heading,
                            .yaw_rate_radps = rate,
                            .speed_mps = speed,
                            .curvature_1pm = curvature,
                            .crab_rad = crab,
                            .ahead = {.along_m = along, .curvature_1pm = curvature}});
            ASSERT_LE(std::abs(steering.yaw_rad + crab), values.max_approach_rad + 1e-9)
                << e << ' ' << heading << ' ' << speed << ' ' << rate << ' ' << crab;
            ASSERT_TRUE(std::isfinite(steering.yaw_rate_radps));
          }
        }
      }
    }
  }
}

struct Driven {
  bool done = false;
  double late_m = 0.0;  ///< largest distance from the path after `settle_m` of progress
  double overshoot_m = 0.0;
  double max_m = 0.0;
};

Driven drive_from(const Parameters& parameters, const course::Course& course, double left_m,
                  double yaw_rad, double settle_m) {
  const course::Path path(course);
  Tracker tracker(parameters, path, {.speed_mps = course.speed_mps});
  LaggingRobot robot;
  robot.pose.y_m = left_m;
  robot.pose.yaw_rad = yaw_rad;
  Driven result;
  const int steps = static_cast<int>(3.0 * tracker.nominal_duration_s() / kDt);
  for (int i = 0; i < steps; ++i) {
    const Target& target = tracker.update(robot.pose, robot.twist, kDt);
    if (target.done) {
      result.done = true;
      break;
    }
    robot.obey(target);
    const double off_m = path.distance(robot.pose.x_m, robot.pose.y_m, 0.0, path.length_m());
    result.max_m = std::max(result.max_m, off_m);
    if (target.progress_m > settle_m) result.late_m = std::max(result.late_m, off_m);
    if (left_m != 0.0)
      result.overshoot_m =
          std::max(result.overshoot_m, -std::copysign(1.0, left_m) * target.cross_track_m);
  }
  return result;
}

TEST_P(EveryLaw, ConvergesFromAnySide) {
  const course::Course line = make_course({course::Line{1.5}});
  for (const double left_m : {-0.08, -0.02, 0.0, 0.02, 0.08}) {
    for (const double yaw_deg : {-60.0, -15.0, 0.0, 15.0, 60.0}) {
      SCOPED_TRACE(testing::Message() << left_m << " m, " << yaw_deg << " deg");
      const Driven result = drive_from(parameters(), line, left_m, yaw_deg * kRadPerDeg, 0.7);
      EXPECT_TRUE(result.done);
      EXPECT_LT(result.late_m, 0.003);
      if (yaw_deg == 0.0) {
        EXPECT_LT(result.overshoot_m, 0.1 * std::abs(left_m) + 0.001);
      }
    }
  }
}

TEST_P(EveryLaw, ConvergesOnArcsToo) {
  for (const double angle : {kPi, -kPi}) {
    const Driven result =
        drive_from(parameters(), make_course({course::Arc{0.35, angle}}), 0.03, 0.1, 0.5);
    EXPECT_TRUE(result.done);
    EXPECT_LT(result.late_m, 0.004);
  }
}

// Curves begin and end without a transition; the jump of curvature is the only corner that these
// courses have.
TEST_P(EveryLaw, CutsCornersByLessThanFourMillimetres) {
  for (const double radius : {0.35, 0.2}) {
    const Driven result =
        drive_from(parameters(),
                   make_course({course::Line{0.4}, course::Arc{radius, kPi / 2}, course::Line{0.2},
                                course::Arc{radius, -kPi / 2}, course::Line{0.4}}),
                   0.0, 0.0, 0.0);
    EXPECT_TRUE(result.done);
    EXPECT_LT(result.max_m, 0.004) << radius;
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw, testing::ValuesIn(kLawNames), name_of);

// In continuous time without lag the equation has this solution: k_e = sqrt(q_e / r), k_psi =
// sqrt((q_psi + 2 v sqrt(q_e r)) / r).
TEST(Lqr, SolvesTheRiccatiEquation) {
  Parameters parameters;
  parameters.preview_s = 0.0;  // the shortest lag that the solver accepts, 10 ms
  const double v = 0.1, r = 1.0 / std::pow(parameters.lqr_turn_radps, 2);
  const double q_e = 1.0 / std::pow(parameters.lqr_cross_track_m, 2);
  const double q_psi = 1.0 / std::pow(parameters.lqr_heading_rad, 2);
  const Lqr::Gains gains = Lqr(parameters, {}).gains(v);
  const double k_e = std::sqrt(q_e / r);
  const double k_psi = std::sqrt((q_psi + 2.0 * v * std::sqrt(q_e * r)) / r);
  EXPECT_NEAR(gains.cross_track, k_e, 0.06 * k_e);
  EXPECT_NEAR(gains.heading, k_psi, 0.06 * k_psi);
}

TEST(Lqr, TurnsHarderAgainstAHeadingErrorTheFasterTheRobotIs) {
  const Lqr law(Parameters{}, {});
  double slower = 0.0;
  for (const double v : {0.01, 0.03, 0.1, 0.2, 0.4, 0.6, 0.8}) {
    const double heading = law.gains(v).heading;
    EXPECT_GT(heading, slower) << v;
    slower = heading;
  }
}

TEST(Lqr, ClosesTheLoopStablyAtEverySpeedItMayMeet) {
  const Lqr law(Parameters{}, {});
  for (const double v : {0.005, 0.02, 0.1, 0.3, 0.8, 2.0}) {
    const Lqr::Gains k = law.gains(v);
    // Characteristic polynomial of the lagging plant: T s^3 + (1 + k_w) s^2 + k_psi s + k_e v.
    const double lag_s = Parameters{}.preview_s;
    EXPECT_GT(k.cross_track, 0.0);
    EXPECT_GT(k.heading, 0.0);
    EXPECT_GT((1.0 + k.rate) * k.heading, lag_s * k.cross_track * v) << "Routh-Hurwitz, " << v;
  }
}

}  // namespace
}  // namespace tp100::control
