#include "control/hand_drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/arithmetic.h"

namespace tp100::control {
namespace {

constexpr double kHandCycleS = 0.005;

class HandDriveInputs : public testing::Test {
 protected:
  HandDriveInputs() { drive_.restart(now_); }

  void want(double speed_mps, double yaw_rate_radps) {
    drive_.take({now_, speed_mps, yaw_rate_radps}, now_);
  }
  /// The last command after `duration_s`, with or without fresh input of the person.
  HandCommand run(double duration_s, bool fresh = true) {
    HandCommand out;
    for (double t = 0.0; t < duration_s - kHandCycleS / 2.0; t += kHandCycleS) {
      now_ += from_s(kHandCycleS);
      if (fresh) want(speed_mps_, yaw_rate_radps_);
      out = drive_.update(state_, parameters_, now_, kHandCycleS);
    }
    return out;
  }

  Parameters parameters_{};
  HandDriveState state_{};
  HandDrive drive_{std::nullopt};
  HostNs now_ = kNsPerS;
  double speed_mps_ = 0.0, yaw_rate_radps_ = 0.0;
};

TEST_F(HandDriveInputs, SpeedGrowsWithTheAccelerationUpToTheTracksLimit) {
  speed_mps_ = 5.0;
  EXPECT_NEAR(run(0.5).speed_mps, 0.5 * parameters_.acceleration_mps2, 0.002);
  EXPECT_LE(run(5.0).speed_mps, state_.limits.max_track_mps);
  EXPECT_NEAR(run(0.1).speed_mps, state_.limits.max_track_mps, 1e-9);
}

TEST_F(HandDriveInputs, TheYawRateGrowsWithThePivotAccelerationUpToTheRobotsLimit) {
  yaw_rate_radps_ = -9.0;
  EXPECT_NEAR(run(0.2).yaw_rate_radps, -0.2 * parameters_.pivot_acceleration_radps2, 0.01);
  EXPECT_EQ(run(5.0).yaw_rate_radps, -state_.limits.max_yaw_radps);
}

TEST_F(HandDriveInputs, SlowingDownTakesEffectAtOnceAndReversingPassesThroughZero) {
  speed_mps_ = 0.15;
  run(2.0);
  speed_mps_ = 0.05;
  EXPECT_EQ(run(kHandCycleS).speed_mps, 0.05);
  speed_mps_ = -0.15;
  const double reversed_mps = run(kHandCycleS).speed_mps;
  EXPECT_LE(reversed_mps, 0.0);
  EXPECT_GE(reversed_mps, -parameters_.acceleration_mps2 * kHandCycleS - 1e-12);
}

TEST_F(HandDriveInputs, AnOldInputIsWorthAStandstillAtOnce) {
  speed_mps_ = 0.15;
  yaw_rate_radps_ = 0.5;
  run(2.0);
  EXPECT_GT(run(0.150, false).speed_mps, 0.0);
  const HandCommand late = run(kHandCycleS, false);
  EXPECT_EQ(late.speed_mps, 0.0);
  EXPECT_EQ(late.yaw_rate_radps, 0.0);
  EXPECT_EQ(late.desired_yaw_rad, state_.pose.yaw_rad);
}

TEST_F(HandDriveInputs, AnInputFromBeforeTheDriveOrBeforeTheNewestOneDoesNotCount) {
  drive_.take({now_ - 1, 0.1, 0.0}, now_);
  EXPECT_EQ(run(0.1, false).speed_mps, 0.0);
  want(0.0, 0.0);
  drive_.take({now_ - 50 * kNsPerMs, 0.1, 0.0}, now_);
  EXPECT_EQ(run(0.05, false).speed_mps, 0.0);
}

TEST_F(HandDriveInputs, AnInputFromTheFutureIsNoFresherThanNow) {
  drive_.take({now_ + 3600 * kNsPerS, 0.1, 0.0}, now_);
  EXPECT_GT(run(0.1, false).speed_mps, 0.0);
  EXPECT_EQ(run(0.1, false).speed_mps, 0.0);
}

TEST_F(HandDriveInputs, SilenceCountsFromTheLastInputOfAnyKind) {
  run(10.0);
  EXPECT_FALSE(drive_.silent(now_));
  run(2.0, false);
  EXPECT_FALSE(drive_.silent(now_));
  run(kHandCycleS, false);
  EXPECT_TRUE(drive_.silent(now_));
}

TEST_F(HandDriveInputs, ABlockedTurnDoesNotWindUp) {
  yaw_rate_radps_ = 1.0;
  EXPECT_LT(run(30.0).desired_yaw_rad, 10.0 * kRadPerDeg);
  yaw_rate_radps_ = 0.0;
  EXPECT_EQ(run(kHandCycleS).desired_yaw_rad, state_.pose.yaw_rad);
}

TEST_F(HandDriveInputs, ATurnBeginsFromTheYawOfTheNewDrive) {
  yaw_rate_radps_ = 0.5;
  run(1.0);
  drive_.restart(now_);
  state_.pose.yaw_rad = 2.0;
  EXPECT_NEAR(run(kHandCycleS).desired_yaw_rad,
              2.0 + parameters_.pivot_acceleration_radps2 * kHandCycleS * kHandCycleS, 1e-9);
}

TEST_F(HandDriveInputs, StraightOnTheYawIsHeldOnceTheTurnIsOver) {
  speed_mps_ = 0.1;
  state_.measured_yaw_rate_radps = 0.4;
  run(0.5);
  state_.pose.yaw_rad = 0.3;
  EXPECT_EQ(run(kHandCycleS).desired_yaw_rad, 0.3) << "the robot still turns";
  state_.measured_yaw_rate_radps = 0.0;
  run(0.1);
  state_.pose.yaw_rad = 0.35;
  EXPECT_NEAR(run(0.1).desired_yaw_rad, 0.3, 1e-9);
}

TEST_F(HandDriveInputs, ATurnOnTheSpotThatFrictionHoldsIsNone) {
  yaw_rate_radps_ = 0.02;
  EXPECT_EQ(run(1.0).yaw_rate_radps, 0.0);
  speed_mps_ = 0.1;
  EXPECT_EQ(run(1.0).yaw_rate_radps, 0.02) << "while driving it is a wide curve";
}

TEST_F(HandDriveInputs, ATurnAgainstTheOneBeforeBeginsWhenThatOneIsOver) {
  yaw_rate_radps_ = 1.0;
  run(2.0);
  yaw_rate_radps_ = -1.0;
  state_.measured_yaw_rate_radps = 1.0;
  state_.pose.yaw_rad = 0.1;
  const HandCommand still_turning = run(0.3);
  EXPECT_EQ(still_turning.yaw_rate_radps, 0.0);
  EXPECT_EQ(still_turning.desired_yaw_rad, state_.pose.yaw_rad);
  state_.measured_yaw_rate_radps = 0.1;
  EXPECT_LT(run(0.2).yaw_rate_radps, -0.2);
}

TEST_F(HandDriveInputs, ATurnOnTheSpotWithATrackAtItsLimitStaysOnTheSpot) {
  yaw_rate_radps_ = state_.limits.max_yaw_radps;
  for (const double slip : {0.3, 0.0}) {
    state_.limits.slip_left = slip;
    state_.limits.slip_right = 0.3 - slip;
    EXPECT_EQ(run(2.0).speed_mps, 0.0) << slip;
  }
}

class FenceLimit : public testing::Test {
 protected:
  double inside(double x_m, double y_m, double yaw_deg, double speed_mps,
                double yaw_rate_radps = 0.0, double uncertainty_m = 0.0) const {
    return speed_inside(speed_mps,
                        {.pose = {.x_m = x_m, .y_m = y_m, .yaw_rad = yaw_deg * kRadPerDeg},
                         .yaw_rate_radps = yaw_rate_radps,
                         .uncertainty_m = uncertainty_m},
                        fence_);
  }
  course::Fence fence_{-1.0, 1.0, -0.5, 0.5};
};

TEST_F(FenceLimit, FarFromTheFenceNothingIsLimited) {
  EXPECT_EQ(inside(0.0, 0.0, 33.0, 0.2), 0.2);
  EXPECT_EQ(inside(0.0, 0.0, 33.0, -0.2), -0.2);
}

TEST_F(FenceLimit, TheNearerTheFenceAheadTheSlowerAndAtItNothing) {
  double last_mps = 0.2;
  for (double x_m = 0.8; x_m < 1.0; x_m += 0.001) {
    const double mps = inside(x_m, 0.0, 0.0, 0.2);
    EXPECT_LE(mps, last_mps);
    last_mps = mps;
  }
  EXPECT_EQ(inside(0.995, 0.0, 0.0, 0.2), 0.0);
  EXPECT_EQ(inside(0.995, 0.0, 0.0, -0.2), -0.2) << "back is free";
  EXPECT_EQ(inside(-0.995, 0.0, 0.0, -0.2), 0.0);
}

TEST_F(FenceLimit, OutsideOnlyTheWayInIsLeft) {
  EXPECT_EQ(inside(1.3, 0.0, 0.0, 0.1), 0.0);
  EXPECT_EQ(inside(1.3, 0.0, 90.0, 0.1), 0.0) << "along the fence is no way in";
  EXPECT_EQ(inside(1.3, 0.0, 0.0, -0.1), -0.1);
  EXPECT_EQ(inside(1.3, 0.7, 225.0, 0.1), 0.1) << "outside a corner, towards the inside of both";
  EXPECT_EQ(inside(1.3, 0.7, 180.0, 0.1), 0.0);
}

TEST_F(FenceLimit, ATurnTowardsTheFenceCountsBeforeItHappens) {
  EXPECT_EQ(inside(0.9, 0.47, 0.0, 0.1, 0.0), 0.1);
  EXPECT_LT(inside(0.7, 0.487, 0.0, 0.2, 1.2), 0.2);
}

TEST_F(FenceLimit, AnUncertainPositionKeepsAwayButNeverTakesTheWholeFence) {
  EXPECT_LT(inside(0.9, 0.0, 0.0, 0.2, 0.0, 0.05), inside(0.9, 0.0, 0.0, 0.2));
  EXPECT_EQ(inside(0.0, 0.0, 0.0, 0.2, 0.0, 100.0), 0.2);
}

TEST_F(FenceLimit, ACornerOfAPolygonIsAnEdgeLikeAnyOther) {
  const double rectangle = inside(0.93, 0.1, 20.0, 0.2);
  fence_.corners = course::corners_of(fence_);
  EXPECT_NEAR(inside(0.93, 0.1, 20.0, 0.2), rectangle, 1e-9);
  // A dent from above, with its tip at (0, 0).
  fence_.corners = {{-1.0, -0.5}, {1.0, -0.5}, {1.0, 0.5}, {0.2, 0.5},
                    {0.0, 0.0},   {-0.2, 0.5}, {-1.0, 0.5}};
  EXPECT_EQ(inside(-0.005, 0.0, 0.0, 0.2), 0.0) << "at the tip";
  EXPECT_EQ(inside(-0.005, 0.0, 0.0, -0.2), -0.2);
  EXPECT_LT(inside(-0.1, 0.0, 0.0, 0.2), 0.2);
  EXPECT_EQ(inside(0.0, 0.3, 90.0, 0.1), 0.0) << "in the dent, deeper";
  EXPECT_EQ(inside(0.02, 0.1, -15.0, 0.1), 0.1) << "in the dent, the short way out";
}

TEST_F(FenceLimit, KeepOutAreasAreNotEntered) {
  fence_.keep_out = {{{0.0, -0.1}, {0.3, -0.1}, {0.3, 0.1}, {0.0, 0.1}}};
  EXPECT_EQ(inside(-0.005, 0.0, 0.0, 0.2), 0.0);
  EXPECT_EQ(inside(-0.005, 0.0, 180.0, 0.2), 0.2) << "away from it";
  EXPECT_EQ(inside(-0.6, 0.0, 0.0, 0.2), 0.2) << "far from it";
  EXPECT_EQ(inside(0.02, 0.0, 0.0, 0.2), 0.0) << "inside of it, deeper";
  EXPECT_EQ(inside(0.02, 0.0, 180.0, 0.2), 0.2) << "inside of it, the short way out";
}

TEST_F(FenceLimit, StraightAwayFromACornerOfAnAreaNothingIsLimited) {
  fence_.keep_out = {{{0.0, 0.0}, {0.3, -0.1}, {0.3, 0.1}}};
  for (double yaw_deg = 110.0; yaw_deg < 250.0; yaw_deg += 0.1) {
    const double yaw_rad = yaw_deg * kRadPerDeg;
    EXPECT_EQ(inside(0.005 * std::cos(yaw_rad), 0.005 * std::sin(yaw_rad), yaw_deg, 0.2), 0.2)
        << yaw_deg;
  }
}

TEST_F(FenceLimit, NeverReversesNorSpeedsUp) {
  std::mt19937 random(1);
  std::uniform_real_distribution<> any(-1.0, 1.0);
  for (int i = 0; i < 100000; ++i) {
    const double wanted = 0.3 * any(random);
    const double got = inside(1.5 * any(random), any(random), 180.0 * any(random), wanted,
                              1.5 * std::abs(any(random)), 0.1 * std::abs(any(random)));
    EXPECT_GE(got * wanted, 0.0);
    EXPECT_LE(std::abs(got), std::abs(wanted));
  }
}

}  // namespace
}  // namespace tp100::control
