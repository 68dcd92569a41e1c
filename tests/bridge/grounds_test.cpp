#include "bridge/grounds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle.h"

namespace tp100::bridge {
namespace {

constexpr double kStepS = 5e-3;

course::Course course_with_ramp() {
  course::Course course;
  course.terrain.ramps.push_back(
      {{0.5, 0.0, 0.0}, 0.08, 28 * kRadPerDeg, 0.2, 28 * kRadPerDeg, 0.4});
  course.terrain.surfaces.push_back({"felt", {2.0, 0.0, 0.0}, 0.5, 0.5, 1.0, 0.05});
  return course;
}

Parameters parameters_for(Setup setup) {
  Parameters parameters;
  parameters.setup = setup;
  parameters.model.slip_left = parameters.model.slip_right = 0.1;
  return parameters;
}

/// Belts at 0.1 m/s along x; every pose is the same.
Pose drive(Grounds& grounds, double time_s, terrain::Attitude imu = {}) {
  Pose pose{};
  for (double t = 0; t < time_s; t += kStepS) {
    grounds.advance({.model = pose,
                     .odometry = pose,
                     .fused = pose,
                     .steering = pose,
                     .belts = {0.1, 0.1},
                     .dt_s = kStepS,
                     .imu = imu});
    pose.x_m += 0.09 * kStepS * grounds.odometry().planar;
  }
  return pose;
}

TEST(Grounds, OnAFlatFloorTheVirtualRobotFallsBehindTheRealOne) {
  const course::Course course = course_with_ramp();
  Grounds grounds(parameters_for(Setup::kFlat), &course);
  const Pose real = drive(grounds, 10.0);
  EXPECT_NEAR(real.x_m, 0.9, 1e-3);
  EXPECT_EQ(grounds.fused().planar, 1.0);
  EXPECT_EQ(grounds.fused().pitch_rad, 0.0);
  const Pose world = grounds.world(real);
  // Up and down 0.17 m of slope each, 12 % lost to the projection, and 8 % of slip uphill.
  EXPECT_LT(world.x_m, real.x_m - 0.03);
  EXPECT_GT(world.x_m, real.x_m - 0.07);
  EXPECT_EQ(world.yaw_rad, real.yaw_rad);
}

TEST(Grounds, TheVirtualWorldGivesHeightAndPitchToEveryPose) {
  const course::Course course = course_with_ramp();
  for (const auto setup : {Setup::kFlat, Setup::kBench}) {
    Grounds grounds(parameters_for(setup), &course);
    // 0.32 m: half way up.
    const Pose real = drive(grounds, 3.7, {.pitch_rad = 0.3});
    Pose model = real, odometry = real, fused = real;
    grounds.stand(model, odometry, fused);
    for (const Pose& pose : {model, odometry, fused, grounds.world(real)}) {
      EXPECT_NEAR(pose.pitch_rad, -28 * kRadPerDeg, 0.02);
      EXPECT_GT(pose.z_m, 0.02);
    }
    EXPECT_EQ(grounds.underfoot().pitch_source, PitchSource::kVirtual);
    EXPECT_EQ(grounds.underfoot().obstacle, Obstacle::kRamp);
    EXPECT_FALSE(grounds.mapped_pitch_rad());
  }
}

TEST(Grounds, OnRealTerrainThePitchIsTheImus) {
  const course::Course course = course_with_ramp();
  Grounds grounds(parameters_for(Setup::kTerrain), &course);
  const Pose pose = drive(grounds, 4.5, {.roll_rad = 0.05, .pitch_rad = -0.4});
  EXPECT_EQ(grounds.underfoot().pitch_source, PitchSource::kImu);
  const Pose world = grounds.world(pose);
  EXPECT_EQ(world.x_m, pose.x_m);
  EXPECT_EQ(world.pitch_rad, -0.4);
  EXPECT_EQ(world.roll_rad, 0.05);
  EXPECT_NEAR(grounds.fused().planar, std::cos(0.4), 1e-12);
  EXPECT_GT(grounds.fused().slip.left, 0.12);
  ASSERT_TRUE(grounds.mapped_pitch_rad());
  EXPECT_NEAR(*grounds.mapped_pitch_rad(), -28 * kRadPerDeg, 0.05);
}

TEST(Grounds, OtherGroundIsRealOnTheFloorButNotOnABench) {
  course::Course course = course_with_ramp();
  course.terrain.surfaces[0].place = {};
  for (const auto setup : {Setup::kFlat, Setup::kBench, Setup::kTerrain}) {
    Grounds grounds(parameters_for(setup), &course);
    drive(grounds, kStepS);
    EXPECT_EQ(grounds.model().slip_offset, setup == Setup::kBench ? 0.0 : 0.05);
  }
}

TEST(Grounds, ARestartForgetsWhatTheVirtualRobotIsBehind) {
  const course::Course course = course_with_ramp();
  Grounds grounds(parameters_for(Setup::kFlat), &course);
  drive(grounds, 10.0);
  grounds.restart();
  EXPECT_EQ(grounds.world({}).x_m, 0.0);
}

TEST(Grounds, WithoutACourseTheWorldIsAPlane) {
  Grounds grounds(parameters_for(Setup::kFlat), nullptr);
  const Pose pose = drive(grounds, 10.0);
  EXPECT_EQ(grounds.world(pose).x_m, pose.x_m);
}

}  // namespace
}  // namespace tp100::bridge
