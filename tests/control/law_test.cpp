#include "control/law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/arithmetic.h"
#include "lagging_robot.h"
#include "support/sequence.h"

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

/// A robot somewhere beside a curved path. Every error differs from 0.
PathErrors any_errors(test::Sequence& any, double size) {
  PathErrors errors;
  errors.cross_track_m = size * any.between(-0.05, 0.05);
  errors.heading_rad = size * any.between(-0.6, 0.6);
  errors.yaw_rate_radps = any.between(-0.5, 0.5);
  errors.speed_mps = any.between(0.005, 0.25);
  errors.curvature_1pm = any.between(-4.0, 4.0);
  errors.crab_rad = any.between(-0.1, 0.1);
  errors.ahead.along_m = any.between(-0.05, 0.15);
  errors.ahead.left_m = any.between(-0.04, 0.04);
  errors.ahead.yaw_rad = any.between(-0.3, 0.3);
  errors.ahead.curvature_1pm = any.between(-4.0, 4.0);
  return errors;
}

/// Compares `law` at many errors with the turn rate that the robot's yaw loop makes of its output
/// according to `turn_radps`. Where the direction of motion is at its bound, only that is compared.
template <class Turn>
void expect_turn(const Law& law, const Parameters& parameters, double yaw_kp, Turn turn_radps) {
  test::Sequence any(3);
  int free = 0;
  for (int i = 0; i < 2000; ++i) {
    const PathErrors errors = any_errors(any, i % 4 == 0 ? 3.0 : 0.3);
    const LawOutput steering = law.steer(errors);
    const double wish = turn_radps(errors);
    const double unbounded =
        errors.heading_rad + (wish - steering.yaw_rate_radps) / yaw_kp + errors.crab_rad;
    const double bounded = std::clamp(unbounded - errors.ahead.yaw_rad,
                                      -parameters.max_approach_rad, parameters.max_approach_rad);
    ASSERT_NEAR(steering.yaw_rad + errors.crab_rad, errors.ahead.yaw_rad + bounded, 1e-9) << i;
    if (bounded == unbounded - errors.ahead.yaw_rad) ++free;
  }
  EXPECT_GT(free, 500);
}

TEST_P(EveryLaw, IsMirroredLeftAndRightAndAsksForNothingOnThePath) {
  const auto law = make_law(parameters(), {});
  test::Sequence any(4);
  for (int i = 0; i < 200; ++i) {
    const PathErrors left = any_errors(any, 1.0);
    PathErrors right = left;
    for (double* value :
         {&right.cross_track_m, &right.heading_rad, &right.yaw_rate_radps, &right.curvature_1pm,
          &right.crab_rad, &right.ahead.left_m, &right.ahead.yaw_rad, &right.ahead.curvature_1pm})
      *value = -*value;
    EXPECT_NEAR(law->steer(left).yaw_rad, -law->steer(right).yaw_rad, 1e-12);
    EXPECT_NEAR(law->steer(left).yaw_rate_radps, -law->steer(right).yaw_rate_radps, 1e-12);
  }
  const LawOutput on_the_path =
      law->steer({.speed_mps = 0.1, .ahead = {.along_m = law->look_ahead_m(0.1)}});
  EXPECT_NEAR(on_the_path.yaw_rad, 0.0, 1e-12);
  EXPECT_NEAR(on_the_path.yaw_rate_radps, 0.0, 1e-12);
}

TEST_P(EveryLaw, StaysBoundedForAnyErrors) {
  const auto law = make_law(parameters(), {});
  test::Sequence any(7);
  for (int i = 0; i < 3000; ++i) {
    PathErrors errors = any_errors(any, std::pow(10.0, any.between(-2.0, 8.0)));
    errors.heading_rad = any.between(-kPi, kPi);
    errors.yaw_rate_radps *= any.between(0.0, 20.0);
    errors.speed_mps *= any.chance(0.1) ? 0.0 : any.between(0.0, 20.0);
    errors.ahead.along_m = law->look_ahead_m(errors.speed_mps);
    ASSERT_GE(errors.ahead.along_m, 0.0);
    // The path does not turn before a point that is not ahead.
    if (errors.ahead.along_m == 0.0) errors.ahead.yaw_rad = 0.0;
    const LawOutput steering = law->steer(errors);
    ASSERT_LE(std::abs(steering.yaw_rad + errors.crab_rad - errors.ahead.yaw_rad),
              Parameters{}.max_approach_rad + 1e-9)
        << i;
    ASSERT_TRUE(std::isfinite(steering.yaw_rate_radps)) << i;
  }
}

TEST_P(EveryLaw, ConvergesFromAnySideWithoutOvershoot) {
  const course::Path path(make_course({course::Line{1.5}}));
  for (const double left_m : {-0.08, -0.02, 0.0, 0.02, 0.08}) {
    for (const double yaw_deg : {-60.0, -15.0, 0.0, 15.0, 60.0}) {
      SCOPED_TRACE(testing::Message() << left_m << " m, " << yaw_deg << " deg");
      Tracker tracker(parameters(), path, {});
      LaggingRobot robot;
      robot.pose = {.y_m = left_m, .yaw_rad = yaw_deg * kRadPerDeg};
      double late_m = 0.0, overshoot_m = 0.0;
      bool done = false;
      for (int i = 0; i < 9000 && !done; ++i) {
        const Target& target = tracker.update(robot.pose, robot.twist, kDt);
        robot.obey(target);
        done = target.done;
        if (target.progress_m > 0.7) late_m = std::max(late_m, std::abs(robot.pose.y_m));
        overshoot_m = std::max(overshoot_m, std::copysign(1.0, -left_m) * robot.pose.y_m);
      }
      EXPECT_TRUE(done);
      EXPECT_LT(late_m, 0.003);
      if (yaw_deg == 0.0) {
        EXPECT_LT(overshoot_m, 0.1 * std::abs(left_m) + 0.001);
      }
    }
  }
}

TEST_P(EveryLaw, TakesOtherParametersDuringADrive) {
  Parameters changed = parameters();
  changed.preview_s = 0.11;
  changed.max_approach_rad = 0.3;
  changed.cross_track_gain_1ps = 2.2;
  changed.pursuit_min_m = 0.07;
  const auto retuned = make_law(parameters(), {}), anew = make_law(changed, {});
  retuned->retune(changed);
  for (const double speed : {0.01, 0.1, 0.3})
    EXPECT_EQ(retuned->look_ahead_m(speed), anew->look_ahead_m(speed));
  if (GetParam().value == LawName::kLqr) return;  // its gains are solved before a drive
  test::Sequence any(5);
  for (int i = 0; i < 50; ++i) {
    const PathErrors errors = any_errors(any, 1.0);
    EXPECT_EQ(retuned->steer(errors).yaw_rad, anew->steer(errors).yaw_rad);
  }
}

// Hoffmann and others 2007: the tangent minus atan(k e / (v + v_s)), here minus the slip angle too.
TEST(Stanley, AimsAtThePathByItsLawAndTurnsAsFastAsThatAimDoes) {
  const Parameters p;
  const auto law = make_law(p, {});
  EXPECT_EQ(law->look_ahead_m(0.2), 0.2 * p.preview_s);
  const auto approach = [&](double cross_track_m, double speed_mps) {
    return std::clamp(
        std::atan(p.cross_track_gain_1ps * cross_track_m / (speed_mps + p.soft_speed_mps)),
        -p.max_approach_rad, p.max_approach_rad);
  };
  test::Sequence any(6);
  for (int i = 0; i < 500; ++i) {
    const PathErrors e = any_errors(any, i % 4 == 0 ? 3.0 : 1.0);
    const LawOutput steering = law->steer(e);
    EXPECT_NEAR(steering.yaw_rad,
                e.ahead.yaw_rad - approach(e.cross_track_m, e.speed_mps) - e.crab_rad, 1e-12);
    const double step_m = e.speed_mps * std::sin(e.heading_rad + e.crab_rad) * 1e-6;
    const double falls_radps = (approach(e.cross_track_m + step_m, e.speed_mps) -
                                approach(e.cross_track_m - step_m, e.speed_mps)) /
                               2e-6;
    EXPECT_NEAR(steering.yaw_rate_radps, e.ahead.curvature_1pm * e.speed_mps - falls_radps, 1e-6);
  }
}

// Coulter 1992: the circle through the robot, along its direction of motion, that meets a point at
// distance L and bearing a has the curvature 2 sin(a) / L.
TEST(PurePursuit, TurnsOnTheCircleThroughThePointAhead) {
  Parameters p;
  p.law = LawName::kPurePursuit;
  const TrackLimits limits{.yaw_kp = 3.4};
  const auto law = make_law(p, limits);
  EXPECT_EQ(law->look_ahead_m(0.01), p.pursuit_min_m);
  EXPECT_EQ(law->look_ahead_m(0.1), 0.1 * p.pursuit_s);
  EXPECT_EQ(law->look_ahead_m(5.0), p.pursuit_max_m);
  expect_turn(*law, p, limits.yaw_kp, [&](const PathErrors& e) {
    const double left_m = e.ahead.left_m - e.cross_track_m;
    const double bearing =
        wrap_angle(std::atan2(left_m, e.ahead.along_m) - e.heading_rad - e.crab_rad);
    const double distance = std::hypot(left_m, e.ahead.along_m);
    // A point that is too near counts as less far aside, one behind the robot as abeam.
    const double radius = std::max(distance, p.pursuit_min_m);
    const double aside =
        std::abs(bearing) > kPi / 2 ? std::copysign(radius, bearing) : distance * std::sin(bearing);
    return 2.0 * aside / (radius * radius) * e.speed_mps;
  });
  const PathErrors arc{.speed_mps = 0.1, .curvature_1pm = 2.0, .ahead = {.along_m = 0.08}};
  EXPECT_EQ(law->steer(arc).yaw_rate_radps, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw, testing::ValuesIn(kLawNames), name_of);

}  // namespace
}  // namespace tp100::control
