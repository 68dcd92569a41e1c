// Odometry over many windows, in which tracks and gyro are compared.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "any_motion.h"
#include "estimation/odometry.h"

namespace tp100::estimation {
namespace {

/// A drive of windows of 0.3 s, each with its own speed and turn, with everything that may happen.
class Windows {
 public:
  explicit Windows(std::uint64_t seed) : any_(seed) {}

  FilterInput next() {
    if (left_s_ <= 0.0) {
      left_s_ = 0.3;
      speed_mps_ = any_.chance(0.2) ? any_.between(-0.012, 0.012) : any_.between(0.05, 0.2);
      rate_radps_ += any_.between(-0.08, 0.08);
      if (any_.chance(0.1)) rate_radps_ = any_.between(-0.5, 0.5);
      ground_ = {.slip = {0.16, 0.11}};
      if (any_.chance(0.1)) ground_ = {.roll_rad = 0.1, .pitch_rad = 0.2, .hold_slip = true};
    }
    const double dt_s = any_.chance(0.1) ? 0.03 : 0.01;
    left_s_ -= dt_s;
    end_ns_ += from_s(dt_s);
    const double half = 0.15 * rate_radps_ + any_.between(-0.001, 0.001);
    return {.end_ns = end_ns_,
            .dt_s = dt_s,
            .tracks = {(speed_mps_ - half) / 0.84, (speed_mps_ + half) / 0.89},
            .gyro_z_radps = rate_radps_ + 0.03 + (any_.chance(0.02) ? 3.0 : 0.0),
            .gyro = !any_.chance(0.005),
            .warming_degc = any_.between(-0.01, 0.01),
            .ground = ground_};
  }

 private:
  test::Sequence any_;
  double left_s_ = 0.0, speed_mps_ = 0.1, rate_radps_ = 0.0;
  HostNs end_ns_ = kNsPerS;
  Ground ground_{};
};

// What was seen just before is part of no window after it.
TEST(OdometryWindows, BeginAnewWithARunAndAfterAnInterruption) {
  for (const bool interrupted : {false, true}) {
    Odometry odometry(uneven_tracks(), {.residual_window_s = 0.3});
    Windows before(8);
    for (int i = 0; i < 1015; ++i) odometry.advance(before.next());
    const FilterState state = odometry.state();
    interrupted ? odometry.interrupt() : odometry.begin({.x_m = 1.0, .y_m = 2.0, .yaw_rad = 3.0});
    EXPECT_EQ(odometry.state().mean[kBias], state.mean[kBias]) << "the bias is kept";
    EXPECT_EQ(odometry.pose().x_m, interrupted ? state.mean[kX] : 1.0);
    const FilterParameters& noise = odometry.model().noise();
    const double added = square(interrupted ? noise.disturbed_sd_m : noise.start_sd_m);
    EXPECT_NEAR(odometry.pose_covariance().yy,
                added + (interrupted ? state.covariance(kY, kY) : 0.0), 1e-12);
    EXPECT_EQ(odometry.state().covariance(kX, kBias), 0.0);
    FilterInput in{.end_ns = 1, .dt_s = 0.01, .tracks = {0.1, 0.11}, .gyro = true};
    for (int i = 1; i < 30; ++i, in.end_ns += from_s(in.dt_s)) {
      ASSERT_FALSE(odometry.advance(in).has_residual) << i;
    }
    in.dt_s = 0.011;
    const Motion motion = odometry.advance(in);
    ASSERT_TRUE(motion.has_residual);
    EXPECT_NEAR(motion.turn_change,
                odometry.model().turn_ratio(odometry.state().mean, motion.residual), 1e-3)
        << "there is none before it";
  }
}

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
