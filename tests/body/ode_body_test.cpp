#include "sim/body/ode_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include "core/arithmetic.h"

namespace tp100::sim {
namespace {

course::EmulatedBody end_loaded() { return {}; }

course::EmulatedBody uniform() {
  course::EmulatedBody values;
  values.mid_lift_m = 0.0;
  return values;
}

BodyState drive(Body& body, double left_mps, double right_mps, double duration_s) {
  const int steps = static_cast<int>(std::lround(duration_s * 1000));
  for (int i = 0; i < steps; ++i) body.step(left_mps, right_mps);
  return body.state();
}

/// Wheelbase L of eq 5, measured in a spin and corrected for the slip ratios.
double wheelbase_in_a_spin(const course::EmulatedBody& values) {
  OdeBody body(values, {}, false);
  const double track = 0.08;
  const double begin = drive(body, -track, track, 0.5).pose.yaw_rad;
  const double duration_s = 2.0;
  const double yaw = drive(body, -track, track, duration_s).pose.yaw_rad - begin;
  const double surface = track * (1.0 - values.track_deficit_left);
  return 2.0 * surface * duration_s / yaw;
}

TEST(OdeBody, SlipsOnTheFlatAsMuchAsTheRampBoardOfThePaper) {
  OdeBody body(end_loaded(), {}, false);
  const double begin = drive(body, 0.1, 0.1, 0.5).pose.x_m;
  const double distance_m = drive(body, 0.1, 0.1, 2.0).pose.x_m - begin;
  EXPECT_NEAR(1.0 - distance_m / 0.2, 0.160, 0.005);
}

TEST(OdeBody, AnEndLoadedRobotTurnsWithTheWheelbaseOfEquationSeven) {
  EXPECT_NEAR(wheelbase_in_a_spin(end_loaded()), 0.274, 0.006);
}

TEST(OdeBody, AnEndLoadedRobotTurnsWithTheSameWheelbaseAtEveryRadius) {
  const course::EmulatedBody values = end_loaded();
  for (const double inner : {-0.05, 0.0, 0.05, 0.06}) {
    OdeBody body(values, {}, false);
    const double begin = drive(body, inner, 0.1, 0.5).pose.yaw_rad;
    const double yaw = drive(body, inner, 0.1, 1.0).pose.yaw_rad - begin;
    const double surface = (0.1 - inner) * (1.0 - values.track_deficit_left);
    EXPECT_NEAR(surface / yaw, 0.274, 0.02 * 0.274) << inner;
  }
}

TEST(OdeBody, AUniformlyLoadedRobotTurnsMuchMoreEasily) {
  EXPECT_NEAR(wheelbase_in_a_spin(uniform()), 0.194, 0.004);
}

TEST(OdeBody, ATrackWornSmoothAllAroundIsASlipperyTrack) {
  course::EmulatedBody worn = end_loaded(), slippery = end_loaded();
  worn.slick_m = 5.0;
  worn.slick_factor = 0.4;
  slippery.friction *= 0.4;
  EXPECT_EQ(wheelbase_in_a_spin(worn), wheelbase_in_a_spin(slippery));
}

TEST(OdeBody, AWornStretchComesRoundOncePerTrackLength) {
  course::EmulatedBody worn = uniform();
  worn.slick_m = 0.12;
  worn.slick_factor = 0.3;
  const double length_m = 2.0 * (worn.axle_spacing_m + kPi * worn.wheel_radius_m);
  OdeBody body(worn, {}, false);
  const double round_s = length_m / 0.1;
  double slowest = 1e9, fastest = 0.0, last = drive(body, -0.1, 0.1, 0.5).pose.yaw_rad;
  std::vector<double> turns;
  for (int i = 0; i < 20; ++i) {
    const double yaw = drive(body, -0.1, 0.1, round_s / 10.0).pose.yaw_rad;
    turns.push_back(yaw - last);
    last = yaw;
  }
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_NEAR(turns[i], turns[i + 10], 0.02 * turns[i]);
    slowest = std::min(slowest, turns[i]);
    fastest = std::max(fastest, turns[i]);
  }
  EXPECT_GT(fastest, 1.01 * slowest);
  // Tracks that start half a revolution further on slip at other positions.
  OdeBody other(worn, {}, false);
  other.turn_tracks(length_m / 2.0, length_m / 2.0);
  drive(other, -0.1, 0.1, 0.5);
  const double from = other.state().pose.yaw_rad;
  EXPECT_GT(std::abs(drive(other, -0.1, 0.1, round_s / 10.0).pose.yaw_rad - from - turns[0]),
            1e-4 * turns[0]);
  // At standstill nothing turns the body.
  EXPECT_NEAR(drive(body, 0.0, 0.0, 1.0).pose.yaw_rad, last, 0.05);
}

TEST(OdeBody, StandsStill) {
  OdeBody body(end_loaded(), {.x_m = 0.3, .y_m = -0.2, .yaw_rad = 1.0}, false);
  const BodyState state = drive(body, 0.0, 0.0, 5.0);
  EXPECT_NEAR(state.pose.x_m, 0.3, 1e-6);
  EXPECT_NEAR(state.pose.y_m, -0.2, 1e-6);
  EXPECT_NEAR(state.pose.yaw_rad, 1.0, 1e-6);
  EXPECT_NEAR(state.specific_force_mps2[2], 9.81, 0.01);
  EXPECT_NEAR(state.pose.pitch_rad, 0.0, 1e-4);
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

TEST(OdeBody, StandsStillTiltedWhenItsMassIsOffTheMiddle) {
  course::EmulatedBody values = end_loaded();
  values.com_forward_m = 0.005;
  OdeBody body(values, {.x_m = 0.1, .y_m = 0.2, .yaw_rad = -2.0}, false);
  const double pitch = body.state().pose.pitch_rad;
  EXPECT_GT(pitch, 1e-4) << "nose down";
  const Pose pose = drive(body, 0.0, 0.0, 2.0).pose;
  EXPECT_NEAR(pose.x_m, 0.1, 1e-5);
  EXPECT_NEAR(pose.y_m, 0.2, 1e-5);
  EXPECT_NEAR(pose.yaw_rad, -2.0, 1e-5);
  EXPECT_NEAR(pose.pitch_rad, pitch, 1e-4);
}

TEST(OdeBody, YawRunsOnBeyondOneTurn) {
  OdeBody body(uniform(), {.yaw_rad = 3.0}, false);
  double last = 3.0;
  for (int i = 0; i < 2500; ++i) {
    body.step(-0.2, 0.2);
    ASSERT_LT(std::abs(body.state().pose.yaw_rad - last), 0.01);
    last = body.state().pose.yaw_rad;
  }
  EXPECT_GT(last, 3.0 + 4.0);
}

TEST(OdeBody, TheAccelerometerFeelsTheStartAndNothingAfterwards) {
  OdeBody body(end_loaded(), {}, false);
  double gained = 0.0;
  for (int i = 0; i < 500; ++i) {
    body.step(0.1 * std::min(1.0, i / 200.0), 0.1 * std::min(1.0, i / 200.0));
    gained += body.state().specific_force_mps2[0] * 1e-3;
  }
  EXPECT_NEAR(gained, body.state().velocity_mps[0], 0.01);
  EXPECT_NEAR(body.state().specific_force_mps2[0], 0.0, 0.02);
}

TEST(OdeBody, LeftAndRightAreMirrorImages) {
  OdeBody left(end_loaded(), {}, false);
  OdeBody right(end_loaded(), {}, false);
  const Pose a = drive(left, 0.06, 0.1, 2.0).pose;
  const Pose b = drive(right, 0.1, 0.06, 2.0).pose;
  EXPECT_NEAR(a.x_m, b.x_m, 1e-5);
  EXPECT_NEAR(a.y_m, -b.y_m, 1e-5);
  EXPECT_NEAR(a.yaw_rad, -b.yaw_rad, 1e-4);
  EXPECT_GT(a.yaw_rad, 0.1);
}

TEST(OdeBody, ADisturbanceMovesItAsFarAsAskedAndTheGyroSeesTheTurn) {
  OdeBody body(end_loaded(), {}, false);
  drive(body, 0.1, 0.1, 1.0);
  const Pose before = body.state().pose;
  body.disturbance(0.04, 15 * kRadPerDeg, 0.3);
  double turned = 0.0;
  for (int i = 0; i < 300; ++i) {
    body.step(0.1, 0.1);
    turned += body.state().rate_radps[2] * 1e-3;
  }
  EXPECT_FALSE(body.disturbed());
  const Pose& after = body.state().pose;
  EXPECT_NEAR(after.yaw_rad - before.yaw_rad, 15 * kRadPerDeg, 0.01);
  EXPECT_NEAR(turned, after.yaw_rad - before.yaw_rad, 1e-4);
  const double ahead = 0.1 * 0.84 * 0.3;
  EXPECT_NEAR(std::hypot(after.x_m - before.x_m, after.y_m - before.y_m), std::hypot(0.04, ahead),
              0.006);
}

TEST(OdeBody, OnAStandNothingMoves) {
  OdeBody body(end_loaded(), {}, true);
  const BodyState state = drive(body, 0.1, -0.1, 1.0);
  EXPECT_EQ(state.pose.x_m, 0.0);
  EXPECT_EQ(state.pose.yaw_rad, 0.0);
  EXPECT_EQ(state.left_load_n, 0.0);
}

TEST(OdeBody, SpinningTracksFeelTheGround) {
  OdeBody body(end_loaded(), {}, false);
  const BodyState state = drive(body, -0.08, 0.08, 1.0);
  EXPECT_GT(state.right_load_n, 0.5);
  EXPECT_LT(state.left_load_n, -0.5);
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
