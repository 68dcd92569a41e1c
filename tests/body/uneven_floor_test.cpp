#include "sim/body/uneven_floor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "drive.h"
#include "sim/body/ode_body.h"

namespace tp100::sim {
namespace {

course::Emulated uneven() {
  course::Emulated values;
  values.floor = course::Floor::kUneven;
  values.variation = {.friction_sd = 0.1, .slip_sd = 0.02, .correlation_m = 0.3};
  return values;
}

struct Moments {
  double mean, sd;
};

Moments moments(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / static_cast<double>(values.size() - 1))};
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const Moments of_a = moments(a), of_b = moments(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - of_a.mean) * (b[i] - of_b.mean);
  return sum / static_cast<double>(a.size() - 1) / (of_a.sd * of_b.sd);
}

constexpr std::uint64_t kSeeds = 4000;

/// The slip offset at one place of many floors.
std::vector<double> slips(const course::Emulated& values, double x_m, double y_m) {
  std::vector<double> all;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
    all.push_back(UnevenFloor(values, seed).at(x_m, y_m).slip_offset);
  return all;
}

// Between the corners of the lattice and on them, near and far: the statistics are the same.
TEST(UnevenFloor, MeanAndSpreadAreThoseOfTheFileAtEveryPlace) {
  for (const double tile_m : {0.0, 0.5}) {
    course::Emulated values = uneven();
    values.variation.tile_m = tile_m;
    for (const auto& [x_m, y_m] :
         {std::pair{0.0, 0.0}, {0.15, 0.15}, {0.07, -0.3}, {-412.3, 55.5}}) {
      std::vector<double> friction, slip;
      for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const FloorVariation at = UnevenFloor(values, seed).at(x_m, y_m);
        friction.push_back(at.friction_factor);
        slip.push_back(at.slip_offset);
      }
      const std::string where = std::to_string(x_m) + ", tiles " + std::to_string(tile_m);
      EXPECT_NEAR(moments(friction).mean, 1.0, 0.006) << where;
      EXPECT_NEAR(moments(friction).sd, 0.1, 0.005) << where;
      EXPECT_NEAR(moments(slip).mean, 0.0, 0.0012) << where;
      EXPECT_NEAR(moments(slip).sd, 0.02, 0.001) << where;
      EXPECT_LE(std::abs(std::ranges::max(slip)), 0.07) << where;
      EXPECT_NEAR(correlation(friction, slip), 0.0, 0.06) << where;
    }
  }
}

TEST(UnevenFloor, IsMuchTheSameWithinItsLengthAndAnotherOneBeyond) {
  const std::vector<double> here = slips(uneven(), 1.0, 1.0);
  EXPECT_GT(correlation(here, slips(uneven(), 1.03, 1.0)), 0.95);
  EXPECT_LT(correlation(here, slips(uneven(), 1.15, 1.0)), 0.9);
  for (const auto& [x_m, y_m] : {std::pair{1.0, 2.0}, {2.0, 1.0}, {1.7, 0.3}})
    EXPECT_NEAR(correlation(here, slips(uneven(), x_m, y_m)), 0.0, 0.06) << x_m;
}

/// Jumps of the slip by more than `jump` along a line that crosses the tiles at an angle.
int jumps(const course::Emulated& values, double jump) {
  const UnevenFloor floor(values, 3);
  int count = 0;
  for (double x_m = 0.0; x_m < 10.0; x_m += 0.001)
    count +=
        std::abs(floor.at(x_m + 0.001, 0.3).slip_offset - floor.at(x_m, 0.3).slip_offset) > jump;
  return count;
}

TEST(UnevenFloor, JumpsAtTheJointsOfItsTilesOnly) {
  course::Emulated values = uneven();
  EXPECT_EQ(jumps(values, 0.0015), 0);
  values.variation.tile_m = 0.5;
  values.variation.correlation_m = 20.0;
  // Between 20 and 28 joints; some neighbours are alike.
  EXPECT_GE(jumps(values, 0.001), 14);
  EXPECT_LE(jumps(values, 0.001), 29);
}

TEST(UnevenFloor, ASeedDrawsTensionPayloadBatteryGyroAndStart) {
  std::vector<double> left, right, forward, battery, scale, x;
  course::Emulated values = uneven();
  values.variation.gyro_scale_sd = values.variation.placed_sd_m = 0.01;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const course::Emulated robot = sampled(values, seed);
    left.push_back(robot.body.track_deficit_left);
    right.push_back(robot.body.track_deficit_right);
    forward.push_back(robot.body.com_forward_m);
    battery.push_back(robot.battery.full_v);
    scale.push_back(robot.imu.gyro_scale_error);
    x.push_back(placed({.x_m = 1.0}, values, seed).x_m);
  }
  EXPECT_NEAR(moments(left).mean, values.body.track_deficit_left, 0.0003);
  EXPECT_NEAR(moments(left).sd, values.variation.tension_sd, 0.0003);
  EXPECT_NEAR(correlation(left, right), 0.0, 0.06) << "either track by itself";
  EXPECT_NEAR(moments(forward).sd, values.variation.payload_sd_m, 0.0001);
  EXPECT_LE(std::ranges::max(battery), values.battery.full_v);
  EXPECT_LT(std::ranges::min(battery), values.battery.full_v - 0.3);
  EXPECT_NEAR(moments(scale).sd, 0.01, 0.0005);
  EXPECT_NEAR(moments(x).mean, 1.0, 0.0006);
  EXPECT_NEAR(moments(x).sd, 0.01, 0.0005);
}

TEST(UnevenFloor, AnEvenFloorAndTheRobotOnItAreThoseOfTheFile) {
  course::Emulated values = uneven();
  values.floor = course::Floor::kEven;
  EXPECT_EQ(UnevenFloor(values, 7).at(3.0, -2.0).friction_factor, 1.0);
  EXPECT_EQ(UnevenFloor(values, 7).at(3.0, -2.0).slip_offset, 0.0);
  EXPECT_EQ(placed({.x_m = 1.0}, values, 5).x_m, 1.0);
  const course::Emulated robot = sampled(values, 5);
  EXPECT_EQ(robot.body.track_deficit_left, values.body.track_deficit_left);
  EXPECT_EQ(robot.body.com_left_m, values.body.com_left_m);
  EXPECT_EQ(robot.battery.full_v, values.battery.full_v);
}

TEST(UnevenFloor, BothBodiesDriveOnIt) {
  for (const course::ContactLaw law : {course::ContactLaw::kOde, course::ContactLaw::kShear}) {
    course::Emulated values = uneven();
    values.contact_law = law;
    values.variation.friction_sd = 0.3;
    const auto yaw_rad = [&](std::uint64_t seed) {
      return drive(*make_body(values, {}, false, {}, seed), 0.08, 0.12, 2.0).pose.yaw_rad;
    };
    EXPECT_GT(std::abs(yaw_rad(1) - yaw_rad(2)), 0.0005) << course::to_string(law);
    EXPECT_EQ(yaw_rad(1), yaw_rad(1)) << course::to_string(law);
  }
}

// Every track slips by the deficit of the floor below it.
TEST(UnevenFloor, SlipOfTheFloorIsAddedToTheTracks) {
  course::Emulated values = uneven();
  values.variation = {.friction_sd = 0.0, .slip_sd = 0.05, .correlation_m = 20.0};
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    OdeBody even(values.body, {}, false), body(values.body, {}, false, {}, {values, seed});
    const double lost =
        1.0 - drive(body, 0.1, 0.1, 1.0).pose.x_m / drive(even, 0.1, 0.1, 1.0).pose.x_m;
    const double share = UnevenFloor(values, seed).at(0.04, 0.0).slip_offset /
                         (1.0 - values.body.track_deficit_left);
    EXPECT_NEAR(lost, share, 0.002) << seed;
  }
}

}  // namespace
}  // namespace tp100::sim
