#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

#include "core/arithmetic.h"
#include "core/error.h"
#include "model/climb_curve.h"

namespace tp100::model {
namespace {

ClimbGeometry with_com_height(double height_m) {
  ClimbGeometry geometry;
  geometry.com_height_m = height_m;
  return geometry;
}

TEST(ClimbLimit, FallsWithTheHeightOfTheCentreOfMassAsPublished) {
  // The published values are the smallest heights, in steps of 0.2 mm, that cannot be climbed.
  EXPECT_NEAR(climb_limit_m(with_com_height(0.018)), 0.0446, 2e-4);
  EXPECT_NEAR(climb_limit_m(with_com_height(0.022)), 0.0404, 2e-4);
  EXPECT_NEAR(climb_limit_m(with_com_height(0.026)), 0.0366, 2e-4);
  EXPECT_NEAR(climb_limit_m(with_com_height(0.030)), 0.0336, 2e-4);
}

TEST(ClimbLimit, ACentreOfMassFurtherForwardRestoresTheStepOfThePaper) {
  ClimbGeometry geometry = with_com_height(0.030);
  EXPECT_LT(climb_limit_m(geometry), 0.037);
  geometry.com_forward_m += 0.005;
  EXPECT_NEAR(climb_limit_m(geometry), 0.037, 5e-4);
}

TEST(ClimbLimit, IsWhereTheTipAngleCeasesToExist) {
  for (const double height : {0.012, 0.018, 0.022, 0.030, 0.045}) {
    const ClimbGeometry geometry = with_com_height(height);
    const double limit = climb_limit_m(geometry);
    EXPECT_TRUE(tip_angle_rad(geometry, limit - 1e-6)) << height;
    EXPECT_FALSE(tip_angle_rad(geometry, limit + 1e-6)) << height;
  }
}

TEST(ClimbLimit, IsTheHighestStepOfACoarseSearchOverAllAngles) {
  for (const auto& [com_m, forward_m] : {std::pair{0.004, 0.0665}, std::pair{0.022, 0.0665},
                                         std::pair{0.09, 0.0665}, std::pair{0.02, 0.01}}) {
    ClimbGeometry g = with_com_height(com_m);
    g.com_forward_m = forward_m;
    double best = 0.0;
    // Up to where the edge leaves the flat of the track.
    const double last = std::atan2(g.com_forward_m, g.com_height_m);
    for (double angle = 0.0; angle < last; angle += 1e-4) {
      const double height = g.wheel_radius_m * (1 - std::cos(angle)) +
                            g.com_forward_m * std::sin(angle) -
                            g.com_height_m * std::sin(angle) * std::tan(angle);
      best = std::max(best, height);
      if (best > height) continue;
      const auto tip = tip_angle_rad(g, height);
      ASSERT_TRUE(tip.has_value());
      ASSERT_NEAR(*tip, angle, 1e-3) << "where the centre of mass passes the edge";
    }
    EXPECT_NEAR(climb_limit_m(g), best, 1e-5) << com_m;
  }
}

TEST(TipAngle, OfThePapersStepIsFortyDegrees) {
  const auto angle = tip_angle_rad({}, 0.037);
  ASSERT_TRUE(angle);
  EXPECT_NEAR(*angle * kDegPerRad, 40.1, 0.05);
}

TEST(CheckClimb, NamesTheLimitOfAStepThatIsTooHigh) {
  try {
    check_climb(with_com_height(0.030), {0.037, 0.1});
    FAIL();
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("37.0 mm"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("33.4 mm"), std::string::npos) << error.what();
  }
}

TEST(CheckClimb, RefusesWhatIsNoGeometry) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(check_climb({}, {}));
  EXPECT_NO_THROW(check_climb({}, {0.037, std::numeric_limits<double>::infinity()}));
  EXPECT_THROW(check_climb({}, {nan, 0.1}), SetupError);
  EXPECT_THROW(check_climb({}, {0.037, nan}), SetupError);
  EXPECT_THROW(check_climb({}, {0.037, 0.0}), SetupError);
  EXPECT_THROW(check_climb({}, {-0.01, 0.1}), SetupError);
  ClimbGeometry geometry;
  geometry.com_forward_m = 0.140;
  EXPECT_THROW(check_climb(geometry, {}), SetupError);
  EXPECT_THROW(ClimbCurve({}, {0.2, 0.1}, RiserForm::kTrackHolds), SetupError);
}

TEST(ClimbCurve, IsFiniteEvenWhereTheRearCannotReachTheGround) {
  const ClimbGeometry small_wheels{.wheel_radius_m = 0.012, .com_height_m = 0.015};
  const ClimbCurve curve(small_wheels, {0.036, 0.1}, RiserForm::kTrackHolds);
  const double edge_at_the_axle_m = curve.marks().flat_begin + small_wheels.com_forward_m;
  EXPECT_NEAR(curve.cross(edge_at_the_axle_m).angle_rad, kPi, 1e-6);
}

TEST(CheckClimb, EveryLengthOfTheRobotIsPositiveAndFinite) {
  const struct {
    double ClimbGeometry::*length;
    const char* name;
  } lengths[] = {{&ClimbGeometry::axle_spacing_m, "axle spacing"},
                 {&ClimbGeometry::wheel_radius_m, "track radius"},
                 {&ClimbGeometry::com_forward_m, "centre of mass ahead of the rear axle"},
                 {&ClimbGeometry::com_height_m, "centre of mass height"},
                 {&ClimbGeometry::body_length_m, "body length"},
                 {&ClimbGeometry::body_height_m, "body height"}};
  for (const auto& [length, name] : lengths) {
    for (const double value : {0.0, -0.1, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()}) {
      ClimbGeometry geometry;
      geometry.*length = value;
      EXPECT_THAT([&] { check_climb(geometry, {}); },
                  testing::ThrowsMessage<SetupError>(testing::HasSubstr(
                      std::string(name) + " must be a positive length in metres")))
          << value;
    }
  }
}

TEST(CheckClimb, RefusesABlockBehindWhichTheRobotFallsOnItsNose) {
  ClimbGeometry geometry;
  geometry.com_forward_m = 0.125;
  ASSERT_GT(climb_limit_m(geometry), 0.060);
  EXPECT_THROW(check_climb(geometry, {0.060, 0.1}), SetupError);
  // The message names the height limit that applies.
  const double lowest_m =
      std::hypot(geometry.axle_spacing_m - geometry.com_forward_m, geometry.wheel_radius_m) +
      geometry.wheel_radius_m;
  EXPECT_NO_THROW(check_climb(geometry, {lowest_m - 1e-6, 0.1}));
  try {
    check_climb(geometry, {lowest_m + 1e-6, 0.1});
    ADD_FAILURE() << "the block must be refused";
  } catch (const SetupError& error) {
    char named[32];
    std::snprintf(named, sizeof named, "below %.1f mm", lowest_m * 1e3);
    EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace tp100::model
