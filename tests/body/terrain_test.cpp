#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arithmetic.h"
#include "sim/body/ode_body.h"

namespace tp100::sim {
namespace {

constexpr double kTrackMps = 0.1;
constexpr double kFrontM = 0.25;  // where an obstacle begins

course::Terrain block(double height_m, double depth_m = 0.1) {
  course::Block block{};
  block.place.x_m = kFrontM + depth_m / 2.0;
  block.height_m = height_m;
  block.depth_m = depth_m;
  block.width_m = 0.8;
  course::Terrain terrain;
  terrain.blocks.push_back(block);
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
  terrain.ramps.push_back(ramp);
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

TEST(BodyOnASlope, SlipsAsInThePapersTable) {
  const struct {
    double slope_deg, left, right;
  } rows[] = {{8, 0.17, 0.176}, {16, 0.19, 0.204}, {28, 0.22, 0.260}};
  for (const auto& row : rows) {
    const double slope = row.slope_deg * kRadPerDeg;
    course::EmulatedBody values;
    values.creep_left = 0.113;
    values.creep_right = 0.20;
    OdeBody body(values, {.x_m = kFrontM + 0.5, .z_m = 0.5 * std::tan(slope), .pitch_rad = -slope},
                 false, ramp(slope, 1.0));
    const Pose from = drive(body, 0.5).end.pose, to = drive(body, 1.0).end.pose;
    const double distance_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m, to.z_m - from.z_m);
    const double half_turn = (to.yaw_rad - from.yaw_rad) * values.gauge_m / 2.0;
    EXPECT_NEAR(1.0 - (distance_m - half_turn) / kTrackMps, row.left, 0.02) << row.slope_deg;
    EXPECT_NEAR(1.0 - (distance_m + half_turn) / kTrackMps, row.right, 0.02) << row.slope_deg;
  }
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

TEST(BodyOnAStep, TheHighestOneDependsOnTheHeightOfTheMass) {
  const struct {
    double com_height_m, climbs_m, fails_m;
  } limits[] = {{0.018, 0.0405, 0.0425},
                {0.022, 0.0385, 0.0405},
                {0.026, 0.0365, 0.0385},
                {0.030, 0.0335, 0.0355}};
  for (const auto& limit : limits) {
    SCOPED_TRACE(limit.com_height_m);
    const course::EmulatedBody values = robot(limit.com_height_m, 0.9);
    EXPECT_GT(over(block(limit.climbs_m), values, 8.0).end.pose.x_m, kFrontM + 0.1);
    const Drive failure = over(block(limit.fails_m), values, 8.0);
    const bool stalled = failure.end.pose.x_m < kFrontM + 0.05;
    EXPECT_TRUE(stalled || failure.nose_up_rad > 70 * kRadPerDeg);
  }
}

// The tracks bear the weight of a body that they lift, so they creep as on a slope.
TEST(BodyOnAStep, SlipsMoreThanOnTheFlatWhileItClimbs) {
  const auto track_m = [](const course::Terrain& terrain, double creep) {
    course::EmulatedBody values = robot(0.022, 0.9);
    values.creep_left = values.creep_right = creep;
    OdeBody body(values, {}, false, terrain);
    double way_m = 0.0;
    for (; body.state().pose.x_m < kFrontM && way_m < 1.0; way_m += kTrackMps * kPhysicsStepS)
      body.step(kTrackMps, kTrackMps);
    return way_m;
  };
  EXPECT_NEAR(track_m({}, 0.5), track_m({}, 0.0), 0.001);
  const double more_m = track_m(block(0.037), 0.5) - track_m(block(0.037), 0.0);
  EXPECT_GT(more_m, 0.01);
  EXPECT_LT(more_m, 0.06);
}

TEST(BodyOnAStep, SquaresUpToTheRiser) {
  const Drive crossing = over(block(0.037), robot(0.022, 0.9), 8.5, {.yaw_rad = 8 * kRadPerDeg});
  EXPECT_GT(crossing.end.pose.x_m, kFrontM + 0.2);
  EXPECT_LT(std::abs(crossing.end.pose.yaw_rad), 4 * kRadPerDeg);
}

TEST(BodyOnTerrain, AWallIsNotEnteredSideways) {
  course::Terrain terrain = block(0.037, 1.0);
  terrain.blocks[0].place = {0.4, 0.3, 0.0};
  terrain.blocks[0].width_m = 0.36;  // its side runs along y = 0.12, the track's flank at y = 0.10
  const Drive along = over(terrain, robot(0.022, 0.9), 4.0, {.yaw_rad = 15 * kRadPerDeg});
  EXPECT_LT(along.end.pose.y_m, 0.04);
  EXPECT_GT(along.end.pose.x_m, 0.2);
  EXPECT_EQ(OdeBody::solver_messages(), 0u);
}

TEST(BodyOnTerrain, AnEvenlyLoadedRobotDrivesBesideAnObstacleAsItDoesAlone) {
  // With the block nearby but never touched, so that all stations of the tracks are used.
  course::Terrain wall = block(0.05, 2.0);
  wall.blocks[0].place = {0.0, 0.6, 0.0};
  wall.blocks[0].width_m = 0.02;
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
