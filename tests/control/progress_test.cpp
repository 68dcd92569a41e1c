#include "control/progress.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lagging_robot.h"

namespace tp100::control {
namespace {

TEST(Progress, ARobotThatIsPushedOverAJointIsFoundOnTheOtherSegment) {
  constexpr double kRadiusM = 0.1, kJointM = kRadiusM * kPi / 2;
  const course::Path path(make_course({course::Arc{kRadiusM, kPi / 2}, course::Line{0.3}}));
  Progress progress(path);
  progress.resume(kJointM + 0.02, kPi / 2);
  ASSERT_NEAR(progress.here().s_m, kJointM + 0.02, 1e-9);
  constexpr double kAngleRad = 0.9;
  progress.reproject(kRadiusM * std::sin(kAngleRad), kRadiusM * (1.0 - std::cos(kAngleRad)), 0.15);
  EXPECT_NEAR(progress.here().s_m, kRadiusM * kAngleRad, 1e-9) << "back to the arc";
  progress.reproject(kRadiusM, kRadiusM + 0.03, 0.15);
  EXPECT_NEAR(progress.here().s_m, kJointM + 0.03, 1e-9) << "on to the line";
}

}  // namespace
}  // namespace tp100::control
