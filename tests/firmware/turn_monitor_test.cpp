// Tests the comparison of the gyro with the tracks.

#include <gtest/gtest.h>

#include "../support/wire_host.h"
#include "firmware/track_monitor.h"

namespace tp100::firmware {
namespace {

// A robot on tracks that move over the ground at given speeds, sampled every 5 ms.
class TurnMonitorAlone : public testing::Test {
 protected:
  TurnMonitorAlone() { p.turn_slip_share = 0.15f; }

  /// Runs until a verdict or for `ms`.
  TurnMonitor::Verdict run(double left_mps, double right_mps, int ms) {
    TurnMonitor::Verdict verdict = TurnMonitor::kGood;
    for (int i = 0; i < ms && verdict == TurnMonitor::kGood; i += 5) {
      left_m += left_mps * 5e-3 / 0.84 * left_counted;
      right_m += right_mps * 5e-3 / 0.90 * right_counted;
      turned_rad += ((right_mps - left_mps) / wheelbase_m + gyro_offset_radps) * 5e-3;
      now_us += 5000;
      const double gyro = turned_rad / static_cast<double>(test::kGyroRadpsPerLsb) / 8e-6;
      const TurnMark mark{now_us, static_cast<std::uint32_t>(static_cast<std::int64_t>(gyro)),
                          static_cast<std::int32_t>(left_m * 11140.0),
                          static_cast<std::int32_t>(right_m * 11140.0)};
      verdict = monitor.update(mark, accel_x, 0.0f, p);
    }
    return verdict;
  }
  void restart() {
    monitor.reset();
    left_counted = right_counted = 1.0;
  }

  wire::Parameters p = test::good_parameters();
  TurnMonitor monitor;
  double left_counted = 1.0;
  double right_counted = 1.0;
  double wheelbase_m = 0.274;
  double gyro_offset_radps = 0.0;
  std::int16_t accel_x = 0;

 private:
  std::uint32_t now_us = 0;
  double left_m = 0.0;
  double right_m = 0.0;
  double turned_rad = 0.0;
};

TEST_F(TurnMonitorAlone, ATurnOnTheSpotShowsWhichTrackCountsShort) {
  for (const double mps : {0.08, -0.08}) {
    restart();
    EXPECT_EQ(run(-mps, mps, 20'000), TurnMonitor::kGood) << mps;
    left_counted = 0.3;
    EXPECT_EQ(run(-mps, mps, 20'000), TurnMonitor::kLeftShort) << mps;
    restart();
    right_counted = 0.3;
    EXPECT_EQ(run(-mps, mps, 20'000), TurnMonitor::kRightShort) << mps;
  }
}

// Even the short count of the outer track is higher than that of the inner one.
TEST_F(TurnMonitorAlone, AnArcShowsThatItsOuterTrackCountsShort) {
  for (const double sign : {1.0, -1.0}) {
    restart();
    right_counted = 0.7;
    EXPECT_EQ(run(0.05 * sign, 0.15 * sign, 20'000), TurnMonitor::kRightShort) << sign;
    restart();
    left_counted = 0.7;
    EXPECT_EQ(run(0.15 * sign, 0.05 * sign, 20'000), TurnMonitor::kLeftShort) << sign;
  }
}

TEST_F(TurnMonitorAlone, TheDrivenDistanceExplainsASmallOffsetOfTheGyro) {
  for (const double offset_radps : {0.02, -0.02}) {
    for (const double mps : {0.1, -0.1}) {
      restart();
      gyro_offset_radps = offset_radps;
      EXPECT_EQ(run(mps, mps, 30'000), TurnMonitor::kGood) << offset_radps << " " << mps;
    }
  }
}

// The robot drives straight on at 0.1 m/s, for which its tracks run at 0.115 m/s; that explains a
// turn of 0.1 * 0.115 / 0.274 = 0.042 rad/s. The gyro shows a turn, of which 15 % is explained as
// slip, on a slope 80 %. The rest is a fault at 0.35 rad, or at 0.175 rad if no more than 0.175
// rad/s are counted.
TEST_F(TurnMonitorAlone, ATurnThatTheTracksDoNotMakeIsAFaultAtItsAngle) {
  struct Case {
    double radps;
    std::int16_t accel_x;
    double expected_s;
  };
  for (const Case& one : {Case{0.5, 0, 0.35 / (0.5 * 0.85 - 0.042)},
                          Case{0.2, 0, 0.175 / (0.175 - 0.2 * 0.15 - 0.042)},
                          Case{0.5, 1000, 0.35 / (0.5 * 0.2 - 0.042)}}) {
    for (const double sign : {1.0, -1.0}) {
      restart();
      gyro_offset_radps = 0.0;
      accel_x = 0;
      run(0.1, 0.1, 100);
      accel_x = one.accel_x;
      run(0.1, 0.1, 500);
      gyro_offset_radps = sign * one.radps;
      int ms = 0;
      TurnMonitor::Verdict verdict = TurnMonitor::kGood;
      for (; verdict == TurnMonitor::kGood && ms < 20'000; ms += 5) verdict = run(0.1, 0.1, 5);
      EXPECT_NEAR(ms * 1e-3, one.expected_s, 0.1) << one.radps << ' ' << one.accel_x;
      EXPECT_EQ(verdict, sign > 0.0 ? TurnMonitor::kRightShort : TurnMonitor::kLeftShort);
    }
  }
}

TEST_F(TurnMonitorAlone, EveryKindOfTurnHasItsWheelbase) {
  p.turn_slip_share = 0.0f;
  p.wheelbase_tight_m = 0.8f;
  p.wheelbase_spin_m = 0.5f;
  struct Case {
    double left_mps, right_mps, wheelbase_m;
  };
  // The tracks' difference is 0.33, 0.5, 0.65, 1.3 and 2 times the speed of the faster one.
  for (const Case& one : {Case{0.07, 0.105, 0.274}, Case{0.05, 0.1, 0.537}, Case{0.035, 0.1, 0.8},
                          Case{-0.03, 0.1, 0.5}, Case{-0.1, 0.1, 0.5}}) {
    restart();
    wheelbase_m = one.wheelbase_m;
    EXPECT_EQ(run(one.left_mps, one.right_mps, 20'000), TurnMonitor::kGood) << one.left_mps;
    wheelbase_m = 0.4 * one.wheelbase_m;
    EXPECT_NE(run(one.left_mps, one.right_mps, 20'000), TurnMonitor::kGood) << one.left_mps;
  }
}

// Half of the turn by the gyro over the distance driven: on the spot 0.45 and full load; in an arc
// of 0.12 half of it, which is less on a wider one; straight on none.
TEST_F(TurnMonitorAlone, ATurnMayTakeMoreDutyTheTighterItIsAndShortlyAfterIt) {
  p.turn_slip_share = 1.0f;
  const auto turn_duty = [&](double left_mps, double right_mps) {
    restart();
    run(left_mps, right_mps, 2000);
    return static_cast<double>(monitor.turn_duty());
  };
  EXPECT_EQ(turn_duty(0.1, 0.1), 0.0);
  for (const double sign : {1.0, -1.0}) {
    EXPECT_NEAR(turn_duty(-0.08 * sign, 0.08 * sign), 0.3, 0.01);
    const double wide = turn_duty(0.1 - 0.005 * sign, 0.1 + 0.005 * sign);
    EXPECT_NEAR(turn_duty(0.1 - 0.01 * sign, 0.1 + 0.01 * sign), 2.0 * wide, 0.01);
    EXPECT_GT(wide, 0.02);
  }
  turn_duty(-0.08, 0.08);
  run(0.1, 0.1, 500);
  EXPECT_NEAR(static_cast<double>(monitor.turn_duty()), 0.15, 0.02) << "it falls by 0.3 a second";
}

TEST_F(TurnMonitorAlone, TheLoadOfASlopeEndsSlowlyAfterIt) {
  run(0.1, 0.1, 1000);
  EXPECT_EQ(monitor.slope_duty(), 0.0f);
  accel_x = 1000;  // 7 degrees
  run(0.1, 0.1, 1000);
  const float on_slope = monitor.slope_duty();
  EXPECT_GT(on_slope, 0.2f);
  accel_x = 0;
  run(0.1, 0.1, 500);
  EXPECT_GT(monitor.slope_duty(), 0.5f * on_slope);
  EXPECT_LT(monitor.slope_duty(), on_slope);
  run(0.1, 0.1, 3000);
  EXPECT_EQ(monitor.slope_duty(), 0.0f);
}

}  // namespace
}  // namespace tp100::firmware
