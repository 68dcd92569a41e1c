#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/arithmetic.h"
#include "support/golden_trace.h"
#include "terrain/world.h"

namespace tp100::terrain {
namespace {

using test::GoldenTrace;

constexpr course::ShapeValues kLopsided{.length_m = 0.2,
                                        .height_m = 0.07,
                                        .axle_spacing_m = 0.141,
                                        .wheel_radius_m = 0.028,
                                        .gauge_m = 0.163,
                                        .com_height_m = 0.025,
                                        .com_forward_m = 0.007};

const course::Ramp kRamp{{0.7, -0.4, 0.3}, 0.09, 0.42, 0.17, 0.31, 0.47};
const course::Ramp kPeak{{-0.6, 0.2, -2.4}, 0.06, 0.5, 0.0, 0.35, 0.52};
const course::Block kBlock{{1.9, 0.1, 0.3}, 0.037, 0.31, 0.45};
const course::Block kOtherBlock{{-1.7, -0.6, 1.1}, 0.024, 0.11, 0.38};

course::Terrain obstacles() {
  course::Terrain terrain;
  terrain.ramps = {kRamp, kPeak};
  terrain.blocks = {kBlock, kOtherBlock};
  terrain.surfaces.push_back({"felt", {0.8, -0.3, 0.2}, 0.5, 0.4, 0.9, 0.07});
  terrain.surfaces.push_back({"sand", {0.9, -0.3, 0.2}, 0.2, 0.3, 0.9, 0.12});
  return terrain;
}

/// The pose `along` and `aside` from a piece's middle, turned by `yaw_rad` from its heading.
Pose beside(const course::Place& place, double along, double aside, double yaw_rad) {
  const double c = std::cos(place.heading_rad), s = std::sin(place.heading_rad);
  return {.x_m = place.x_m + c * along - s * aside,
          .y_m = place.y_m + s * along + c * aside,
          .yaw_rad = place.heading_rad + yaw_rad};
}

/// Drives through the poses that `at` gives for -1..1, keeping the pitch from pose to pose.
template <class At>
void drive(GoldenTrace& trace, const World& world, int steps, const At& at) {
  double pitch_rad = 0.0;
  for (int i = 0; i <= steps; ++i) {
    Pose pose = at(2.0 * i / steps - 1.0);
    pose.pitch_rad = pitch_rad;
    const ContactPose on = world.at(pose);
    pitch_rad = on.pitch_rad;
    trace.row({pose.x_m, on.height_m, on.slope_rad, on.pitch_rad, on.roll_rad,
               static_cast<double>(on.obstacle),
               on.surface == nullptr ? 0.0 : on.surface->slip_offset,
               world.height_m(pose.x_m, pose.y_m)});
  }
}

TEST(GoldenTrace, OfTheContactOnRampsAndBlocks) {
  GoldenTrace trace("terrain/world.csv", {"x_m", "height_m", "slope_rad", "pitch_rad", "roll_rad",
                                          "obstacle", "slip_offset", "floor_m"});
  const World world(obstacles(), kLopsided);
  for (const course::Ramp& ramp : {kRamp, kPeak}) {
    for (const double yaw : {0.0, 0.37, -0.52, kPi / 2.0, kPi + 0.2}) {
      drive(trace, world, 44, [&](double t) {
        return beside(ramp.place, 0.43 * t * std::cos(yaw), 0.03 + 0.43 * t * std::sin(yaw), yaw);
      });
    }
  }
  for (const course::Block& block : {kBlock, kOtherBlock}) {
    for (const double yaw : {0.0, kPi}) {
      drive(trace, world, 52, [&](double t) {
        return beside(block.place, yaw == 0.0 ? 0.33 * t : -0.33 * t, 0.04, yaw);
      });
    }
    // With one track on the block, and far away from it.
    drive(trace, world, 12, [&](double t) { return beside(block.place, 0.02, 0.29 * t, 0.0); });
    drive(trace, world, 1, [&](double t) { return beside(block.place, 0.4, 5.0 * t, 0.0); });
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfTheTiltThatAWorldSettlesAtFromManyPitches) {
  GoldenTrace trace("terrain/tilts.csv", {"height_m", "pitch_rad", "roll_rad"});
  for (const course::ShapeValues& shape : {course::ShapeValues{}, kLopsided}) {
    const World world(obstacles(), shape);
    for (int i = 0; i < 150; ++i) {
      Pose pose = beside(i % 2 == 0 ? kRamp.place : kPeak.place, 0.41 * std::sin(0.37 * i),
                         0.1 * std::sin(0.53 * i), i % 3 == 0 ? kPi : 0.0);
      pose.pitch_rad = 1.4 * std::sin(0.71 * i);
      const ContactPose on = world.at(pose);
      trace.row({on.height_m, on.pitch_rad, on.roll_rad});
    }
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfTheNextBlock) {
  GoldenTrace trace("terrain/next_block.csv", {"height_m", "distance_m", "depth_m"});
  course::Terrain terrain = obstacles();
  terrain.blocks.push_back({{2.4, 0.2, 0.3}, 0.03, 0.2, 0.6});
  const World world(terrain, kLopsided);
  for (const double yaw : {0.3, 0.3 + 0.45, 0.3 - 0.31, 0.3 + kPi, 1.9}) {
    for (int i = 0; i < 40; ++i) {
      const Pose pose{.x_m = 0.6 + 0.061 * i, .y_m = -0.25 + 0.019 * i, .yaw_rad = yaw};
      const auto next = world.next_block(pose, 0.5);
      trace.row(next ? std::vector{next->block->height_m, next->distance_m, next->depth_m}
                     : std::vector{-0.01, 0.0, 0.0});
    }
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfProfiles) {
  GoldenTrace trace("terrain/profiles.csv",
                    {"radius_m", "half_width_m", "empty", "begin_m", "end_m", "height_m",
                     "further_m", "wheels_m", "weighted_m", "grounds"});
  for (const Outline& outline : {outline_of(kRamp), outline_of(kPeak), outline_of(kBlock)}) {
    for (int i = 0; i < 48; ++i) {
      const double yaw = i % 4 == 0 ? kPi / 2.0 * (i / 4) : 0.47 * i;
      const Pose at =
          beside(outline.place, 0.5 * std::sin(0.9 * i), 0.35 * std::sin(0.57 * i), yaw);
      const double heading = i % 8 == 4 ? outline.place.heading_rad + yaw : at.yaw_rad;
      const Profile profile(outline, at.x_m, at.y_m, std::cos(heading), std::sin(heading));
      std::array<double, 31> wheel{};
      std::array<ObstacleClass, 31> ground{};
      wheel.fill(0.03);
      profile.lift({-0.31, 0.021, 0.033}, ObstacleClass::kBlock, wheel, ground);
      double sum = 0.0, weighted = 0.0, grounds = 0.0;
      for (std::size_t n = 0; n < wheel.size(); ++n) {
        const auto weight = static_cast<double>(1 + n * n % 17);
        sum += wheel[n];
        weighted += wheel[n] * weight;
        if (ground[n] == ObstacleClass::kBlock) grounds += weight;
      }
      const bool empty = profile.empty();
      trace.row({outline.radius_m, outline.half_width_m, empty ? 1.0 : 0.0,
                 empty ? 0.0 : profile.begin_m(), empty ? 0.0 : profile.end_m(),
                 profile.height_m(0.0), profile.height_m(0.07), sum, weighted, grounds});
    }
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(GoldenTrace, OfSupportLines) {
  GoldenTrace trace("terrain/support_lines.csv", {"before", "after", "rise", "height"});
  std::uint32_t random = 12345;
  const auto next = [&random] {
    random = random * 1664525U + 1013904223U;
    return static_cast<double>(random >> 8U) / (1U << 24U);
  };
  for (int i = 0; i < 200; ++i) {
    WheelHeights wheel{};
    for (double& height : wheel) height = 0.03 + 0.002 * next();
    for (int n = 0; n < i % 7; ++n) wheel[static_cast<std::size_t>(41.0 * next())] += 0.05 * next();
    double com = -3.0 + 47.0 * next();
    if (i % 5 == 0) com = std::round(com);
    const SupportLine line = support_line(wheel, com);
    trace.row({static_cast<double>(line.before), static_cast<double>(line.after), line.rise,
               line.height});
  }
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::terrain
