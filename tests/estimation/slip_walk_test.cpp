#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "estimation/odometry.h"

namespace tp100::estimation {
namespace {

constexpr double kWayM = 0.36;
constexpr double kNoise = 3e-4;

/// The estimate after `windows` windows on a floor whose slip difference drifts by `step_rtm`.
double estimated_rtm(double step_rtm, int windows, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  constexpr int kParts = 50;
  SlipWalk walk;
  double slip = 0.0, before = 0.0;
  for (int window = 0; window <= windows; ++window) {
    double mean = 0.0;
    for (int part = 0; part < kParts; ++part) {
      slip += step_rtm * std::sqrt(kWayM / kParts) * normal(random);
      mean += slip / kParts;
    }
    mean += kNoise / std::sqrt(2.0) * normal(random);
    if (window > 0) walk.add(mean - before, kNoise, kWayM);
    before = mean;
  }
  return walk.step_rtm();
}

TEST(SlipWalk, AssumesTheWorstBeforeItHasSeenTheFloor) { EXPECT_GT(SlipWalk().step_rtm(), 0.03); }

TEST(SlipWalk, FindsTheStepOfAnyFloor) {
  for (const double step : {1e-3, 3e-3, 1e-2, 3e-2}) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      const double estimated = estimated_rtm(step, 30, seed);
      EXPECT_GT(estimated, step / 2.5) << step << " seed " << seed;
      EXPECT_LT(estimated, step * 2.5) << step << " seed " << seed;
    }
  }
}

TEST(SlipWalk, TellsAnEvenFloorBelowTheNoiseWithinSomeMetres) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    EXPECT_LT(estimated_rtm(0.0, 5, seed), 3e-3) << seed;
    EXPECT_LT(estimated_rtm(0.0, 30, seed), 6e-4) << seed;
  }
}

// From parquet onto a carpet.
TEST(SlipWalk, ForgetsAnEvenFloorWithinSomeWindowsOfAnUnevenOne) {
  SlipWalk walk;
  for (int i = 0; i < 1000; ++i) walk.add(1e-4, kNoise, kWayM);
  EXPECT_LT(walk.step_rtm(), 4e-4);
  for (int i = 0; i < 6; ++i) walk.add(i % 2 == 0 ? 8e-3 : -6e-3, kNoise, kWayM);
  EXPECT_GT(walk.step_rtm(), 5e-3);
}

}  // namespace
}  // namespace tp100::estimation
