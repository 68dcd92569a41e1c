// The virtual world and the physical one share only the course's data. When the emulated body
// drives over a ramp, both must give the same pose.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/arithmetic.h"
#include "model/track_model.h"
#include "sim/body/ode_body.h"
#include "terrain/terrain_follower.h"
#include "terrain/world.h"

namespace tp100 {
namespace {

course::Terrain ramp_of_the_paper() {
  course::Ramp ramp{};
  ramp.height_m = 0.08;
  ramp.up_rad = ramp.down_rad = 28 * kRadPerDeg;
  ramp.top_m = 0.2;
  ramp.width_m = 0.4;
  ramp.place.x_m = 0.25 + ramp.length_m() / 2.0;
  course::Terrain terrain;
  terrain.ramps.push_back(ramp);
  return terrain;
}

TEST(VirtualWorld, StandsOnThePapersRampAsTheBodyDoes) {
  const course::Terrain terrain = ramp_of_the_paper();
  const terrain::World world(terrain, {});
  sim::OdeBody body({}, {}, false, terrain);
  double pitch_squares = 0.0, height_squares = 0.0;
  int count = 0, tipping = 0;
  double pitch_until_now = 0.0;
  while (body.state().pose.x_m < 0.95 && count < 16000) {
    body.step(0.1, 0.1);
    const Pose& truth = body.state().pose;
    const terrain::ContactPose contact_pose = world.at({.x_m = truth.x_m,
                                                        .y_m = truth.y_m,
                                                        .pitch_rad = pitch_until_now,
                                                        .yaw_rad = truth.yaw_rad});
    pitch_until_now = contact_pose.pitch_rad;
    ++count;
    const double pitch_error = contact_pose.pitch_rad - truth.pitch_rad;
    // The body takes a quarter of a second to tip over each of the two crests; the virtual world
    // tips at once.
    if (std::abs(pitch_error) > 3 * kRadPerDeg) {
      ++tipping;
      continue;
    }
    pitch_squares += pitch_error * pitch_error;
    height_squares += std::pow(contact_pose.height_m - truth.z_m, 2);
  }
  EXPECT_GE(body.state().pose.x_m, 0.95);
  EXPECT_LT(std::sqrt(pitch_squares / count), 0.3 * kRadPerDeg);
  EXPECT_LT(std::sqrt(height_squares / count), 0.001);
  EXPECT_LT(tipping, 600);
}

/// The paper's block, across the robot's path.
course::Terrain block_of_the_paper() {
  course::Terrain terrain;
  terrain.blocks.push_back({{0.3, 0.0, 0.0}, 0.037, 0.1, 0.8});
  return terrain;
}

constexpr double kTrackMps = 0.1, kStepS = 1e-3;
constexpr double kLevelSlip = 0.16;

/// A moment of the passage over the block: track travel, pitch of the body and load of the tracks.
struct Instant {
  double track_m;
  double pitch_rad;
  double load_share;  ///< forward force of the tracks as a share of the weight
};

std::vector<Instant> body_over_the_block() {
  course::EmulatedBody values;
  values.creep_left = values.creep_right = 0.113;
  sim::OdeBody body(values, {}, false, block_of_the_paper());
  std::vector<Instant> way;
  for (int i = 1; i <= 6500; ++i) {
    body.step(kTrackMps, kTrackMps);
    const sim::BodyState& now = body.state();
    way.push_back({i * kTrackMps * kStepS, now.pose.pitch_rad,
                   (now.left_load_n + now.right_load_n) / (values.mass_kg * 9.81)});
  }
  return way;
}

std::vector<Instant> ride_over_the_block() {
  model::TrackParameters tracks{};
  tracks.slip_left = tracks.slip_right = kLevelSlip;
  const terrain::World world(block_of_the_paper(), {});
  terrain::TerrainFollower terrain_follower(world, {});
  Pose pose{};
  std::vector<Instant> way;
  for (int i = 1; i <= 6500; ++i) {
    const double distance_m = model::body_twist(tracks, model::Mode::kExtended, kTrackMps,
                                                kTrackMps, terrain_follower.state().incline)
                                  .vx_mps *
                              kStepS;
    const terrain::ContactState& on = terrain_follower.advance(pose, distance_m, kStepS);
    pose.x_m += distance_m * on.incline.horizontal_fraction;
    way.push_back({i * kTrackMps * kStepS, on.pitch_rad, 0.0});
  }
  return way;
}

/// Track travel and mean load between the first and the second pitch, either before or after the
/// steepest pitch of that sign.
Instant between(const std::vector<Instant>& way, double first_deg, double second_deg) {
  const bool nose_up = first_deg < 0.0;
  const auto steepest =
      std::max_element(way.begin(), way.end(), [nose_up](const Instant& a, const Instant& b) {
        return nose_up ? a.pitch_rad > b.pitch_rad : a.pitch_rad < b.pitch_rad;
      });
  const bool rising = std::abs(first_deg) < std::abs(second_deg);
  const double most = std::max(first_deg, second_deg), least = std::min(first_deg, second_deg);
  Instant sum{0.0, 0.0, 0.0};
  int count = 0;
  for (auto at = rising ? way.begin() : steepest; at != (rising ? steepest : way.end()); ++at) {
    const double pitch_deg = at->pitch_rad * kDegPerRad;
    if (pitch_deg > most || pitch_deg < least) continue;
    sum.track_m += kTrackMps * kStepS;
    sum.load_share += at->load_share;
    ++count;
  }
  return {sum.track_m, 0.0, sum.load_share / std::max(count, 1)};
}

// Gravity acts against the tracks while the nose is up and with them while it is down, as on a
// ramp, so the tracks slip more on the way up.
TEST(VirtualWorld, ABlockIsUphillToTheTracksUntilTheBodyTipsAndDownhillBehindIt) {
  const std::vector<Instant> body = body_over_the_block(), terrain_follower = ride_over_the_block();
  const Instant up = between(body, -0.5, -36.0),
                up_in_the_world = between(terrain_follower, -0.5, -36.0);
  EXPECT_GT(up.load_share, 0.35);
  EXPECT_NEAR(up_in_the_world.track_m, up.track_m, 0.03 * up.track_m);
  const Instant down = between(body, 22.0, 7.0),
                down_in_the_world = between(terrain_follower, 22.0, 7.0);
  EXPECT_LT(down.load_share, -0.15);
  EXPECT_NEAR(down_in_the_world.track_m, down.track_m, 0.06 * down.track_m);
}

}  // namespace
}  // namespace tp100
