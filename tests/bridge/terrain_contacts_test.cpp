// The ground under the pose, real or virtual. Ramps and blocks in each set-up: whole_runs_test.
#include "bridge/terrain_contacts.h"

#include <gtest/gtest.h>

namespace tp100::bridge {
namespace {

TEST(TerrainContacts, OtherGroundIsRealOnTheFloorButNotOnAStand) {
  course::Course course;
  course.terrain.surfaces.push_back({"felt", {}, 0.5, 0.5, 1.0, 0.05});
  for (const auto setup : {Setup::kFlat, Setup::kStand, Setup::kTerrain}) {
    Parameters parameters;
    parameters.setup = setup;
    TerrainContacts terrain_contacts(parameters, &course);
    terrain_contacts.advance({.tracks = {0.1, 0.1}, .dt_s = 0.005});
    EXPECT_EQ(terrain_contacts.incline(PoseSource::kModel).slip_offset,
              setup == Setup::kStand ? 0.0 : 0.05);
  }
}

}  // namespace
}  // namespace tp100::bridge
