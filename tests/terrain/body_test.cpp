// The virtual world and the physical one share the course's data and nothing else: where the
// emulated body really drives over a ramp, both must tell the same.

#include "sim/body/body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/angle.h"
#include "model/track_model.h"
#include "terrain/ride.h"
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
  sim::Body body({}, {}, false, terrain);
  double pitch_squares = 0.0, height_squares = 0.0;
  int count = 0, tipping = 0;
  double pitch_until_now = 0.0;
  while (body.state().pose.x_m < 0.95 && count < 16000) {
    body.step(0.1, 0.1);
    const Pose& truth = body.state().pose;
    const terrain::Footing footing = world.at({.x_m = truth.x_m,
                                               .y_m = truth.y_m,
                                               .pitch_rad = pitch_until_now,
                                               .yaw_rad = truth.yaw_rad});
    pitch_until_now = footing.pitch_rad;
    ++count;
    const double pitch_error = footing.pitch_rad - truth.pitch_rad;
    // The body takes a quarter of a second to tip over each of the two crests, the virtual world
    // no time.
    if (std::abs(pitch_error) > 3 * kRadPerDeg) {
      ++tipping;
      continue;
    }
    pitch_squares += pitch_error * pitch_error;
    height_squares += std::pow(footing.height_m - truth.z_m, 2);
  }
  EXPECT_GE(body.state().pose.x_m, 0.95);
  EXPECT_LT(std::sqrt(pitch_squares / count), 0.3 * kRadPerDeg);
  EXPECT_LT(std::sqrt(height_squares / count), 0.001);
  EXPECT_LT(tipping, 600);
}

/// The paper's block, upright across the way.
course::Terrain block_of_the_paper() {
  course::Terrain terrain;
  terrain.blocks.push_back({{0.3, 0.0, 0.0}, 0.037, 0.1, 0.8});
  return terrain;
}

constexpr double kBeltMps = 0.1, kStepS = 1e-3;
constexpr double kLevelSlip = 0.16;

/// A piece of the way over the block: the body's pitch and what it takes to get there.
struct Instant {
  double belt_m;
  double pitch_rad;
  double load_share;  ///< that the belts push forward with, of the weight
};

std::vector<Instant> body_over_the_block() {
  course::EmulatedBody values;
  values.creep_left = values.creep_right = 0.113;
  sim::Body body(values, {}, false, block_of_the_paper());
  std::vector<Instant> way;
  for (int i = 1; i <= 6500; ++i) {
    body.step(kBeltMps, kBeltMps);
    const sim::BodyState& now = body.state();
    way.push_back({i * kBeltMps * kStepS, now.pose.pitch_rad,
                   (now.left_load_n + now.right_load_n) / (values.mass_kg * 9.81)});
  }
  return way;
}

std::vector<Instant> ride_over_the_block() {
  model::TrackParameters tracks{};
  tracks.slip_left = tracks.slip_right = kLevelSlip;
  const terrain::World world(block_of_the_paper(), {});
  terrain::Ride ride(world, {});
  Pose pose{};
  std::vector<Instant> way;
  for (int i = 1; i <= 6500; ++i) {
    const double way_m =
        model::body_twist(tracks, model::Mode::kExtended, kBeltMps, kBeltMps, ride.state().incline)
            .vx_mps *
        kStepS;
    const terrain::RideState& on = ride.advance(pose, way_m, kStepS);
    pose.x_m += way_m * on.incline.planar;
    way.push_back({i * kBeltMps * kStepS, on.pitch_rad, 0.0});
  }
  return way;
}

/// Belt travel and mean load from the first pitch to the second, on the way up to the steepest one
/// of that side or on the way back from it.
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
    sum.belt_m += kBeltMps * kStepS;
    sum.load_share += at->load_share;
    ++count;
  }
  return {sum.belt_m, 0.0, sum.load_share / std::max(count, 1)};
}

// Gravity's share is against the belts while the nose is up and with them while it is down, as on a
// ramp, and the belts slip the more on the way up.
TEST(VirtualWorld, ABlockIsUphillToTheBeltsUntilTheBodyTipsAndDownhillBehindIt) {
  const std::vector<Instant> body = body_over_the_block(), ride = ride_over_the_block();
  const Instant up = between(body, -0.5, -36.0), up_in_the_world = between(ride, -0.5, -36.0);
  EXPECT_GT(up.load_share, 0.35);
  EXPECT_NEAR(up_in_the_world.belt_m, up.belt_m, 0.03 * up.belt_m);
  const Instant down = between(body, 22.0, 7.0), down_in_the_world = between(ride, 22.0, 7.0);
  EXPECT_LT(down.load_share, -0.15);
  EXPECT_NEAR(down_in_the_world.belt_m, down.belt_m, 0.06 * down.belt_m);
}

}  // namespace
}  // namespace tp100
