#include "model/track_model.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "support/sequence.h"
#include "uneven_tracks.h"

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

TEST(TrackModel, PaperModeIgnoresTheSlope) {
  TrackModel paper(TrackParameters{}, Mode::kPaper), level(TrackParameters{}, Mode::kPaper);
  paper.advance(0.1, 0.12, 1.0, {0.3, 0.2, 0.7});
  level.advance(0.1, 0.12, 1.0);
  EXPECT_EQ(paper.pose().z_m, 0.0);
  EXPECT_EQ(paper.pose().pitch_rad, 0.0);
  EXPECT_EQ(paper.pose().x_m, level.pose().x_m);
  EXPECT_EQ(paper.pose().yaw_rad, level.pose().yaw_rad);
}

// The equations of the extended model, integrated in small steps; the shape of the turn is that of
// track speeds that a low-pass of 0.13 s smooths.
TEST(TrackModel, ExtendedModeIsItsEquationsInAnyTurnOnAnyGround) {
  const TrackParameters p = uneven_tracks();
  test::Sequence any(4);
  TrackModel model(p, Mode::kExtended, 0.13);
  Pose pose{.x_m = 0.4, .y_m = -0.7, .z_m = 0.2, .yaw_rad = 0.9};
  model.reset(pose);
  double smooth_left = 0.0, smooth_right = 0.0;
  int straight = 0;
  for (int i = 0; i < 400; ++i) {
    const double left_mps = any.between(-0.2, 0.2), dt_s = any.between(0.005, 0.2);
    const double right_mps = i % 3 == 0 ? left_mps * any.between(1.0, 1.2) : any.between(-0.2, 0.2);
    const Incline on{i % 4 == 0 ? 0.0 : any.between(-0.5, 0.5), any.between(-0.05, 0.05),
                     any.between(0.5, 1.0)};
    if (i == 200) {
      pose = {.x_m = 1.0, .yaw_rad = 2.0};
      model.reset(pose);
    }
    const Slip slip = slip_on(p, Mode::kExtended, on);
    const double left = left_mps * (1.0 - slip.left), right = right_mps * (1.0 - slip.right);
    const double share = i % 200 == 0 ? 1.0 : 1.0 - std::exp(-dt_s / 0.13);
    smooth_left += (left - smooth_left) * share;
    smooth_right += (right - smooth_right) * share;
    const Turn turn = turn_of(p, Mode::kExtended, turn_shape(smooth_left, smooth_right));
    const double vx = (left + right) / 2.0 * (1.0 - turn.slip);
    const double rate = (right - left) / turn.wheelbase_m;
    const bool turns = std::abs(rate) > p.turning_threshold_radps;
    straight += turns ? 0 : 1;
    const double vy = vx * std::tan(turns ? p.slip_angle_turning_rad : p.slip_angle_straight_rad) -
                      turn.x_icr_m * rate;
    constexpr int kSteps = 200;
    for (int n = 0; n < kSteps; ++n) {
      const double step_s = dt_s / kSteps, yaw = pose.yaw_rad + rate * step_s / 2.0;
      const double forward = vx * on.horizontal_fraction;
      pose.x_m += (forward * std::cos(yaw) - vy * std::sin(yaw)) * step_s;
      pose.y_m += (forward * std::sin(yaw) + vy * std::cos(yaw)) * step_s;
      pose.z_m += vx * std::sin(on.slope_rad) * step_s;
      pose.yaw_rad += rate * step_s;
    }
    const Twist& twist = model.advance(left_mps, right_mps, dt_s, on);
    ASSERT_NEAR(twist.vx_mps, vx, 1e-12) << i;
    ASSERT_NEAR(twist.vy_mps, vy, 1e-12) << i;
    ASSERT_NEAR(twist.yaw_rate_radps, rate, 1e-12) << i;
    ASSERT_EQ(model.slip().left, slip.left);
    ASSERT_EQ(model.slip().right, slip.right);
    ASSERT_NEAR(model.pose().x_m, pose.x_m, 1e-5) << i;
    ASSERT_NEAR(model.pose().y_m, pose.y_m, 1e-5) << i;
    ASSERT_NEAR(model.pose().z_m, pose.z_m, 1e-9) << i;
    ASSERT_NEAR(model.pose().yaw_rad, pose.yaw_rad, 1e-9) << i;
    ASSERT_EQ(model.pose().pitch_rad, -on.slope_rad);
    // Without a filter the shape is that of the same speeds.
    const Twist alone = body_twist(p, Mode::kExtended, left_mps, right_mps, on);
    ASSERT_NEAR(alone.yaw_rate_radps,
                (right - left) / turn_of(p, Mode::kExtended, turn_shape(left, right)).wheelbase_m,
                1e-12);
  }
  EXPECT_GT(straight, 20);
}

TEST(EquivalentWheelbase, IsThePrintedOneAndThatOfEquationSeven) {
  EXPECT_NEAR(equivalent_wheelbase_m({}), 0.2742, 5e-6);
  // b/2 - gamma dy = 0.08, a/2 - dx = 0.06, and 2 (0.08^2 + 0.06^2) / 0.08 = 0.25.
  EXPECT_NEAR(equivalent_wheelbase_m({.length_m = 0.14,
                                      .width_m = 0.18,
                                      .offset_x_m = 0.01,
                                      .offset_y_m = 0.005,
                                      .gamma = 2.0}),
              0.25, 1e-12);
}

// The series and the closed form of the arc.
TEST(Arc, OfATinyTurnIsExactToItsSecondOrder) {
  for (const double turn : {-3e-3, -1.01e-4, -9.9e-5, -4e-5, 6e-5, 9.9e-5, 1.01e-4, 2e-3}) {
    Pose ahead{}, aside{};
    advance(ahead, {.vx_mps = 2.0, .yaw_rate_radps = 2.0 * turn}, 0.5);
    EXPECT_NEAR(ahead.x_m, 1.0 - turn * turn / 6.0, 1e-12) << turn;
    EXPECT_NEAR(1.0 - ahead.x_m, turn * turn / 6.0, 1e-5 * turn * turn) << turn;
    EXPECT_NEAR(ahead.y_m, turn / 2.0, 1e-6 * std::abs(turn)) << turn;
    advance(aside, {.vy_mps = 2.0, .yaw_rate_radps = 2.0 * turn}, 0.5);
    EXPECT_NEAR(aside.y_m, ahead.x_m, 1e-15) << turn;
    EXPECT_NEAR(aside.x_m, -ahead.y_m, 1e-15) << turn;
  }
}

}  // namespace
}  // namespace tp100::model
