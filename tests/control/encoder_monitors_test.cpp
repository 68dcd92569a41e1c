// The monitors of the encoders, each by itself: what a track's duty explains, what slip explains of
// a turn, and how fast counts can grow.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "control/monitor.h"
#include "lagging_robot.h"

namespace tp100::control {
namespace {

constexpr MotorModel kMotor{.dead_band = 0.1, .feed_forward = 4.0};

/// The duty up to which a track at `track_mps` misses no distance now. What is above it is missed,
/// as the distance that it would drive.
double explained_duty(DutyMonitor monitor, double track_mps, const Load& load = {},
                      double direction = 1.0) {
  for (double duty = kMotor.dead_band + 0.001; duty < 3.0; duty += 0.05) {
    DutyMonitor tried = monitor;
    tried.update(direction * duty, direction * track_mps, load, kDt);
    const double missing_m = direction * (tried.missing_m() - monitor.missing_m());
    if (missing_m > 0.0) return duty - missing_m / kDt * kMotor.feed_forward;
  }
  ADD_FAILURE() << "every duty is explained";
  return 0.0;
}

void drive(DutyMonitor& monitor, double track_mps, double gain, double duration_s,
           const Load& load = {}) {
  for (double s = 0.0; s < duration_s; s += kDt)
    monitor.update(kMotor.dead_band + gain * kMotor.feed_forward * track_mps, track_mps, load, kDt);
}

// Before anything is learned a track may need 1.4 times the duty of its file, and always a tenth of
// that and 0.02 more.
double expected_duty(double track_mps, double gain = 1.4) {
  return kMotor.dead_band + 1.1 * gain * kMotor.feed_forward * track_mps + 0.02;
}

TEST(DutyMonitor, TheFilesDutyWithItsMarginsIsExplained) {
  const DutyMonitor fresh(kMotor);
  for (const double direction : {1.0, -1.0}) {
    for (const double mps : {0.0, 0.02, 0.1})
      EXPECT_NEAR(explained_duty(fresh, mps, {}, direction), expected_duty(mps), 1e-6) << mps;
  }
  EXPECT_NEAR(explained_duty(fresh, -0.1), expected_duty(0.0), 1e-6) << "a track that runs back";
}

// A turn takes 0.2 where the tracks' speeds differ by 0.12 of their mean each and up to 0.4 at 0.4
// of it, a slope 0.8 per radian, an obstacle 0.4.
TEST(DutyMonitor, ATurnASlopeAndAnObstacleExplainMore) {
  const DutyMonitor fresh(kMotor);
  const double level = explained_duty(fresh, 0.1);
  const auto more = [&](const Load& load) { return explained_duty(fresh, 0.1, load) - level; };
  EXPECT_NEAR(more({.turning = 0.06}), 0.1, 1e-6);
  EXPECT_NEAR(more({.turning = 0.12}), 0.2, 1e-6);
  EXPECT_NEAR(more({.turning = 0.26}), 0.3, 1e-6);
  EXPECT_NEAR(more({.turning = 0.4}), 0.4, 1e-6);
  EXPECT_NEAR(more({.turning = 9.0}), 0.4, 1e-6);
  EXPECT_NEAR(more({.pitch_rad = 0.1}), 0.08, 1e-6);
  EXPECT_NEAR(more({.pitch_rad = -0.2}), 0.16, 1e-6);
  EXPECT_NEAR(more({.on_obstacle = true}), 0.4, 1e-6);
}

TEST(DutyMonitor, ALoadIsForgottenSlowlyAndAnObstacleAfterASecond) {
  DutyMonitor monitor(kMotor);
  const double level = explained_duty(monitor, 0.1);
  monitor.update(0.5, 0.1, {.turning = 0.4, .on_obstacle = true}, kDt);
  const auto more_after = [&](double after_s) {
    DutyMonitor later = monitor;
    for (int i = 1; i < std::lround(after_s / kDt); ++i) later.update(0.0, 0.0, {}, kDt);
    return explained_duty(later, 0.1) - level;
  };
  EXPECT_NEAR(more_after(0.5), 0.4 + 0.2 + 0.2 * (0.15 - 0.12) / 0.28, 1e-6);
  EXPECT_NEAR(more_after(0.7), 0.4 + 0.2 * 0.05 / 0.12, 1e-6);
  EXPECT_NEAR(more_after(0.98), 0.4, 1e-6);
  EXPECT_NEAR(more_after(1.02), 0.0, 1e-6);
}

TEST(DutyMonitor, ABlockedTrackIsReportedAfterFourCentimetresAndNotBeforeSevenTenths) {
  for (const double direction : {1.0, -1.0}) {
    for (const double beyond : {0.03, 0.1, 0.2, 0.8}) {
      DutyMonitor monitor(kMotor);
      double after_s = kDt;
      while (!monitor.update(direction * (0.12 + beyond), 0.0, {}, kDt) && after_s < 9.0)
        after_s += kDt;
      EXPECT_NEAR(after_s, std::max(0.7, 0.04 / (beyond / kMotor.feed_forward)), 2 * kDt);
      EXPECT_GT(direction * monitor.missing_m(), 0.04);
      monitor.restart();
      EXPECT_EQ(monitor.missing_m(), 0.0);
    }
  }
}

TEST(DutyMonitor, WhatWasMissedIsMadeUpForByLessDutyAndWithoutAny) {
  for (const double duty : {0.0, 0.05, kMotor.dead_band}) {
    DutyMonitor monitor(kMotor);
    for (int i = 0; i < 100; ++i) monitor.update(0.22, 0.0, {}, kDt);
    EXPECT_NEAR(monitor.missing_m(), 100 * kDt * 0.1 / 4.0, 1e-9);
    for (int i = 0; i < 10; ++i) EXPECT_FALSE(monitor.update(duty, 0.0, {}, kDt));
    EXPECT_NEAR(monitor.missing_m(), 0.0125 - 10 * kDt * 0.04 / 0.7, 1e-9) << "in 0.7 s";
  }
  DutyMonitor monitor(kMotor);
  for (int i = 0; i < 100; ++i) monitor.update(0.22, 0.0, {}, kDt);
  for (int i = 0; i < 10; ++i) monitor.update(0.11, 0.0, {}, kDt);
  EXPECT_NEAR(monitor.missing_m(), 0.0125 - 10 * kDt * 0.01 / 4.0, 1e-9);
  DutyMonitor unknown({.dead_band = 0.1, .feed_forward = 0.0});
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(unknown.update(1.0, 0.0, {}, kDt));
}

TEST(DutyMonitor, ATracksOwnDutyIsLearnedWhileItRunsStraight) {
  for (const double gain : {0.5, 0.75, 1.0, 1.3}) {
    DutyMonitor monitor(kMotor);
    drive(monitor, 0.1, gain, 6.0);
    const double learned = std::max(gain, 0.7);
    EXPECT_NEAR(explained_duty(monitor, 0.1), expected_duty(0.1, learned), 2e-3) << gain;
    EXPECT_NEAR(explained_duty(monitor, 0.125), expected_duty(0.125, learned), 2e-3);
    // Friction takes a smaller share at a higher speed: beyond 1.25 of it the file's bound holds.
    EXPECT_NEAR(explained_duty(monitor, 0.2),
                expected_duty(0.2) - 1.1 * (1.4 - learned) * 4.0 * 0.125, 3e-3);
    monitor.restart();
    EXPECT_NEAR(explained_duty(monitor, 0.1), expected_duty(0.1), 1e-6);
  }
  DutyMonitor monitor(kMotor);
  // After 0.48 s the mean over 0.2 s is within a tenth of its speed, which then counts as even; the
  // gain, and for which speeds it holds, is learned with a time constant of 0.3 s.
  drive(monitor, 0.1, 1.0, 0.48 + 0.3);
  EXPECT_NEAR(explained_duty(monitor, 0.07), expected_duty(0.07, 1.0 + 0.4 / std::exp(1.0)), 3e-3);
}

TEST(DutyMonitor, ANeedThatRisesIsLearnedOnlyAsFastAsABatterySags) {
  DutyMonitor monitor(kMotor);
  drive(monitor, 0.1, 1.0, 6.0);
  drive(monitor, 0.1, 1.2, 10.0);
  EXPECT_NEAR(explained_duty(monitor, 0.1), expected_duty(0.1, 1.05), 2e-3);
}

// What is known of it is the duty at 0.05 m/s, a part of that at 0.16 m/s, from where 0.2 m/s is
// not beyond; the rest rises with the battery's 0.005 per second, for 5 s.
TEST(DutyMonitor, AtAHigherSpeedTheGainIsLearnedAnew) {
  DutyMonitor monitor(kMotor);
  drive(monitor, 0.05, 0.8, 6.0);
  drive(monitor, 0.2, 1.1, 6.0);
  const double gain = 1.1 - (1.1 - 0.8) * 0.05 / 0.16 + 0.005 * 5.0;
  EXPECT_NEAR(explained_duty(monitor, 0.2), expected_duty(0.2, gain), 4e-3);
}

TEST(DutyMonitor, NothingIsLearnedUnderLoadOrUnevenlyOrSlowly) {
  const auto unlearned = [](double track_mps, const Load& load, double wobble) {
    DutyMonitor monitor(kMotor);
    drive(monitor, 0.1, 1.2, 6.0);
    for (int i = 0; i < 600; ++i)
      drive(monitor, track_mps * (1.0 + wobble * std::sin(0.2 * i)), 0.8, kDt, load);
    for (int i = 0; i < 400; ++i) monitor.update(0.0, 0.0, {}, kDt);
    return std::abs(explained_duty(monitor, 0.1) - expected_duty(0.1, 1.2)) < 2e-3;
  };
  EXPECT_FALSE(unlearned(0.1, {}, 0.0));
  EXPECT_FALSE(unlearned(0.1, {.pitch_rad = 0.029}, 0.0));
  EXPECT_TRUE(unlearned(0.1, {.turning = 0.051}, 0.0));
  EXPECT_TRUE(unlearned(0.1, {.pitch_rad = 0.031}, 0.0));
  EXPECT_TRUE(unlearned(0.1, {.pitch_rad = -0.031}, 0.0));
  EXPECT_TRUE(unlearned(0.1, {.on_obstacle = true}, 0.0));
  EXPECT_TRUE(unlearned(0.0279, {}, 0.0));
  EXPECT_FALSE(unlearned(0.0285, {}, 0.0));
  // A small turn takes duty from one track: what it explains is not learned.
  DutyMonitor monitor(kMotor);
  drive(monitor, 0.1, 1.0, 6.0);
  drive(monitor, 0.1, 0.9, 6.0, {.turning = 0.024});
  EXPECT_NEAR(explained_duty(monitor, 0.1), expected_duty(0.1, 1.0), 0.06);
  EXPECT_GT(explained_duty(monitor, 0.1), expected_duty(0.1, 0.98));
}

TEST(DutyMonitor, ATrackThatIsPushedOrBrakesTeachesNothing) {
  for (const double jump : {0.9, 1.15}) {
    DutyMonitor monitor(kMotor);
    drive(monitor, 0.1, 1.2, 6.0);
    for (int i = 0; i < 3; ++i) monitor.update(0.1 + 0.8 * 0.4, 0.1 * jump, {}, kDt);
    EXPECT_NEAR(explained_duty(monitor, 0.1), expected_duty(0.1, 1.2), 1e-4) << jump;
  }
}

// Slip explains a share of the turn, and of 0.8 of the way over the wheelbase; on an obstacle a
// quarter more. The rest may add up to 17 deg, or to 6 deg of rates up to 10 deg/s.
TEST(TurnBalance, GyroAndTracksMayDifferByWhatSlipExplainsAndSomeDegrees) {
  constexpr double kWheelbaseM = 0.25, kShare = 0.04;
  for (const double side : {1.0, -1.0}) {
    for (const bool on_obstacle : {false, true}) {
      for (const double difference : {0.05, 0.1, 0.17, 0.3, 0.6, 1.2}) {
        for (const double turn : {0.0, 0.5, -0.4}) {
          TurnBalance balance(kWheelbaseM, kShare);
          const double share = kShare + (on_obstacle ? 0.25 : 0.0);
          const double gyro = turn + side * difference;
          const double slip = share * (std::abs(gyro) + 0.8 * 0.1 / kWheelbaseM);
          const auto reaches_s = [&](double limit_rad, double rate) {
            return rate > slip ? limit_rad / (rate - slip) : 99.0;
          };
          const double expected_s =
              std::min(reaches_s(17.0 * kRadPerDeg, difference),
                       reaches_s(6.0 * kRadPerDeg, std::min(difference, 10.0 * kRadPerDeg)));
          double after_s = kDt;
          while (after_s < 20.0 && !balance.update(gyro, turn, 0.1, on_obstacle, kDt))
            after_s += kDt;
          if (expected_s < 19.0) {
            EXPECT_NEAR(after_s, expected_s, 2 * kDt) << difference;
          } else {
            EXPECT_GE(after_s, 19.0) << difference;
          }
          balance.restart();
          EXPECT_FALSE(balance.update(0.0, 0.0, 0.0, false, kDt));
        }
      }
    }
  }
}

TEST(TurnBalance, APushIsForgottenByAndByAndOneBackIsMadeUpFor) {
  TurnBalance balance(0.25, 0.04);
  const auto turn = [&](double gyro_radps, double mps, double duration_s) {
    bool raised = false;
    for (double s = 0.0; s < duration_s; s += kDt)
      raised = balance.update(gyro_radps, 0.0, mps, false, kDt) || raised;
    return raised;
  };
  for (int i = 0; i < 5; ++i) {
    EXPECT_FALSE(turn(0.9, 0.1, 0.3)) << i;
    EXPECT_FALSE(turn(-0.9, 0.1, 0.3)) << i;
  }
  for (int i = 0; i < 5; ++i) {
    EXPECT_FALSE(turn(0.9, 0.1, 0.3)) << i;
    EXPECT_FALSE(turn(0.0, 0.2, 12.0)) << i;
  }
  EXPECT_FALSE(turn(0.9, 0.1, 0.3));
  EXPECT_TRUE(turn(0.9, 0.1, 0.3));
}

TEST(JumpMonitor, CountsOfEitherTrackGrowAsFastAsATrackCanAndNoFaster) {
  const auto jumped = [](double max_per_s, int left, int right, bool restart = false) {
    JumpMonitor monitor(max_per_s);
    Sample sample;
    sample.device_us = 123456;
    sample.left_counts = 777;
    sample.right_counts = -555;
    EXPECT_FALSE(monitor.update(sample)) << "nothing is known before";
    EXPECT_FALSE(monitor.update(sample)) << "the same sample again";
    if (restart) monitor.restart();
    sample.device_us += 5000;
    sample.left_counts += left;
    sample.right_counts += right;
    const bool result = monitor.update(sample);
    EXPECT_FALSE(monitor.update(sample)) << "counts go on from there";
    return result;
  };
  for (const int side : {1, -1}) {
    EXPECT_FALSE(jumped(6000.0, side * 34, -side * 34)) << "30 in 5 ms, and 4 edges of slack";
    EXPECT_TRUE(jumped(6000.0, side * 35, 0));
    EXPECT_TRUE(jumped(6000.0, 0, side * 35));
    EXPECT_FALSE(jumped(6000.0, side * 500, 0, true));
    EXPECT_FALSE(jumped(0.0, side * 500, 0)) << "no limit is known";
  }
}

}  // namespace
}  // namespace tp100::control
