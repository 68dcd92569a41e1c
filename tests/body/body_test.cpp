// What the bodies `ode` and `shear` do alike, and what `ode` does on the level and on terrain.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

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

constexpr double kTrackMps = 0.1;
constexpr double kFrontM = 0.25;  // where an obstacle begins

course::Terrain block(double height_m, double depth_m = 0.1) {
  course::Block block{};
  block.place.x_m = kFrontM + depth_m / 2.0;
  block.height_m = height_m;
  block.depth_m = depth_m;
  block.width_m = 0.8;
  course::Terrain terrain;
  terrain.obstacles.emplace_back(block);
  return terrain;
}

course::Terrain ramp(double angle_rad, double height_m) {
  course::Ramp ramp{};
  ramp.height_m = height_m;
  ramp.up_rad = ramp.down_rad = angle_rad;
  ramp.top_m = 0.4;
  ramp.width_m = 0.4;
  ramp.place.x_m = kFrontM + ramp.length_m() / 2.0;
  course::Terrain terrain;
  terrain.obstacles.emplace_back(ramp);
  return terrain;
}

course::EmulatedBody robot(double com_height_m, double friction) {
  course::EmulatedBody values;
  values.com_height_m = com_height_m;
  values.friction = friction;
  return values;
}

struct Drive {
  BodyState end{};
  double nose_up_rad = 0.0, nose_down_rad = 0.0, height_m = 0.0;  // largest
};

Drive drive(Body& body, double duration_s) {
  Drive result;
  const int steps = static_cast<int>(std::lround(duration_s * 1000));
  for (int i = 0; i < steps; ++i) {
    body.step(kTrackMps, kTrackMps);
    const Pose& pose = body.state().pose;
    result.nose_up_rad = std::max(result.nose_up_rad, -pose.pitch_rad);
    result.nose_down_rad = std::max(result.nose_down_rad, pose.pitch_rad);
    result.height_m = std::max(result.height_m, pose.z_m);
  }
  result.end = body.state();
  return result;
}

Drive over(const course::Terrain& terrain, const course::EmulatedBody& values, double duration_s,
           const Pose& start = {}) {
  OdeBody body(values, start, false, terrain);
  return drive(body, duration_s);
}

TEST(BodyOnARamp, ClimbsTheSteepestOfThePaperWithEnoughFriction) {
  const Drive climb = over(ramp(28 * kRadPerDeg, 0.15), robot(0.022, 0.55), 9.0);
  EXPECT_GT(climb.height_m, 0.149);
  EXPECT_NEAR(climb.nose_up_rad, 28 * kRadPerDeg, 0.5 * kRadPerDeg);
  // 0.50 is below tan 28 deg = 0.532.
  EXPECT_LT(over(ramp(28 * kRadPerDeg, 0.15), robot(0.022, 0.50), 8.0).height_m, 0.08);
}

TEST(BodyOnARamp, ComesDownTheOtherSideAndStandsFlatAgain) {
  const Drive crossing = over(ramp(28 * kRadPerDeg, 0.08), robot(0.022, 0.9), 14.0);
  EXPECT_NEAR(crossing.height_m, 0.08, 0.012) << "it rocks over the crests";
  EXPECT_NEAR(crossing.nose_down_rad, 28 * kRadPerDeg, 4.0 * kRadPerDeg);
  EXPECT_GT(crossing.end.pose.x_m, 1.1);
  EXPECT_NEAR(crossing.end.pose.z_m, 0.0, 5e-4);
  EXPECT_NEAR(crossing.end.pose.pitch_rad, 0.0, 1e-3);
  EXPECT_NEAR(crossing.end.pose.y_m, 0.0, 1e-3);
}

TEST(BodyOnASlope, StandsStill) {
  const double slope = 28 * kRadPerDeg;
  OdeBody body({}, {.x_m = kFrontM + 0.3, .z_m = 0.3 * std::tan(slope), .pitch_rad = -slope}, false,
               ramp(slope, 0.5));
  const Pose before = body.state().pose;
  for (int i = 0; i < 3000; ++i) body.step(0.0, 0.0);
  EXPECT_NEAR(body.state().pose.x_m, before.x_m, 1e-4);
  EXPECT_NEAR(body.state().pose.pitch_rad, -slope, 2e-3);
}

TEST(BodyOnAStep, CrossesThePapersBlockWithAPeakPitchOf42Deg) {
  const Drive crossing = over(block(0.037), robot(0.022, 0.9), 8.0);
  EXPECT_NEAR(crossing.nose_up_rad / kRadPerDeg, 42.4, 0.7);
  EXPECT_GT(crossing.end.pose.x_m, kFrontM + 0.1 + 0.15);
  EXPECT_NEAR(crossing.end.pose.z_m, 0.0, 5e-4);
  EXPECT_NEAR(crossing.end.pose.yaw_rad, 0.0, 1e-3);
}

TEST(BodyOnAStep, NeedsFrictionToLiftItsFrontAndMoreToTip) {
  EXPECT_LT(over(block(0.037), robot(0.022, 0.70), 4.0).nose_up_rad, 3 * kRadPerDeg);
  const Drive lifted = over(block(0.037), robot(0.022, 0.75), 8.0);
  EXPECT_GT(lifted.nose_up_rad, 35 * kRadPerDeg);
  EXPECT_LT(lifted.end.pose.x_m, kFrontM + 0.03);
  EXPECT_GT(over(block(0.037), robot(0.022, 0.85), 8.0).end.pose.x_m, kFrontM + 0.25);
}

TEST(BodyOnAStep, SquaresUpToTheRiser) {
  const Drive crossing = over(block(0.037), robot(0.022, 0.9), 8.5, {.yaw_rad = 8 * kRadPerDeg});
  EXPECT_GT(crossing.end.pose.x_m, kFrontM + 0.2);
  EXPECT_LT(std::abs(crossing.end.pose.yaw_rad), 4 * kRadPerDeg);
}

TEST(BodyOnTerrain, AWallIsNotEnteredSideways) {
  course::Terrain terrain = block(0.037, 1.0);
  auto& wall = std::get<course::Block>(terrain.obstacles[0]);
  wall.place = {0.4, 0.3, 0.0};
  wall.width_m = 0.36;  // its side runs along y = 0.12, the track's flank at y = 0.10
  const Drive along = over(terrain, robot(0.022, 0.9), 4.0, {.yaw_rad = 15 * kRadPerDeg});
  EXPECT_LT(along.end.pose.y_m, 0.04);
  EXPECT_GT(along.end.pose.x_m, 0.2);
  EXPECT_EQ(OdeBody::solver_messages(), 0u);
}

TEST(BodyOnTerrain, AnEvenlyLoadedRobotDrivesBesideAnObstacleAsItDoesAlone) {
  // With the block nearby but never touched, so that all stations of the tracks are used.
  course::Terrain wall = block(0.05, 2.0);
  auto& obstacle = std::get<course::Block>(wall.obstacles[0]);
  obstacle.place = {0.0, 0.6, 0.0};
  obstacle.width_m = 0.02;
  course::EmulatedBody values;
  values.mid_lift_m = 0.0;
  const double duration_s = 3.0;
  for (const auto& [left, right] : {std::pair(0.1, 0.1), std::pair(0.1, 0.08), std::pair(0.1, 0.05),
                                    std::pair(0.0, -0.1), std::pair(-0.1, 0.1)}) {
    OdeBody alone(values, {}, false), beside(values, {}, false, wall);
    for (int i = 0; i < static_cast<int>(duration_s / kPhysicsStepS); ++i) {
      alone.step(left, right);
      beside.step(left, right);
    }
    const Pose& a = alone.state().pose;
    const Pose& b = beside.state().pose;
    const double yaw_rad = std::abs(b.yaw_rad), distance_m = std::hypot(b.x_m, b.y_m);
    EXPECT_NEAR(a.yaw_rad, b.yaw_rad, 0.002 + 0.015 * yaw_rad) << left << ' ' << right;
    EXPECT_NEAR(a.x_m, b.x_m, 0.001 + 0.01 * distance_m) << left << ' ' << right;
    EXPECT_NEAR(a.y_m, b.y_m, 0.001 + 0.01 * distance_m) << left << ' ' << right;
    EXPECT_NE(a.yaw_rad, b.yaw_rad) << "not the contacts that are compared";
  }
}

TEST(BodyOnASurface, SlipsByItsOffsetAndLosesItsTractionThere) {
  course::Terrain terrain;
  terrain.surfaces.push_back({.name = "wet",
                              .place = {0.5, 0.0, 0.0},
                              .length_m = 1.0,
                              .width_m = 1.0,
                              .friction_factor = 1.0,
                              .slip_offset = 0.1});
  OdeBody body({}, {.x_m = 0.3}, false, terrain);
  drive(body, 0.5);
  const double from = body.state().pose.x_m;
  EXPECT_NEAR(1.0 - (drive(body, 1.0).end.pose.x_m - from) / 0.1, 0.26, 0.005);

  course::Terrain slope = ramp(20 * kRadPerDeg, 0.3);
  const Pose start{
      .x_m = kFrontM + 0.3, .z_m = 0.3 * std::tan(20 * kRadPerDeg), .pitch_rad = -20 * kRadPerDeg};
  EXPECT_GT(over(slope, robot(0.022, 0.9), 1.0, start).end.pose.x_m, start.x_m + 0.05);
  slope.surfaces.push_back({.name = "ice",
                            .place = {0.5, 0.0, 0.0},
                            .length_m = 3.0,
                            .width_m = 1.0,
                            .friction_factor = 0.3});
  EXPECT_LT(over(slope, robot(0.022, 0.9), 1.0, start).end.pose.x_m, start.x_m);
}

}  // namespace
}  // namespace tp100::sim
