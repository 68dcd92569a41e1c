#include "model/track_model.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace tp100::model {
namespace {

// Eqs 1-5 written independently and integrated with fourth-order Runge-Kutta in very small steps.
Pose reference(double left, double right, double duration_s, int steps) {
  const double al = 0.1, ar = 0.1188, wheelbase = 0.2742;
  const double vx = (right * (1 - ar) + left * (1 - al)) / 2;
  const double rate = (right * (1 - ar) - left * (1 - al)) / wheelbase;
  const double beta = std::abs(rate) > 0.05 ? 0.0 : 0.404 * std::acos(-1.0) / 180.0;
  const double vy = vx * std::tan(beta);
  const auto flow = [&](double yaw) {
    return std::array{vx * std::cos(yaw) - vy * std::sin(yaw),
                      vx * std::sin(yaw) + vy * std::cos(yaw)};
  };
  Pose pose;
  const double h = duration_s / steps;
  for (int i = 0; i < steps; ++i) {
    const double yaw = rate * h * i;
    const auto a = flow(yaw), b = flow(yaw + rate * h / 2), c = flow(yaw + rate * h);
    pose.x_m += h / 6 * (a[0] + 4 * b[0] + c[0]);
    pose.y_m += h / 6 * (a[1] + 4 * b[1] + c[1]);
  }
  pose.yaw_rad = rate * duration_s;
  return pose;
}

class ConstantSpeeds : public testing::TestWithParam<std::array<double, 2>> {};

TEST_P(ConstantSpeeds, PaperModeAgreesWithAnIndependentIntegrationWhateverTheStepSize) {
  const auto [left, right] = GetParam();
  const double duration_s = 12.0;
  const Pose expected = reference(left, right, duration_s, 20000);
  for (const int steps : {1, 7, 240, 12000}) {
    TrackModel model(TrackParameters{}, Mode::kPaper);
    for (int i = 0; i < steps; ++i) model.advance(left, right, duration_s / steps);
    EXPECT_NEAR(model.pose().x_m, expected.x_m, 1e-9) << steps;
    EXPECT_NEAR(model.pose().y_m, expected.y_m, 1e-9) << steps;
    EXPECT_NEAR(model.pose().yaw_rad, expected.yaw_rad, 1e-9) << steps;
  }
}

INSTANTIATE_TEST_SUITE_P(Drives, ConstantSpeeds,
                         testing::Values(std::array{0.1, 0.1}, std::array{0.1, 0.1 * 0.9 / 0.8812},
                                         std::array{0.05, 0.15}, std::array{-0.1, 0.1},
                                         std::array{0.1, -0.1}, std::array{-0.12, -0.08},
                                         std::array{0.0, 0.0}, std::array{0.0, 0.2},
                                         std::array{0.1, 0.117}));

TEST(TrackModel, StraightDriveOfThePaperTurnsByFourPointFourDegreesPerMetre) {
  TrackModel model(TrackParameters{}, Mode::kPaper);
  model.advance(0.1, 0.1, 10.0);
  const double driven_m = std::hypot(model.twist().vx_mps, model.twist().vy_mps) * 10.0;
  EXPECT_NEAR(model.pose().yaw_rad * kDegPerRad / driven_m, -4.4, 0.05);
}

TEST(TrackModel, YawStaysUnwrapped) {
  TrackModel model(TrackParameters{}, Mode::kPaper);
  model.advance(-0.2, 0.2, 60.0);
  EXPECT_GT(model.pose().yaw_rad, 4 * kPi);
}

TEST(TrackModel, PaperModeIgnoresTheSlopeAndExtendedModeClimbsIt) {
  const double slope = 20.0 * kRadPerDeg;
  TrackModel paper(TrackParameters{}, Mode::kPaper);
  paper.advance(0.1, 0.1, 1.0, inclined(slope));
  EXPECT_EQ(paper.pose().z_m, 0.0);

  TrackParameters symmetric;
  symmetric.slip_left = symmetric.slip_right = 0.1;
  symmetric.slip_angle_straight_rad = 0.0;
  TrackModel extended(symmetric, Mode::kExtended);
  const double table_left = 0.1 + 0.20 - 0.16;
  extended.advance(0.1, 0.1, 1.0, inclined(slope));
  EXPECT_NEAR(extended.slip().left, table_left, 1e-12);
  const double vx = extended.twist().vx_mps;
  EXPECT_NEAR(extended.pose().z_m, vx * std::sin(slope), 1e-12);
  EXPECT_NEAR(extended.pose().pitch_rad, -slope, 1e-12);
  EXPECT_NEAR(std::hypot(extended.pose().x_m, extended.pose().y_m, extended.pose().z_m), vx, 1e-4);
}

TEST(TrackModel, TheIcrOffsetMovesTheReferencePointSidewaysInTurnsOnly) {
  TrackParameters parameters;
  parameters.x_icr_m = 0.01;
  parameters.slip_left = parameters.slip_right = 0.1;
  const Twist spin = body_twist(parameters, Mode::kExtended, -0.1, 0.1);
  EXPECT_NEAR(spin.vy_mps, -0.01 * spin.yaw_rate_radps, 1e-15);
  EXPECT_EQ(body_twist(parameters, Mode::kPaper, -0.1, 0.1).vy_mps, 0.0);
}

TEST(TrackModel, DrivingBackRetracesTheSameArc) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> speed(-0.2, 0.2);
  for (int i = 0; i < 100; ++i) {
    const double left = speed(random), right = speed(random);
    TrackModel model(TrackParameters{}, Mode::kPaper);
    model.advance(left, right, 3.0);
    model.advance(-left, -right, 3.0);
    EXPECT_NEAR(model.pose().x_m, 0.0, 1e-12);
    EXPECT_NEAR(model.pose().y_m, 0.0, 1e-12);
    EXPECT_NEAR(model.pose().yaw_rad, 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace tp100::model
