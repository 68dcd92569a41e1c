// The ground under the pose, real or virtual. Ramps and blocks in each set-up: whole_runs_test.
#include "bridge/terrain_contacts.h"

#include <gtest/gtest.h>

#include "core/arithmetic.h"

namespace tp100::bridge {
namespace {

constexpr double kIntervalS = 5e-3;

Parameters parameters_for(Setup setup) {
  Parameters parameters;
  parameters.setup = setup;
  return parameters;
}

/// Drives the tracks at 0.1 m/s along x; all pose sources have the same pose.
Pose drive(TerrainContacts& terrain_contacts, double time_s) {
  Pose pose{};
  for (double t = 0; t < time_s; t += kIntervalS) {
    terrain_contacts.advance({.estimates = {{Estimate{pose}, {pose}, {pose}}},
                              .tracks = {0.1, 0.1},
                              .dt_s = kIntervalS});
    pose.x_m += 0.1 * kIntervalS;
  }
  return pose;
}

TEST(TerrainContacts, OtherGroundIsRealOnTheFloorButNotOnAStand) {
  course::Course course;
  course.terrain.surfaces.push_back({"felt", {}, 0.5, 0.5, 1.0, 0.05});
  for (const auto setup : {Setup::kFlat, Setup::kStand, Setup::kTerrain}) {
    TerrainContacts terrain_contacts(parameters_for(setup), &course);
    drive(terrain_contacts, kIntervalS);
    EXPECT_EQ(terrain_contacts.incline(PoseSource::kModel).slip_offset,
              setup == Setup::kStand ? 0.0 : 0.05);
  }
}

TEST(TerrainContacts, TheVirtualRobotIsBehindTheRealOneBehindARampUntilARestart) {
  course::Course course;
  course.terrain.ramps.push_back(
      {{0.5, 0.0, 0.0}, 0.08, 28 * kRadPerDeg, 0.2, 28 * kRadPerDeg, 0.4});
  for (const bool ramp : {true, false}) {
    TerrainContacts terrain_contacts(parameters_for(Setup::kFlat), ramp ? &course : nullptr);
    const Pose real = drive(terrain_contacts, 10.0);
    // The slopes up and down have 0.17 m each; 12 % are lost to the projection, and 8 % to slip
    // uphill.
    EXPECT_NEAR(terrain_contacts.world(real).x_m, real.x_m - (ramp ? 0.05 : 0.0), 0.02);
    EXPECT_FALSE(terrain_contacts.mapped_pitch_rad()) << "the real robot is level";
    terrain_contacts.restart();
    EXPECT_EQ(terrain_contacts.world({}).x_m, 0.0);
  }
}

}  // namespace
}  // namespace tp100::bridge
