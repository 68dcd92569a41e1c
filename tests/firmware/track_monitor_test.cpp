// Faults of tracks and encoders switch the motors off: judged by each track's duty, and by the
// gyro.
#include "firmware/track_monitor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/wire_host.h"
#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::Fault;

/// What a track does at some time, and what the firmware knows of the robot.
struct Moment {
  double mps, duty;
  double load = 0.0;  ///< duty that slopes and turns may take
};

struct Found {
  TrackMonitor::Verdict verdict;
  double after_s;
};

/// The fault of a track that moves as `at(s)` says, if there is one within `limit_s`.
template <class At>
Found find(const wire::Parameters& p, double limit_s, At at) {
  TrackMonitor monitor(16);
  const MonitorValues values(p);
  TrackMonitor::Verdict verdict = TrackMonitor::kGood;
  double counts = 0.0, s = 0.0;
  for (; s < limit_s; s += 5e-3) {
    const Moment now = at(s);
    counts += now.mps * 5e-3 * static_cast<double>(p.counts_per_metre);
    verdict = monitor.update(static_cast<std::int16_t>(std::lround(now.duty * wire::kFullDuty)),
                             static_cast<std::int32_t>(std::lround(counts)), 5,
                             static_cast<std::int16_t>(std::lround(now.load * wire::kFullDuty)),
                             now.load < 0.05, values, p);
    if (verdict != TrackMonitor::kGood) break;
  }
  return {verdict, s};
}

// After 0.3 s of motion the track is blocked for stall_ms.
TEST(TrackMonitorAlone, ATrackThatStandsAtItsStallDutyIsStalledAndBelowItNot) {
  wire::Parameters p = test::good_parameters();
  p.feed_forward = 0.0f;  // the duty gives no estimate of the speed
  p.dead_band = 0.0f;
  for (const std::uint16_t stall_duty : {std::uint16_t{1}, std::uint16_t{600}}) {
    p.stall_duty = stall_duty;
    for (const int sign : {1, -1}) {
      const auto blocked_with = [&](int duty) {
        return find(p, 2.0, [&](double s) {
          return Moment{s < 0.3 ? sign * 0.1 : 0.0, 1e-3 * sign * duty};
        });
      };
      EXPECT_EQ(blocked_with(stall_duty).verdict, TrackMonitor::kStalled);
      EXPECT_NEAR(blocked_with(stall_duty).after_s, 1.3, 0.025) << stall_duty << " " << sign;
      EXPECT_EQ(blocked_with(stall_duty - 1).verdict, TrackMonitor::kGood);
    }
  }
}

TEST(TrackMonitorAlone, ATrackWithoutDutyMayMoveAndOneAgainstItsDutyIsReversedBothWays) {
  wire::Parameters p = test::good_parameters();
  for (const double mps : {0.1, -0.1}) {
    p.dead_band = 0.15f;
    const Found reversed = find(p, 2.0, [&](double) { return Moment{mps, -3.0 * mps}; });
    EXPECT_EQ(reversed.verdict, TrackMonitor::kReversed);
    // A braking track may run on for 2 cm and for 0.2 s at its top speed.
    EXPECT_NEAR(reversed.after_s, 0.06 / 0.1, 0.006) << mps;
    p.dead_band = 0.0f;  // any duty would move the track
    const Found coasts = find(p, 2.0, [&](double) { return Moment{mps, 0.0}; });
    EXPECT_EQ(coasts.verdict, TrackMonitor::kGood) << mps;
  }
}

// The duty above the dead band of 15 % and a margin of 2 %, less what load and counted speed
// explain (the speed at 1.1 times the highest gain of 1.4), is 1/4 m/s for each unit. At 4 cm the
// track is stalled, but no sooner than in 0.8 times stall_ms; judged in steps of 80 ms.
TEST(TrackMonitorAlone, ATrackIsStalledByTheDistanceThatItsDutyImpliesAndNobodyCounted) {
  struct Case {
    double duty, load, mps, expected_s;
  };
  const wire::Parameters p = test::good_parameters();
  for (const Case& one : {Case{0.2, 0.0, 0.0, 0.04 / (0.03 / 4.0)},
                          {0.3, 0.0, 0.0, 0.04 / (0.13 / 4.0)},
                          {0.3, 0.1, 0.0, 0.04 / (0.03 / 4.0)},
                          {0.3, 0.0, 0.01, 0.04 / ((0.13 - 1.1 * 1.4 * 0.04) / 4.0)},
                          {0.59, 0.0, 0.0, 0.8}}) {
    for (const int sign : {1, -1}) {
      const Found stalled = find(p, 10.0, [&](double) {
        return Moment{sign * one.mps, sign * one.duty, one.load};
      });
      EXPECT_NEAR(stalled.after_s, one.expected_s, 0.1)
          << one.duty << ' ' << one.load << ' ' << one.mps;
    }
  }
}

// In a tight arc the outer track drags the inner one along, which brakes all the time.
TEST(TrackMonitorAlone, ATrackThatBrakesAgainstTheFloorInATurnIsNotReversed) {
  const wire::Parameters p = test::good_parameters();
  const auto reversed_after_s = [&](double load) {
    return find(p, 60.0, [&](double) { return Moment{0.008, -0.25, load}; }).after_s;
  };
  EXPECT_GE(reversed_after_s(0.3), 60.0);
  EXPECT_LT(reversed_after_s(0.0), 10.0) << "nothing drags the track on a straight line";
}

/// Duty of an unloaded track at this speed.
double usual_duty(const wire::Parameters& p, double mps, double gain = 1.0) {
  return static_cast<double>(p.dead_band) + gain * static_cast<double>(p.feed_forward) * mps;
}

// Stiction: at a low speed the duty is below that of the robot's file, at a higher speed it is
// equal.
TEST(TrackMonitorAlone, AGainLearntAtALowSpeedIsNotThatOfAHigherOne) {
  const wire::Parameters p = test::good_parameters();
  for (const double slow_mps : {0.03, 0.036, 0.05}) {
    for (const double fast_mps : {0.06, 0.1, 0.2}) {
      const Found found = find(p, 60.0, [&](double s) {
        const bool slow = static_cast<int>(s / 10.0) % 2 == 0;
        const double mps = slow ? slow_mps : fast_mps;
        return Moment{mps, usual_duty(p, mps) - (slow ? 0.03 : 0.0)};
      });
      EXPECT_EQ(found.verdict, TrackMonitor::kGood)
          << found.after_s << " s, " << slow_mps << " and " << fast_mps << " m/s";
    }
  }
}

// Steering alternately loads a track and relieves it: its gain becomes the mean, with which the
// load of an arc, somewhat larger than the gyro implies, is not a stall.
TEST(TrackMonitorAlone, SmallTurnsOnAStraightTeachNoLowerGain) {
  const wire::Parameters p = test::good_parameters();
  for (const double mps : {0.06, 0.1, 0.16}) {
    const Found found = find(p, 40.0, [&](double s) {
      const double usual = usual_duty(p, mps, 0.9);
      if (s >= 15.0) return Moment{mps, usual + 0.16, 0.14};
      return Moment{mps, usual + (static_cast<int>(s / 0.5) % 2 == 0 ? -0.04 : 0.04), 0.04};
    });
    EXPECT_EQ(found.verdict, TrackMonitor::kGood) << found.after_s << " s at " << mps << " m/s";
  }
}

// A robot that has driven straight on for two seconds.
class DrivingRig : public Rig {
 public:
  explicit DrivingRig(float speed = 0.1f) {
    tracks_follow = true;
    drive(speed);
    driven_m(2000);
    EXPECT_EQ(program.faults(), 0) << speed;
  }
  /// Drives on by the true yaw, straight or in an arc, until a fault occurs or `ms` are over;
  /// returns the distance.
  double driven_m(int ms) {
    const double from_m = true_m;
    for (int i = 0; i < ms / 5 && program.faults() == 0; ++i) {
      yaw_rad = static_cast<float>(true_yaw_rad);
      if (yaw_rate_radps != 0.0f) desired_yaw_rad = yaw_rad;
      run(5);
    }
    return true_m - from_m;
  }
};

constexpr float kSpeeds[] = {0.03f, 0.06f, 0.1f, 0.15f};

TEST(FailSafe, ATrackThatRunsAgainstItsDutyIsReversed) {
  for (const bool left : {false, true}) {
    Rig rig;
    rig.parameters.flags = left ? wire::kInvertLeftMotor : wire::kInvertRightMotor;
    rig.tracks_follow = true;
    rig.drive(0.15f);
    rig.run(1500);
    EXPECT_EQ(rig.program.faults(), mask(left ? Fault::reversed_left : Fault::reversed_right));
    EXPECT_FALSE(rig.motors_on());
  }
}

// On a stand the tracks turn and the body does not.
TEST(FailSafe, WithoutTheGyroItDoesNotJudgeTheTracks) {
  Rig rig;
  rig.tracks_follow = true;
  rig.parameters.flags = 0;
  rig.parameters.turn_slip_share = 0.15f;
  rig.drive(0.1f);
  rig.disturbance_radps = 0.6;
  rig.run(3000);
  EXPECT_EQ(rig.program.faults(), 0);
  EXPECT_EQ(rig.program.state(), wire::State::kRunning);
}

// The robot pitches while it speeds up; its level is that of the standstill before.
TEST(FailSafe, AnEncoderThatLosesCountsIsFoundHoweverHardTheRobotStarts) {
  for (const double mps2 : {0.1, 0.6, 2.0}) {
    for (const bool left : {true, false}) {
      Rig rig;
      rig.tracks_follow = true;
      rig.parameters.turn_slip_share = 0.05f;
      rig.parameters.stall_duty = 0;
      rig.be_ready();
      rig.arm();
      rig.run(20);
      rig.speed_mps = 0.15f;
      rig.hal.accel_x = static_cast<std::int16_t>(mps2 / 9.81 * 8192.0);
      rig.run(static_cast<int>(150.0 / mps2));
      rig.hal.accel_x = 0;
      rig.run(1000);
      ASSERT_EQ(rig.program.faults(), 0) << mps2;
      const double before_rad = rig.true_yaw_rad;
      (left ? rig.left_counted : rig.right_counted) = 0.6;
      for (int i = 0; i < 1600 && rig.program.faults() == 0; ++i) rig.run(5);
      EXPECT_EQ(rig.program.faults(), mask(left ? Fault::stalled_left : Fault::stalled_right));
      EXPECT_LT(std::abs(rig.true_yaw_rad - before_rad), 0.6) << mps2;
    }
  }
}

TEST(FailSafe, BothTracksThatCountShortInAnArcAreFoundByTheMeanOfTheirDuties) {
  DrivingRig rig;
  rig.yaw_rate_radps = 0.3f;
  rig.driven_m(1000);
  rig.left_counted = rig.right_counted = 0.7;
  EXPECT_LT(rig.driven_m(20'000) * 0.3, 0.15);
  EXPECT_EQ(rig.program.faults(), mask(Fault::stalled_left) | mask(Fault::stalled_right));
}

TEST(FailSafe, ALoadThatTheAccelerometerExplainsIsNoFaultOfAnEncoder) {
  for (const bool steep : {true, false}) {
    DrivingRig rig;
    rig.load_duty = 0.25;
    if (steep) rig.hal.accel_x = 1600;
    rig.driven_m(10'000);
    EXPECT_EQ(rig.program.faults() != 0, !steep);
    rig.hal.accel_x = 0;
    rig.driven_m(10'000);
    EXPECT_NE(rig.program.faults(), 0) << "the load continues after the slope";
  }
}

// The resistance against turning falls slowly with the radius (Nikitin's formula); on soft tracks
// wide arcs take a third of the duty of the spot.
TEST(FailSafe, TheResistanceOfAnArcIsNoFaultOfAnEncoder) {
  constexpr double kOnTheSpotDuty = 0.28, kGaugeM = 0.155;
  for (const double speed_mps : {0.05, 0.1, 0.15}) {
    for (const double radius_m : {0.4, 0.8, 1.2, 1.6, 2.4, 4.0}) {
      DrivingRig rig(static_cast<float>(speed_mps));
      rig.yaw_rate_radps = static_cast<float>(speed_mps / radius_m);
      rig.scrub_duty = kOnTheSpotDuty / (0.925 + 0.15 * radius_m / kGaugeM);
      rig.driven_m(20'000);
      EXPECT_EQ(rig.program.faults(), 0) << speed_mps << " m/s, radius " << radius_m << " m";
    }
  }
}

TEST(FailSafe, ATrackThatIsHeldForLessThanHalfASecondGoesOn) {
  for (const float speed : kSpeeds) {
    for (const bool both : {false, true}) {
      DrivingRig rig(speed);
      rig.left_blocked = true;
      rig.right_blocked = both;
      rig.driven_m(490);
      rig.left_blocked = rig.right_blocked = false;
      rig.driven_m(3000);
      EXPECT_EQ(rig.program.faults(), 0) << speed << " " << both;
    }
  }
}

TEST(FailSafe, ASaggingBatteryAChangeOfDirectionOrAPushIsNoFaultOfAnEncoder) {
  DrivingRig sags;
  for (int i = 0; i < 60; ++i) {
    sags.load_duty += 0.002;
    sags.driven_m(1000);
  }
  EXPECT_EQ(sags.program.faults(), 0);

  DrivingRig turns_back;
  for (int i = 0; i < 10; ++i) {
    turns_back.speed_mps = i % 2 == 0 ? 0.15f : -0.15f;
    turns_back.driven_m(400);
  }
  EXPECT_EQ(turns_back.program.faults(), 0);

  DrivingRig pushed;
  pushed.disturbance_radps = 15.0 / 57.3 / 0.3;
  pushed.driven_m(300);
  pushed.disturbance_radps = 0.0;
  pushed.driven_m(5000);
  EXPECT_EQ(pushed.program.faults(), 0);
}

// One jump is tolerated, also if it lasts up to 0.1 s, and another one after a second.
TEST(FailSafe, CountsThatJumpAgainAreAnEncoderThatFailsAndOneJumpIsNot) {
  for (const int apart_ms : {50, 150, 300, 950, 1050}) {
    DrivingRig rig;
    rig.jumped_m += 0.02;
    rig.driven_m(apart_ms);
    EXPECT_EQ(rig.program.faults(), 0);
    rig.jumped_m += 0.02;
    rig.driven_m(300);
    const bool again = apart_ms > 100 && apart_ms < 1000;
    EXPECT_EQ(rig.program.faults(), again ? mask(Fault::stalled_left) : 0) << apart_ms;
  }
}

TEST(FailSafe, CountsThatGoBackAgainAreAnEncoderThatFailsAndOnceIsNot) {
  for (const int back_ms : {50, 120}) {
    for (const bool again : {false, true}) {
      DrivingRig rig;
      for (int ms = 0; ms < 1000; ms += 5) {
        // The counts change no faster than a track can move.
        if (ms % 500 < back_ms && (again || ms < 500)) rig.jumped_m -= 0.0016;
        rig.driven_m(5);
      }
      EXPECT_EQ(rig.program.faults(), again ? mask(Fault::stalled_left) : 0) << back_ms;
    }
  }
}

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
      verdict = monitor.update(mark, accel_x, 0.0f, MonitorValues(p), p);
    }
    return verdict;
  }
  void restart() {
    monitor.restart();
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

// In an arc even the short count of the outer track is higher than that of the inner one.
TEST_F(TurnMonitorAlone, ATurnOnTheSpotOrAnArcShowsWhichTrackCountsShort) {
  struct Case {
    double slower_mps, faster_mps, counted;
  };
  for (const Case& one : {Case{-0.08, 0.08, 0.3}, Case{0.05, 0.15, 0.7}}) {
    for (const double sign : {1.0, -1.0}) {
      const double slower = sign * one.slower_mps, faster = sign * one.faster_mps;
      restart();
      EXPECT_EQ(run(slower, faster, 20'000), TurnMonitor::kGood) << faster;
      right_counted = one.counted;
      EXPECT_EQ(run(slower, faster, 20'000), TurnMonitor::kRightShort) << faster;
      restart();
      left_counted = one.counted;
      EXPECT_EQ(run(faster, slower, 20'000), TurnMonitor::kLeftShort) << faster;
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
  const auto turn_duty_now = [&] { return 1e-3 * (monitor.load() - monitor.slope_load()); };
  const auto turn_duty = [&](double left_mps, double right_mps) {
    restart();
    run(left_mps, right_mps, 2000);
    return turn_duty_now();
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
  EXPECT_NEAR(turn_duty_now(), 0.15, 0.02) << "it falls by 0.3 a second";
}

TEST_F(TurnMonitorAlone, TheLoadOfASlopeEndsSlowlyAfterIt) {
  accel_x = 500;  // the sensor has an offset, or the robot began on a slope
  run(0.1, 0.1, 1000);
  EXPECT_EQ(monitor.slope_load(), 0);
  accel_x += 1000;  // 7 degrees
  run(0.1, 0.1, 1000);
  const int on_slope = monitor.slope_load();
  EXPECT_GT(on_slope, 200);
  accel_x = 500;
  run(0.1, 0.1, 500);
  EXPECT_GT(monitor.slope_load(), on_slope / 2);
  EXPECT_LT(monitor.slope_load(), on_slope);
  run(0.1, 0.1, 3000);
  EXPECT_EQ(monitor.slope_load(), 0);
}

}  // namespace
}  // namespace tp100::firmware
