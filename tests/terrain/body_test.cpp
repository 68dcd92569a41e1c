// The virtual world and the physical one share only the course's data. When the emulated body
// drives over a ramp, both must give the same pose.

#include <gtest/gtest.h>

#include <cmath>

#include "core/arithmetic.h"
#include "sim/body/ode_body.h"
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

}  // namespace
}  // namespace tp100
