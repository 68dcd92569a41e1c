// What the bodies `ode` and `shear` do alike, and what `ode` does on the level.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/arithmetic.h"
#include "course/robot_file.h"
#include "drive.h"
#include "sim/body/ode_body.h"

namespace tp100::sim {
namespace {

class EitherBody : public testing::TestWithParam<course::ContactLaw> {
 protected:
  EitherBody() { values_.contact_law = GetParam(); }
  std::unique_ptr<Body> body(const Pose& start = {}, bool on_stand = false) const {
    return make_body(values_, start, on_stand);
  }
  /// Rate of a turn on the spot, the first moments left out.
  double spin_radps() const {
    const std::unique_ptr<Body> spinning = body();
    const double begin = drive(*spinning, -0.08, 0.08, 1.0).pose.yaw_rad;
    return drive(*spinning, -0.08, 0.08, 1.0).pose.yaw_rad - begin;
  }

  course::Emulated values_{};
};

INSTANTIATE_TEST_SUITE_P(Laws, EitherBody,
                         testing::Values(course::ContactLaw::kOde, course::ContactLaw::kShear),
                         [](const auto& param) { return std::string(to_string(param.param)); });

TEST_P(EitherBody, StandsStillWhereItWasPutAlsoWithItsMassOffTheMiddle) {
  for (const double forward_m : {0.0, 0.005}) {
    values_.body.com_forward_m = forward_m;
    const std::unique_ptr<Body> standing = body({.x_m = 0.3, .y_m = -0.2, .yaw_rad = -2.0});
    const double pitch = standing->state().pose.pitch_rad;
    const BodyState& state = drive(*standing, 0.0, 0.0, 3.0);
    EXPECT_NEAR(state.pose.x_m, 0.3, 1e-5);
    EXPECT_NEAR(state.pose.y_m, -0.2, 1e-5);
    EXPECT_NEAR(state.pose.yaw_rad, -2.0, 1e-5);
    EXPECT_NEAR(state.pose.pitch_rad, pitch, 1e-4);
    EXPECT_NEAR(state.specific_force_mps2[2], kGravityMps2, 0.01);
  }
}

TEST_P(EitherBody, OnAStandNothingMoves) {
  const std::unique_ptr<Body> spinning = body({}, true);
  spinning->disturbance(0.04, 0.2, 0.3);
  const BodyState& state = drive(*spinning, 0.1, -0.1, 1.0);
  EXPECT_EQ(state.pose.x_m, 0.0);
  EXPECT_EQ(state.pose.yaw_rad, 0.0);
  EXPECT_EQ(state.left_load_n, 0.0);
  EXPECT_EQ(state.specific_force_mps2[2], kGravityMps2);
}

TEST_P(EitherBody, ItsYawRunsOnBeyondOneTurnAndItsTracksFeelTheGround) {
  const std::unique_ptr<Body> spinning = body({.yaw_rad = 3.0});
  double last = 3.0;
  for (int i = 0; i < 4000; ++i) {
    spinning->step(-0.2, 0.2);
    ASSERT_LT(std::abs(spinning->state().pose.yaw_rad - last), 0.01);
    last = spinning->state().pose.yaw_rad;
  }
  EXPECT_GT(last, 3.0 + 4.0);
  EXPECT_GT(spinning->state().right_load_n, 0.5);
  EXPECT_LT(spinning->state().left_load_n, -0.5);
}

TEST_P(EitherBody, TheAccelerometerFeelsTheStartAndNothingAfterwards) {
  const std::unique_ptr<Body> starting = body();
  double gained = 0.0;
  for (int i = 0; i < 500; ++i) {
    starting->step(0.1 * std::min(1.0, i / 200.0), 0.1 * std::min(1.0, i / 200.0));
    gained += starting->state().specific_force_mps2[0] * kPhysicsStepS;
  }
  EXPECT_GT(gained, 0.08);
  EXPECT_NEAR(gained, starting->state().velocity_mps[0], 0.01);
  EXPECT_NEAR(starting->state().specific_force_mps2[0], 0.0, 0.02);
}

TEST_P(EitherBody, ADisturbanceMovesItAsFarAsAskedAndTheGyroSeesTheTurn) {
  values_.body.com_forward_m = 0.012;
  const std::unique_ptr<Body> pushed = body({.yaw_rad = 0.5});
  pushed->disturbance(0.04, 15 * kRadPerDeg, 0.3);
  double turned = 0.0;
  for (int i = 0; i < 300; ++i) {
    EXPECT_TRUE(pushed->disturbed());
    pushed->step(0.0, 0.0);
    turned += pushed->state().rate_radps[2] * kPhysicsStepS;
  }
  EXPECT_FALSE(pushed->disturbed());
  const Pose& after = pushed->state().pose;
  EXPECT_NEAR(after.yaw_rad - 0.5, 15 * kRadPerDeg, 0.01);
  EXPECT_NEAR(turned, after.yaw_rad - 0.5, 1e-4);
  EXPECT_NEAR(std::hypot(after.x_m, after.y_m), 0.04, 0.002);
  EXPECT_GT(-std::sin(0.5) * after.x_m + std::cos(0.5) * after.y_m, 0.037) << "to its left";
}

// A stretch of the track that is worn smooth comes round; one all around is a slippery track.
TEST_P(EitherBody, WornTracksSlipWhereTheyAreWorn) {
  values_.body.slick_m = 0.12;
  values_.body.slick_factor = 0.3;
  const std::unique_ptr<Body> one = body(), other = body();
  const double length_m = 2.0 * (values_.body.axle_spacing_m + kPi * values_.body.wheel_radius_m);
  other->turn_tracks(length_m, length_m);
  EXPECT_EQ(drive(*one, -0.1, 0.1, 1.0).pose.yaw_rad, drive(*other, -0.1, 0.1, 1.0).pose.yaw_rad);
  other->turn_tracks(length_m / 2.0, length_m / 2.0);
  EXPECT_NE(drive(*one, -0.1, 0.1, 1.0).pose.yaw_rad, drive(*other, -0.1, 0.1, 1.0).pose.yaw_rad);
  values_.body.slick_m = 5.0;
  const double worn_radps = spin_radps();
  values_.body.slick_m = 0.0;
  values_.body.friction *= 0.3;
  EXPECT_EQ(worn_radps, spin_radps());
}

course::EmulatedBody end_loaded() { return {}; }

course::EmulatedBody uniform() {
  course::EmulatedBody values;
  values.mid_lift_m = 0.0;
  return values;
}

/// Wheelbase L of eq 5 in a steady turn with these track speeds, corrected for the slip ratios.
double wheelbase_m(const course::EmulatedBody& values, double left_mps, double right_mps) {
  constexpr double kDurationS = 1.5;
  OdeBody body(values, {}, false);
  const double begin = drive(body, left_mps, right_mps, 0.5).pose.yaw_rad;
  const double yaw = drive(body, left_mps, right_mps, kDurationS).pose.yaw_rad - begin;
  return (right_mps - left_mps) * (1.0 - values.track_deficit_left) * kDurationS / yaw;
}

TEST(OdeBody, SlipsOnTheFlatAsMuchAsTheRampBoardOfThePaper) {
  OdeBody body(end_loaded(), {}, false);
  const double begin = drive(body, 0.1, 0.1, 0.5).pose.x_m;
  const double distance_m = drive(body, 0.1, 0.1, 2.0).pose.x_m - begin;
  EXPECT_NEAR(1.0 - distance_m / 0.2, 0.160, 0.005);
}

TEST(OdeBody, AnEndLoadedRobotTurnsWithTheWheelbaseOfEquationSevenAtEveryRadius) {
  EXPECT_NEAR(wheelbase_m(end_loaded(), -0.08, 0.08), 0.274, 0.006);
  for (const double inner_mps : {-0.05, 0.0, 0.05, 0.06})
    EXPECT_NEAR(wheelbase_m(end_loaded(), inner_mps, 0.1), 0.274, 0.006) << inner_mps;
  EXPECT_NEAR(wheelbase_m(uniform(), -0.08, 0.08), 0.194, 0.004) << "much more easily";
}

// Several robots drive in one process, some in threads of their own.
TEST(OdeBody, TheSameCallsGiveTheSameBitsWhateverOtherBodiesDo) {
  const auto end_of_run = [](double left_mps) {
    OdeBody body(uniform(), {}, false);
    OdeBody beside(end_loaded(), {}, false);
    for (int i = 0; i < 500; ++i) {
      body.step(left_mps, 0.1);
      beside.step(-left_mps, 0.05);
    }
    return body.state().pose;
  };
  OdeBody body(uniform(), {}, false);
  const Pose alone = drive(body, 0.05, 0.1, 0.5).pose;
  Pose in_thread{};
  std::thread thread([&] { in_thread = end_of_run(0.05); });
  end_of_run(-0.1);
  thread.join();
  EXPECT_EQ(alone.x_m, in_thread.x_m);
  EXPECT_EQ(alone.y_m, in_thread.y_m);
  EXPECT_EQ(alone.yaw_rad, in_thread.yaw_rad);
}

TEST(OdeBody, LeansTowardsItsMass) {
  course::EmulatedBody values = end_loaded();
  values.com_forward_m = 0.005;
  EXPECT_GT(OdeBody(values, {}, false).state().pose.pitch_rad, 1e-4) << "nose down";
}

TEST(OdeBody, LeftAndRightAreMirrorImages) {
  OdeBody left(end_loaded(), {}, false), right(end_loaded(), {}, false);
  const Pose a = drive(left, 0.06, 0.1, 2.0).pose, b = drive(right, 0.1, 0.06, 2.0).pose;
  EXPECT_NEAR(a.x_m, b.x_m, 1e-5);
  EXPECT_NEAR(a.y_m, -b.y_m, 1e-5);
  EXPECT_NEAR(a.yaw_rad, -b.yaw_rad, 1e-4);
  EXPECT_GT(a.yaw_rad, 0.1);
}

TEST(OdeBody, TheSolverHasNothingToSay) {
  for (const course::EmulatedBody& values : {end_loaded(), uniform()}) {
    OdeBody body(values, {}, false);
    drive(body, 0.2, 0.2, 0.2);
    drive(body, -0.2, 0.2, 0.2);
    body.disturbance(0.04, 0.26, 0.1);
    drive(body, 0.0, 0.1, 0.2);
    drive(body, 0.0, 0.0, 0.2);
  }
  EXPECT_EQ(OdeBody::solver_messages(), 0u);
}

}  // namespace
}  // namespace tp100::sim
