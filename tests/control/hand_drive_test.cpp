// Driving by hand within the limits of fence and tracks.

#include "control/hand_drive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "control/track_limits.h"
#include "core/arithmetic.h"
#include "firmware/yaw_loop.h"
#include "support/sequence.h"

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

// Up to the limits of tracks and robot. Reversing passes through zero.
TEST_F(HandDriveInputs, SpeedAndYawRateGrowWithTheirAccelerationsAndSlowDownAtOnce) {
  test::Sequence any(30);
  const auto eased = [](double from, double to, double most, double step) {
    if (from * to <= 0.0) from = 0.0;
    return std::clamp(std::clamp(to, -most, most), std::min(from - step, 0.0),
                      std::max(from + step, 0.0));
  };
  double speed_mps = 0.0, yaw_rate_radps = 0.0;
  for (int i = 0; i < 400; ++i) {
    const bool turns = any.chance(0.5);
    speed_mps_ = turns ? 0.0 : any.between(-0.4, 0.4);
    yaw_rate_radps_ = turns ? std::copysign(any.between(0.1, 2.0), any.between(-1.0, 1.0)) : 0.0;
    for (int step = 1 + any.below(200); step > 0; --step) {
      speed_mps = eased(speed_mps, speed_mps_, state_.limits.max_track_mps,
                        parameters_.acceleration_mps2 * kHandCycleS);
      yaw_rate_radps = eased(yaw_rate_radps, yaw_rate_radps_, state_.limits.max_yaw_radps,
                             parameters_.pivot_acceleration_radps2 * kHandCycleS);
      const HandCommand out = run(kHandCycleS);
      ASSERT_NEAR(out.speed_mps, speed_mps, 1e-9) << i;
      ASSERT_NEAR(out.yaw_rate_radps, yaw_rate_radps, 1e-9) << i;
    }
  }
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
  want(0.0, 0.0);
  want(0.1, 0.0);
  EXPECT_GT(run(0.05, false).speed_mps, 0.0) << "of two at one time the later one counts";
}

TEST_F(HandDriveInputs, AnInputFromTheFutureIsNoFresherThanNow) {
  drive_.take({now_ + 3600 * kNsPerS, 0.1, 0.0}, now_);
  EXPECT_GT(run(0.1, false).speed_mps, 0.0);
  EXPECT_EQ(run(0.1, false).speed_mps, 0.0);
}

TEST_F(HandDriveInputs, IsSilentAfterExactlyTheSilenceSinceTheLastInputOfAnyKind) {
  run(10.0);
  EXPECT_FALSE(drive_.silent(now_ + kDriveSilenceNs));
  EXPECT_TRUE(drive_.silent(now_ + kDriveSilenceNs + 1));
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
  yaw_rate_radps_ = 0.049;
  EXPECT_EQ(run(1.0).yaw_rate_radps, 0.0);
  speed_mps_ = 0.1;
  EXPECT_EQ(run(1.0).yaw_rate_radps, 0.049) << "while driving it is a wide curve";
  speed_mps_ = 0.0;
  yaw_rate_radps_ = 0.051;
  EXPECT_EQ(run(1.0).yaw_rate_radps, 0.051);
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

// With 40 % of the file's braking b, a robot at v needs 0.16 v + v^2 / 2b to stop, where 0.16 s
// pass before the tracks react. It may head up to 4 deg, and what it turns in that time, nearer to
// an edge. The margin to the edge is 1 cm and two deviations of the position, up to 3 cm and 15 %
// of the shorter side, less what the pose may be wrong by. Where less than 1 cm/s is left, none is.
TEST_F(FenceLimit, TheSpeedIsTheGreatestFromWhichItStopsInside) {
  test::Sequence any(31);
  int limited = 0;
  for (int i = 0; i < 20000; ++i) {
    fence_ = {-1.0, 1.0, i % 5 == 0 ? -0.08 : -0.5, i % 5 == 0 ? 0.07 : 0.5};
    const double side_m = std::min(2.0, fence_.max_y_m - fence_.min_y_m);
    const FenceMotion motion{.pose = {.x_m = any.between(-0.99, 0.99),
                                      .y_m = any.between(fence_.min_y_m, fence_.max_y_m),
                                      .yaw_rad = any.between(-7.0, 7.0)},
                             .yaw_rate_radps = i % 2 == 0 ? 0.0 : any.between(0.0, 1.5),
                             .braking_mps2 = any.between(0.2, 1.0),
                             .uncertainty_m = i % 3 == 0 ? 0.0 : any.between(0.0, 0.02),
                             .tolerance_m = i % 7 == 0 ? 0.006 : 0.0};
    const double wanted = any.between(-0.4, 0.4);
    const double got = speed_inside(wanted, motion, fence_);
    ASSERT_TRUE(got * wanted >= 0.0 && std::abs(got) <= std::abs(wanted)) << i;
    const double margin_m =
        std::min({0.01 + 2.0 * motion.uncertainty_m, 0.03, 0.15 * side_m}) - motion.tolerance_m;
    /// Room that is left at the nearest edge by a robot that stops from this speed.
    const auto room_m = [&](double mps) {
      double least_m = 9.0;
      const double ahead = motion.pose.yaw_rad + (mps < 0.0 ? kPi : 0.0);
      const double nearer = 4.0 * kRadPerDeg + 0.16 * motion.yaw_rate_radps;
      const std::pair<double, double> edges[] = {{0.0, fence_.max_x_m - motion.pose.x_m},
                                                 {kPi, motion.pose.x_m - fence_.min_x_m},
                                                 {kPi / 2, fence_.max_y_m - motion.pose.y_m},
                                                 {-kPi / 2, motion.pose.y_m - fence_.min_y_m}};
      for (const auto& [direction, distance_m] : edges) {
        const double angle = std::max(0.0, std::abs(wrap_angle(direction - ahead)) - nearer);
        const double towards = std::abs(mps) * std::cos(angle);
        if (std::cos(angle) <= 0.0) continue;
        const auto stops_m = [&](double from_mps) {
          return 0.16 * from_mps + from_mps * from_mps / (2.0 * 0.4 * motion.braking_mps2);
        };
        const double room = distance_m - margin_m;
        least_m = std::min(least_m, room < stops_m(0.01) ? -1.0 : room - stops_m(towards));
      }
      return least_m;
    };
    if (got != 0.0) {
      ASSERT_GE(room_m(got), -1e-9) << i;
    }
    if (got == wanted) continue;
    ++limited;
    ASSERT_LT(room_m(std::copysign(std::max(std::abs(got), 1e-6) * 1.0001, wanted)), 1e-5) << i;
  }
  EXPECT_GT(limited, 2000);
}

TEST_F(FenceLimit, OutsideOnlyTheWayInIsLeft) {
  EXPECT_EQ(inside(1.3, 0.0, 0.0, 0.1), 0.0);
  EXPECT_EQ(inside(1.3, 0.0, 90.0, 0.1), 0.0) << "along the fence is no way in";
  EXPECT_EQ(inside(1.3, 0.0, 0.0, -0.1), -0.1);
  EXPECT_EQ(inside(1.3, 0.7, 225.0, 0.1), 0.1) << "outside a corner, towards the inside of both";
  EXPECT_EQ(inside(1.3, 0.7, 180.0, 0.1), 0.0);
}

TEST_F(FenceLimit, ACornerOfAPolygonIsAnEdgeLikeAnyOther) {
  course::Fence polygon = fence_;
  polygon.corners = course::corners_of(fence_);
  test::Sequence any(7);
  for (int i = 0; i < 1000; ++i) {
    const FenceMotion motion{.pose = {.x_m = any.between(-1.0, 1.0),
                                      .y_m = any.between(-0.5, 0.5),
                                      .yaw_rad = any.between(-4.0, 4.0)},
                             .yaw_rate_radps = any.between(0.0, 1.0)};
    const double wanted = any.between(-0.4, 0.4);
    ASSERT_NEAR(speed_inside(wanted, motion, polygon), speed_inside(wanted, motion, fence_), 1e-9);
  }
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

constexpr TrackLimits kLimits{.wheelbase_m = 0.27,
                              .slip_left = 0.10,
                              .slip_right = 0.16,
                              .max_track_mps = 0.2,
                              .yaw_kp = 4.0,
                              .max_yaw_radps = 1.2};

// Else the desired yaw would move away from what the robot does.
TEST(TrackLimits, TheTurnAskedIsTheFirmwares) {
  wire::Parameters sent = {};
  sent.yaw_kp = static_cast<float>(kLimits.yaw_kp);
  sent.max_yaw_radps = static_cast<float>(kLimits.max_yaw_radps);
  test::Sequence any(33);
  for (int i = 0; i < 1000; ++i) {
    const double error_rad = any.between(-1.0, 1.0), turn_radps = any.between(-0.3, 0.3);
    EXPECT_NEAR(turn_asked(error_rad, turn_radps, kLimits),
                static_cast<double>(firmware::turn_rate(static_cast<float>(error_rad),
                                                        static_cast<float>(turn_radps), sent)),
                1e-5);
  }
}

// The greatest speed at which the firmware cuts nothing.
TEST(TrackLimits, TheSpeedAlongACurveLeavesTheTracksWhatTheTurnNeeds) {
  for (const double wheelbase_m : {0.27, 0.5}) {
    TrackLimits limits = kLimits;
    limits.wheelbase_m = wheelbase_m;
    const auto driven = [&](double speed, double error, double curvature) {
      return skid_steer(limits).speed_within(speed, turn_asked(error, curvature * speed, limits));
    };
    for (const double error : {-0.5, -0.1, 0.0, 0.2, 1.0}) {
      for (const double curvature : {-8.0, 0.0, 3.0, 20.0}) {
        SCOPED_TRACE(testing::Message() << wheelbase_m << ' ' << error << ' ' << curvature);
        const double speed = speed_along(0.3, error, curvature, limits);
        ASSERT_GE(speed, 0.0);
        if (speed > 0.0) {
          EXPECT_NEAR(driven(speed, error, curvature), speed, 1e-5);
        }
        EXPECT_LT(driven(speed + 1e-3, error, curvature), speed + 9e-4);
      }
    }
  }
}

}  // namespace
}  // namespace tp100::control
