// Faults of tracks and encoders switch the motors off.

#include <gtest/gtest.h>

#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::Fault;

TEST(TrackMonitorAlone, ATrackThatStandsAtItsStallDutyIsStalledAndBelowItNot) {
  wire::Parameters p = test::good_parameters();
  p.feed_forward = 0.0f;  // the duty gives no estimate of the speed
  p.dead_band = 0.0f;
  for (const std::int16_t stall_duty : {std::int16_t{1}, std::int16_t{600}}) {
    p.stall_duty = static_cast<std::uint16_t>(stall_duty);
    for (const int sign : {1, -1}) {
      TrackMonitor at, below;
      TrackMonitor::Verdict verdict = TrackMonitor::kGood;
      for (int ms = 0; ms <= 1010; ms += 5) {
        EXPECT_EQ(verdict, TrackMonitor::kGood) << ms;
        verdict = at.update(static_cast<std::int16_t>(sign * stall_duty), 0, 5, 0.0f, true, p);
        EXPECT_EQ(
            below.update(static_cast<std::int16_t>(sign * (stall_duty - 1)), 0, 5, 0.0f, true, p),
            TrackMonitor::kGood);
        if (verdict != TrackMonitor::kGood) break;
      }
      EXPECT_EQ(verdict, TrackMonitor::kStalled) << stall_duty << " " << sign;
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

TEST(FailSafe, ABlockedTrackIsStalled) {
  Rig rig;
  rig.tracks_follow = true;
  rig.left_blocked = true;
  rig.drive(0.15f);
  rig.run(3000);
  EXPECT_TRUE(rig.has(Fault::stalled_left));
  EXPECT_FALSE(rig.has(Fault::stalled_right));
  EXPECT_FALSE(rig.motors_on());
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

/// Drives straight on by the true yaw until a fault occurs or `ms` are over; returns the distance.
double driven_m(Rig& rig, int ms) {
  const double from_m = rig.true_m;
  for (int i = 0; i < ms / 5 && rig.program.faults() == 0; ++i) {
    rig.yaw_rad = static_cast<float>(rig.true_yaw_rad);
    rig.run(5);
  }
  return rig.true_m - from_m;
}

TEST(FailSafe, AnEncoderThatLosesCountsIsFoundThoughTheYawLoopHidesIt) {
  for (const float speed : {0.03f, 0.06f, 0.1f, 0.15f}) {
    for (const double counted : {0.0, 0.05, 0.3, 0.5, 0.7}) {
      for (const bool left : {true, false}) {
        Rig rig;
        rig.tracks_follow = true;
        rig.drive(speed);
        driven_m(rig, 2000);
        ASSERT_EQ(rig.program.faults(), 0) << speed;
        (left ? rig.left_counted : rig.right_counted) = counted;
        const double m = driven_m(rig, 60'000);
        const std::uint16_t expected = static_cast<std::uint16_t>(
            wire::fault_bit(left ? Fault::stalled_left : Fault::stalled_right));
        EXPECT_EQ(rig.program.faults(), expected) << speed << " " << counted;
        EXPECT_FALSE(rig.motors_on());
        // The counted distance of the middle lacks half of the lost counts.
        EXPECT_LT(m * (1.0 - counted) / 2.0, 0.12) << speed << " " << counted;
      }
    }
  }
}

TEST(FailSafe, TwoEncodersThatLoseCountsAreFoundByTheirDuty) {
  for (const float speed : {0.03f, 0.06f, 0.1f, 0.15f}) {
    for (const double counted : {0.0, 0.05, 0.3, 0.5, 0.7}) {
      Rig rig;
      rig.tracks_follow = true;
      rig.drive(speed);
      driven_m(rig, 2000);
      rig.left_counted = rig.right_counted = counted;
      EXPECT_LT(driven_m(rig, 60'000) * (1.0 - counted), 0.15) << speed << " " << counted;
      EXPECT_NE(rig.program.faults(), 0) << speed << " " << counted;
    }
  }
}

TEST(FailSafe, BothTracksThatCountShortInAnArcAreFoundByTheMeanOfTheirDuties) {
  Rig rig;
  rig.tracks_follow = true;
  rig.drive(0.1f);
  driven_m(rig, 2000);
  rig.yaw_rate_radps = 0.3f;
  const double from_m = rig.true_m;
  for (int ms = 0; ms < 20'000 && rig.program.faults() == 0; ms += 5) {
    if (ms == 1000) rig.left_counted = rig.right_counted = 0.7;
    rig.yaw_rad = rig.desired_yaw_rad = static_cast<float>(rig.true_yaw_rad);
    rig.run(5);
  }
  EXPECT_EQ(rig.program.faults(),
            wire::fault_bit(Fault::stalled_left) | wire::fault_bit(Fault::stalled_right));
  EXPECT_LT((rig.true_m - from_m - 0.1) * 0.3, 0.15);
}

TEST(FailSafe, ALoadThatTheAccelerometerExplainsIsNoFaultOfAnEncoder) {
  for (const bool steep : {true, false}) {
    Rig rig;
    rig.tracks_follow = true;
    rig.hal.accel_x = 500;  // the sensor has an offset, or the robot began on a slope
    rig.drive(0.1f);
    driven_m(rig, 2000);
    rig.load_duty = 0.25;
    if (steep) rig.hal.accel_x += 1600;
    driven_m(rig, 10'000);
    EXPECT_EQ(rig.program.faults() != 0, !steep);
    rig.hal.accel_x = 500;
    driven_m(rig, 10'000);
    EXPECT_NE(rig.program.faults(), 0) << "the load continues after the slope";
  }
}

// The resistance against turning falls slowly with the radius (Nikitin's formula); on soft tracks
// wide arcs take a third of the duty of the spot.
TEST(FailSafe, TheResistanceOfAnArcIsNoFaultOfAnEncoder) {
  constexpr double kOnTheSpotDuty = 0.28, kGaugeM = 0.155;
  for (const double speed_mps : {0.05, 0.1, 0.15}) {
    for (const double radius_m : {0.4, 0.8, 1.2, 1.6, 2.4, 4.0}) {
      Rig rig;
      rig.tracks_follow = true;
      rig.drive(static_cast<float>(speed_mps));
      driven_m(rig, 2000);
      rig.yaw_rate_radps = static_cast<float>(speed_mps / radius_m);
      rig.scrub_duty = kOnTheSpotDuty / (0.925 + 0.15 * radius_m / kGaugeM);
      for (int ms = 0; ms < 20'000 && rig.program.faults() == 0; ms += 5) {
        rig.yaw_rad = rig.desired_yaw_rad = static_cast<float>(rig.true_yaw_rad);
        rig.run(5);
      }
      EXPECT_EQ(rig.program.faults(), 0) << speed_mps << " m/s, radius " << radius_m << " m";
    }
  }
}

TEST(FailSafe, ABatteryThatSagsIsNoFaultOfAnEncoder) {
  Rig rig;
  rig.tracks_follow = true;
  rig.drive(0.1f);
  driven_m(rig, 2000);
  for (int i = 0; i < 60; ++i) {
    rig.load_duty += 0.002;
    driven_m(rig, 1000);
  }
  EXPECT_EQ(rig.program.faults(), 0);
}

TEST(FailSafe, ATrackThatIsHeldForLessThanHalfASecondGoesOn) {
  for (const float speed : {0.03f, 0.06f, 0.1f, 0.15f}) {
    for (const bool both : {false, true}) {
      Rig rig;
      rig.tracks_follow = true;
      rig.drive(speed);
      driven_m(rig, 2000);
      rig.left_blocked = true;
      rig.right_blocked = both;
      driven_m(rig, 490);
      rig.left_blocked = rig.right_blocked = false;
      driven_m(rig, 3000);
      EXPECT_EQ(rig.program.faults(), 0) << speed << " " << both;
    }
  }
}

TEST(FailSafe, CountsThatJumpAgainAreAnEncoderThatFailsAndOneJumpIsNot) {
  for (const bool again : {false, true}) {
    Rig rig;
    rig.tracks_follow = true;
    rig.drive(0.1f);
    driven_m(rig, 2000);
    rig.jumped_m += 0.02;
    driven_m(rig, 300);
    EXPECT_EQ(rig.program.faults(), 0);
    if (again) rig.jumped_m += 0.02;
    driven_m(rig, 300);
    EXPECT_EQ(rig.program.faults(), again ? wire::fault_bit(Fault::stalled_left) : 0);
  }
}

TEST(FailSafe, CountsThatGoBackAgainAreAnEncoderThatFailsAndOnceIsNot) {
  for (const bool again : {false, true}) {
    Rig rig;
    rig.tracks_follow = true;
    rig.drive(0.1f);
    driven_m(rig, 2000);
    for (int ms = 0; ms < 1000; ms += 5) {
      // The counts change no faster than a track can move.
      if (ms % 500 < 50 && (again || ms < 500)) rig.jumped_m -= 0.0016;
      driven_m(rig, 5);
    }
    EXPECT_EQ(rig.program.faults(), again ? wire::fault_bit(Fault::stalled_left) : 0);
  }
}

TEST(FailSafe, ATrackThatTurnsBackUnderAnotherDutyIsGood) {
  Rig rig;
  rig.tracks_follow = true;
  rig.connect();
  rig.streams = true;
  rig.run(20);
  rig.arm();
  for (int i = 0; i < 10; ++i) {
    rig.speed_mps = i % 2 == 0 ? 0.15f : -0.15f;
    driven_m(rig, 400);
  }
  EXPECT_EQ(rig.program.faults(), 0);
}

TEST(FailSafe, APushIsNoEncoderThatLosesCounts) {
  Rig rig;
  rig.tracks_follow = true;
  rig.drive(0.1f);
  driven_m(rig, 2000);
  rig.disturbance_radps = 15.0 / 57.3 / 0.3;
  driven_m(rig, 300);
  rig.disturbance_radps = 0.0;
  driven_m(rig, 5000);
  EXPECT_EQ(rig.program.faults(), 0);
}

TEST(FailSafe, ATrackThatRunsAgainstItsDutyIsReversed) {
  Rig rig;
  rig.parameters.flags = wire::kInvertRightMotor;
  rig.tracks_follow = true;
  rig.drive(0.15f);
  rig.run(1500);
  EXPECT_TRUE(rig.has(Fault::reversed_right));
  EXPECT_FALSE(rig.has(Fault::reversed_left));
  EXPECT_FALSE(rig.motors_on());
}

}  // namespace
}  // namespace tp100::firmware
