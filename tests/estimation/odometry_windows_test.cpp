// Odometry over many windows, in which tracks and gyro are compared.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "any_motion.h"
#include "core/arithmetic.h"
#include "estimation/odometry.h"
#include "estimation/track_trust.h"

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
      ASSERT_EQ(odometry.advance(in).residual.variance, 0.0) << i;
    }
    in.dt_s = 0.011;
    EXPECT_GT(odometry.advance(in).residual.variance, 0.0);
  }
}

constexpr double kSensorSd = 3e-4;  // [rad/s]
constexpr double kBySlip = 0.7, kByGain = 0.5;

/// What is known after `windows` windows, half of them in turns, of tracks that err by these.
TrackTrust trust_after(int windows, double slip_sd, double gain_sd, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  TrackTrust trust;
  for (int window = 0; window < windows; ++window) {
    const double by_gain = window % 2 == 0 ? kByGain : 0.0;
    const double innovation = kSensorSd * normal(random) + kBySlip * slip_sd * normal(random) +
                              by_gain * gain_sd * normal(random);
    trust.add({innovation, square(kSensorSd), kBySlip, by_gain});
  }
  return trust;
}

/// Standard deviation of what the tracks' errors add to a window straight ahead or in a turn.
double added_sd(TrackTrust trust, double by_gain) {
  return std::sqrt(trust.add({kSensorSd, square(kSensorSd), kBySlip, by_gain}));
}

TEST(TrackTrust, AssumesTheWorstBeforeItHasSeenTheFloor) {
  EXPECT_GT(std::sqrt(TrackTrust().slip_variance()), 0.01);
}

TEST(TrackTrust, FindsTheSlipOfAnyFloor) {
  for (const double slip : {1e-3, 3e-3, 1e-2, 3e-2}) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      const double found = std::sqrt(trust_after(30, slip, 0.0, seed).slip_variance());
      EXPECT_GT(found, slip / 2.5) << slip << " seed " << seed;
      EXPECT_LT(found, slip * 2.5) << slip << " seed " << seed;
    }
  }
}

TEST(TrackTrust, BelievesTracksThatAgreeWithTheGyro) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    EXPECT_LT(added_sd(trust_after(5, 0.0, 0.0, seed), 0.0), 10.0 * kSensorSd) << seed;
    EXPECT_LT(added_sd(trust_after(30, 0.0, 0.0, seed), kByGain), 3.0 * kSensorSd) << seed;
  }
}

// A wheelbase that is wrong by a tenth says nothing of straight driving.
TEST(TrackTrust, TellsTurnsThatMisleadFromAFloorThatDoes) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const TrackTrust trust = trust_after(30, 0.0, 0.03, seed);
    EXPECT_LT(added_sd(trust, 0.0), 3.0 * kSensorSd) << seed;
    EXPECT_GT(added_sd(trust, kByGain), 20.0 * kSensorSd) << seed;
  }
}

// From parquet onto ice: the first window on it must not reach the gyro's bias.
TEST(TrackTrust, LeavesTheTracksInTheWindowInWhichTheyBeginToMislead) {
  TrackTrust trust = trust_after(1000, 0.0, 0.0, 1);
  const double innovation = 0.02;
  const double added = trust.add({innovation, square(kSensorSd), kBySlip, 0.0});
  EXPECT_LT(square(kSensorSd) / (square(kSensorSd) + added) * innovation, 3e-5);
}

}  // namespace
}  // namespace tp100::estimation
