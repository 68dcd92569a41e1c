#include "bridge/terrain_contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/arithmetic.h"

namespace tp100::bridge {
namespace {

constexpr double kIntervalS = 5e-3;

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

/// Drives the tracks at 0.1 m/s along x; all pose sources have the same pose.
Pose drive(TerrainContacts& terrain_contacts, double time_s, terrain::Attitude imu = {}) {
  Pose pose{};
  for (double t = 0; t < time_s; t += kIntervalS) {
    terrain_contacts.advance({.estimates = {{Estimate{pose}, {pose}, {pose}}},
                              .tracks = {0.1, 0.1},
                              .dt_s = kIntervalS,
                              .imu = imu});
    pose.x_m +=
        0.09 * kIntervalS * terrain_contacts.incline(PoseSource::kOdometry).horizontal_fraction;
  }
  return pose;
}

TEST(TerrainContacts, OnAFlatFloorTheVirtualRobotFallsBehindTheRealOne) {
  const course::Course course = course_with_ramp();
  TerrainContacts terrain_contacts(parameters_for(Setup::kFlat), &course);
  const Pose real = drive(terrain_contacts, 10.0);
  EXPECT_NEAR(real.x_m, 0.9, 1e-3);
  EXPECT_EQ(terrain_contacts.ground(PoseSource::kFused).horizontal_fraction, 1.0);
  EXPECT_EQ(terrain_contacts.ground(PoseSource::kFused).pitch_rad, 0.0);
  const Pose world = terrain_contacts.world(real);
  // The slopes up and down have 0.17 m each; 12 % are lost to the projection, and 8 % to slip
  // uphill.
  EXPECT_LT(world.x_m, real.x_m - 0.03);
  EXPECT_GT(world.x_m, real.x_m - 0.07);
  EXPECT_EQ(world.yaw_rad, real.yaw_rad);
}

TEST(TerrainContacts, TheVirtualWorldGivesHeightAndPitchToEveryPose) {
  const course::Course course = course_with_ramp();
  for (const auto setup : {Setup::kFlat, Setup::kStand}) {
    TerrainContacts terrain_contacts(parameters_for(setup), &course);
    // The robot is at 0.32 m, half way up the ramp.
    const Pose real = drive(terrain_contacts, 3.7, {.pitch_rad = 0.3});
    PerSource<Estimate> estimates{{Estimate{real}, {real}, {real}}};
    terrain_contacts.set_attitude(estimates);
    std::vector<Pose> poses = {terrain_contacts.world(real)};
    for (const Estimate& estimate : estimates.values) poses.push_back(estimate.pose);
    for (const Pose& pose : poses) {
      EXPECT_NEAR(pose.pitch_rad, -28 * kRadPerDeg, 0.02);
      EXPECT_GT(pose.z_m, 0.02);
    }
    EXPECT_EQ(terrain_contacts.terrain_contact().pitch_source, PitchSource::kVirtual);
    EXPECT_EQ(terrain_contacts.terrain_contact().obstacle, ObstacleClass::kRamp);
    EXPECT_FALSE(terrain_contacts.mapped_pitch_rad());
  }
}

TEST(TerrainContacts, OnRealTerrainThePitchIsTheImus) {
  const course::Course course = course_with_ramp();
  TerrainContacts terrain_contacts(parameters_for(Setup::kTerrain), &course);
  const Pose pose = drive(terrain_contacts, 4.5, {.roll_rad = 0.05, .pitch_rad = -0.4});
  EXPECT_EQ(terrain_contacts.terrain_contact().pitch_source, PitchSource::kImu);
  const Pose world = terrain_contacts.world(pose);
  EXPECT_EQ(world.x_m, pose.x_m);
  EXPECT_EQ(world.pitch_rad, -0.4);
  EXPECT_EQ(world.roll_rad, 0.05);
  EXPECT_NEAR(terrain_contacts.ground(PoseSource::kFused).horizontal_fraction, std::cos(0.4),
              1e-12);
  EXPECT_GT(terrain_contacts.ground(PoseSource::kFused).slip.left, 0.12);
  ASSERT_TRUE(terrain_contacts.mapped_pitch_rad());
  EXPECT_NEAR(*terrain_contacts.mapped_pitch_rad(), -28 * kRadPerDeg, 0.05);
}

TEST(TerrainContacts, OtherGroundIsRealOnTheFloorButNotOnAStand) {
  course::Course course = course_with_ramp();
  course.terrain.surfaces[0].place = {};
  for (const auto setup : {Setup::kFlat, Setup::kStand, Setup::kTerrain}) {
    TerrainContacts terrain_contacts(parameters_for(setup), &course);
    drive(terrain_contacts, kIntervalS);
    EXPECT_EQ(terrain_contacts.incline(PoseSource::kModel).slip_offset,
              setup == Setup::kStand ? 0.0 : 0.05);
  }
}

TEST(TerrainContacts, ARestartForgetsWhatTheVirtualRobotIsBehind) {
  const course::Course course = course_with_ramp();
  TerrainContacts terrain_contacts(parameters_for(Setup::kFlat), &course);
  drive(terrain_contacts, 10.0);
  terrain_contacts.restart();
  EXPECT_EQ(terrain_contacts.world({}).x_m, 0.0);
}

TEST(TerrainContacts, WithoutACourseTheWorldIsAPlane) {
  TerrainContacts terrain_contacts(parameters_for(Setup::kFlat), nullptr);
  const Pose pose = drive(terrain_contacts, 10.0);
  EXPECT_EQ(terrain_contacts.world(pose).x_m, pose.x_m);
}

}  // namespace
}  // namespace tp100::bridge
