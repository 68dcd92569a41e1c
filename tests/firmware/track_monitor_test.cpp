// Faults of tracks and encoders switch the motors off.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::Fault;

// After 0.3 s of motion, the track is blocked for stall_ms.
TEST(TrackMonitorAlone, ATrackThatStandsAtItsStallDutyIsStalledAndBelowItNot) {
  wire::Parameters p = test::good_parameters();
  p.feed_forward = 0.0f;  // the duty gives no estimate of the speed
  p.dead_band = 0.0f;
  for (const std::int16_t stall_duty : {std::int16_t{1}, std::int16_t{600}}) {
    p.stall_duty = static_cast<std::uint16_t>(stall_duty);
    for (const int sign : {1, -1}) {
      TrackMonitor at, below;
      int ms = 0;
      const auto verdict = [&](TrackMonitor& monitor, int duty) {
        return monitor.update(static_cast<std::int16_t>(sign * duty), sign * std::min(ms, 300), 5,
                              0.0f, true, p);
      };
      while (verdict(at, stall_duty) == TrackMonitor::kGood && ms < 2000) {
        EXPECT_EQ(verdict(below, stall_duty - 1), TrackMonitor::kGood);
        ms += 5;
      }
      EXPECT_NEAR(ms, 1300, 25) << stall_duty << " " << sign;
      EXPECT_EQ(verdict(at, stall_duty), TrackMonitor::kStalled);
    }
  }
}

TEST(TrackMonitorAlone, ATrackWithoutDutyMayMoveEitherWay) {
  wire::Parameters p = test::good_parameters();
  p.dead_band = 0.0f;  // any duty would move the track
  for (const int sign : {1, -1}) {
    TrackMonitor monitor;
    for (int counts = 0; counts < 2000; counts += 5) {
      ASSERT_EQ(monitor.update(0, sign * counts, 5, 0.0f, true, p), TrackMonitor::kGood) << sign;
    }
  }
}

TEST(TrackMonitorAlone, ATrackIsReversedAtTheSameDistanceBothWays) {
  const wire::Parameters p = test::good_parameters();
  const auto reversed_at = [&](int sign) {
    TrackMonitor monitor;
    for (int counts = 0; counts < 2000; ++counts) {
      const auto duty = static_cast<std::int16_t>(sign * 300);
      if (monitor.update(duty, -sign * counts, 1, 0.0f, false, p) != TrackMonitor::kGood)
        return counts;
    }
    return 2000;
  };
  // A braking track may run on for 2 cm and for 0.2 s at its top speed.
  EXPECT_NEAR(reversed_at(1), 0.06 * 11140.0, 1.0);
  EXPECT_EQ(reversed_at(-1), reversed_at(1));
}

// The duty above the dead band of 15 % and a margin of 2 %, less what load and counted speed
// explain (the speed at 1.1 times the highest gain of 1.4), is 1/4 m/s for each unit. At 4 cm the
// track is stalled, but no sooner than in 0.7 times stall_ms; judged in steps of 80 ms.
TEST(TrackMonitorAlone, ATrackIsStalledByTheDistanceThatItsDutyImpliesAndNobodyCounted) {
  struct Case {
    int duty;
    float load;
    double mps, expected_s;
  };
  const wire::Parameters p = test::good_parameters();
  for (const Case& one : {Case{200, 0.0f, 0.0, 0.04 / (0.03 / 4.0)},
                          {300, 0.0f, 0.0, 0.04 / (0.13 / 4.0)},
                          {300, 0.1f, 0.0, 0.04 / (0.03 / 4.0)},
                          {300, 0.0f, 0.01, 0.04 / ((0.13 - 1.1 * 1.4 * 0.04) / 4.0)},
                          {590, 0.0f, 0.0, 0.7}}) {
    for (const int sign : {1, -1}) {
      TrackMonitor monitor;
      int ms = 0;
      const auto verdict = [&] {
        const double counts = sign * one.mps * ms * 1e-3 * 11140.0;
        return monitor.update(static_cast<std::int16_t>(sign * one.duty),
                              static_cast<std::int32_t>(std::floor(counts)), 5, one.load, false, p);
      };
      while (verdict() == TrackMonitor::kGood && ms < 10'000) ms += 5;
      EXPECT_NEAR(ms * 1e-3, one.expected_s, 0.1) << one.duty << ' ' << one.load << ' ' << one.mps;
    }
  }
}

// In a tight arc the outer track drags the inner one along, which brakes all the time.
TEST(TrackMonitorAlone, ATrackThatBrakesAgainstTheFloorInATurnIsNotReversed) {
  const wire::Parameters p = test::good_parameters();
  const auto duty = static_cast<std::int16_t>(-(p.dead_band + 0.1f) * wire::kFullDuty);
  const auto reversed_after_s = [&](float load_duty) {
    TrackMonitor monitor;
    for (int ms = 0; ms < 60'000; ms += 5) {
      const int counts =
          static_cast<int>(ms * 1e-3 * 0.008 * static_cast<double>(p.counts_per_metre));
      if (monitor.update(duty, counts, 5, load_duty, false, p) != TrackMonitor::kGood)
        return ms * 1e-3;
    }
    return 60.0;
  };
  EXPECT_EQ(reversed_after_s(0.3f), 60.0);
  EXPECT_LT(reversed_after_s(0.0f), 10.0) << "nothing drags the track on a straight line";
}

// Stiction: at a low speed the duty is below that of the robot's file, at a higher speed it is
// equal.
TEST(TrackMonitorAlone, AGainLearntAtALowSpeedIsNotThatOfAHigherOne) {
  const wire::Parameters p = test::good_parameters();
  for (const double slow_mps : {0.03, 0.036, 0.05}) {
    for (const double fast_mps : {0.06, 0.1, 0.2}) {
      TrackMonitor monitor;
      double counts = 0.0;
      for (int ms = 0; ms < 60'000; ms += 5) {
        const bool slow = ms / 10'000 % 2 == 0;
        const double mps = slow ? slow_mps : fast_mps;
        counts += mps * 5e-3 * static_cast<double>(p.counts_per_metre);
        const double duty = static_cast<double>(p.dead_band) +
                            static_cast<double>(p.feed_forward) * mps - (slow ? 0.03 : 0.0);
        ASSERT_EQ(monitor.update(static_cast<std::int16_t>(duty * wire::kFullDuty),
                                 static_cast<std::int32_t>(counts), 5, 0.0f, true, p),
                  TrackMonitor::kGood)
            << ms << " ms, " << slow_mps << " and " << fast_mps << " m/s";
      }
    }
  }
}

// Steering alternately loads a track and relieves it: its gain becomes the mean, with which the
// load of an arc, somewhat larger than the gyro implies, is not a stall.
TEST(TrackMonitorAlone, SmallTurnsOnAStraightTeachNoLowerGain) {
  const wire::Parameters p = test::good_parameters();
  for (const double mps : {0.06, 0.1, 0.16}) {
    TrackMonitor monitor;
    double counts = 0.0;
    const double usual = 0.9 * static_cast<double>(p.feed_forward) * mps;
    for (int ms = 0; ms < 40'000; ms += 5) {
      counts += mps * 5e-3 * static_cast<double>(p.counts_per_metre);
      const bool straight = ms < 15'000;
      const double load = straight ? 0.04 : 0.14;
      const double taken = !straight ? 0.16 : ms / 500 % 2 == 0 ? -load : load;
      const double duty = static_cast<double>(p.dead_band) + usual + taken;
      ASSERT_EQ(monitor.update(static_cast<std::int16_t>(duty * wire::kFullDuty),
                               static_cast<std::int32_t>(counts), 5, static_cast<float>(load),
                               straight, p),
                TrackMonitor::kGood)
          << ms << " ms at " << mps << " m/s";
    }
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

std::uint16_t mask(Fault fault) { return static_cast<std::uint16_t>(wire::fault_bit(fault)); }

constexpr float kSpeeds[] = {0.03f, 0.06f, 0.1f, 0.15f};

TEST(FailSafe, ABlockedTrackIsStalled) {
  Rig rig;
  rig.tracks_follow = true;
  rig.left_blocked = true;
  rig.drive(0.15f);
  rig.run(3000);
  EXPECT_EQ(rig.program.faults(), mask(Fault::stalled_left));
  EXPECT_FALSE(rig.motors_on());
}

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

TEST(FailSafe, AnEncoderThatLosesCountsIsFoundThoughTheYawLoopHidesIt) {
  for (const float speed : kSpeeds) {
    for (const double counted : {0.0, 0.05, 0.3, 0.5, 0.7}) {
      for (const bool left : {true, false}) {
        DrivingRig rig(speed);
        (left ? rig.left_counted : rig.right_counted) = counted;
        const double m = rig.driven_m(60'000);
        EXPECT_EQ(rig.program.faults(), mask(left ? Fault::stalled_left : Fault::stalled_right))
            << speed << " " << counted;
        EXPECT_FALSE(rig.motors_on());
        // The counted distance of the middle lacks half of the lost counts.
        EXPECT_LT(m * (1.0 - counted) / 2.0, 0.12) << speed << " " << counted;
      }
    }
  }
}

TEST(FailSafe, TwoEncodersThatLoseCountsAreFoundByTheirDuty) {
  for (const float speed : kSpeeds) {
    for (const double counted : {0.0, 0.05, 0.3, 0.5, 0.7}) {
      DrivingRig rig(speed);
      rig.left_counted = rig.right_counted = counted;
      EXPECT_LT(rig.driven_m(60'000) * (1.0 - counted), 0.15) << speed << " " << counted;
      EXPECT_NE(rig.program.faults(), 0) << speed << " " << counted;
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
    Rig rig;
    rig.tracks_follow = true;
    rig.hal.accel_x = 500;  // the sensor has an offset, or the robot began on a slope
    rig.drive(0.1f);
    const auto drive_on = [&](int ms) {
      for (; ms > 0 && rig.program.faults() == 0; ms -= 5) rig.run(5);
    };
    drive_on(2000);
    rig.load_duty = 0.25;
    if (steep) rig.hal.accel_x += 1600;
    drive_on(10'000);
    EXPECT_EQ(rig.program.faults() != 0, !steep);
    rig.hal.accel_x = 500;
    drive_on(10'000);
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

}  // namespace
}  // namespace tp100::firmware
