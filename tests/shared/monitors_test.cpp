// Monitors of the encoders, as robot and host run them.
#include "shared/monitors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/sequence.h"

namespace tp100::shared {
namespace {

constexpr double kDeadBand = 0.12, kFeedForward = 4.0, kSoonestS = 0.7;

/// The same track under both number types, judged every `dt_s`.
struct BothDuties {
  bool update(double duty, double mps, double load, bool free) {
    const auto f = [](double value) { return static_cast<float>(value); };
    robot_reports = robot.update(f(duty), f(mps), f(load), free, f(dt_s), f(kDeadBand),
                                 f(kFeedForward), f(kSoonestS));
    return host.update(duty, mps, load, free, dt_s, kDeadBand, kFeedForward, kSoonestS);
  }
  double dt_s;
  DutyMonitor<double> host{};
  DutyMonitor<float> robot{};
  bool robot_reports = false;
};

// Else a robot might stop where its host sees no fault, or drive on where it does.
TEST(DutyMonitor, RobotAndHostMissTheSameDistance) {
  test::Sequence any(21);
  int reports = 0;
  for (int drive = 0; drive < 400; ++drive) {
    BothDuties both{any.chance(0.5) ? 0.005 : 0.08};
    const bool blocked = any.chance(0.2);
    const double mps = any.between(-0.05, 0.25), load = any.chance(0.5) ? 0.0 : any.between(0, 0.4);
    const double gain = any.between(0.5, 1.5), wobble = any.chance(0.2) ? 0.3 : 0.02;
    const double duty = std::copysign(kDeadBand + gain * kFeedForward * std::abs(mps), mps);
    for (int i = 0; i < 500; ++i) {
      const double now_mps = blocked ? 0.0 : mps * (1.0 + wobble * std::sin(0.3 * i));
      const bool reported = both.update(duty, now_mps, load, load < 0.05);
      const auto robot_m = static_cast<double>(both.robot.missing_m());
      ASSERT_NEAR(both.host.missing_m(), robot_m, 1e-3 * (1.0 + std::abs(robot_m))) << drive;
      reports += reported && both.robot_reports ? 1 : 0;
    }
  }
  EXPECT_GT(reports, 1000);
}

// The duty above the dead band, a margin of 2 % and the load is 1/4 m/s for each unit.
TEST(DutyMonitor, ABlockedTrackIsReportedAfterFourCentimetresAndNotBeforeTheSoonestTime) {
  for (const double direction : {1.0, -1.0}) {
    for (const double beyond : {0.03, 0.1, 0.2, 0.8}) {
      for (const double load : {0.0, 0.1}) {
        DutyMonitor<double> monitor, unknown;
        double after_s = 0.005;
        const double duty = direction * (kDeadBand + 0.02 + load + beyond);
        while (after_s < 9.0 &&
               !monitor.update(duty, 0.0, load, false, 0.005, kDeadBand, kFeedForward, kSoonestS))
          after_s += 0.005;
        EXPECT_NEAR(after_s, std::max(kSoonestS, 0.04 / (beyond / kFeedForward)), 0.02);
        for (int i = 0; i < 1000; ++i)
          EXPECT_FALSE(unknown.update(direction, 0.0, 0.0, true, 0.005, 0.1, 0.0, kSoonestS));
      }
    }
  }
}

// A track that takes less duty than the file says is learned within a second; if a third of its
// counts is lost then, it is found, and would not be by the file alone.
TEST(DutyMonitor, LearnsTheDutyThatATrackTakesAndFindsTheChange) {
  for (const double gain : {0.8, 1.0, 1.3}) {
    BothDuties both{0.005};
    const double mps = 0.15, duty = kDeadBand + gain * kFeedForward * mps;
    for (int i = 0; i < 400; ++i) ASSERT_FALSE(both.update(duty, mps, 0.0, true)) << gain;
    double driven_m = 0.0;
    while (driven_m < 5.0 && !both.update(duty, 0.67 * mps, 0.0, true)) driven_m += mps * 0.005;
    EXPECT_LT(driven_m, 0.5) << gain;
  }
}

// A track takes more duty while it speeds up, and less while it slows down. Were that learned as
// usual, a robot would stop on an even drive after some braking, with a stall that is none.
TEST(DutyMonitor, SpeedingUpAndSlowingDownTeachNoGain) {
  constexpr double kLagS = 0.08, kMps2 = 0.3;
  BothDuties both{0.005};
  double mps = 0.05;
  for (int i = 0; i < 12'000; ++i) {
    const double wanted = i > 8000 || i / 400 % 2 == 0 ? 0.15 : 0.05;
    const double more = std::clamp(wanted - mps, -kMps2 * both.dt_s, kMps2 * both.dt_s);
    const double duty = kDeadBand + kFeedForward * (mps + kLagS * more / both.dt_s);
    mps += more;
    ASSERT_FALSE(both.update(duty, mps, 0.0, true) || both.robot_reports) << i;
  }
}

TEST(TurnDuty, RisesAtOnceFallsSlowlyAndGrowsWithTheTurn) {
  TurnDuty<double, HostLimits<double>> duty;
  double before = 0.0;
  for (const double turning : {0.0, 0.06, 0.12, 0.2, 0.4, 1.0}) {
    const double now = duty.update(turning, 0.0);
    EXPECT_GE(now, before);
    before = now;
  }
  EXPECT_DOUBLE_EQ(before, 0.4);
  EXPECT_DOUBLE_EQ(duty.update(0.0, 0.2), 0.3) << "0.5 a second";
  EXPECT_DOUBLE_EQ(duty.update(0.12, 0.0), 0.3);
  EXPECT_DOUBLE_EQ(duty.update(0.12, 10.0), 0.2) << "half of the duty";
}

// What slip explains is allowed; the rest may add up to an angle, or to a smaller one of rates up
// to 10 deg/s. A push is forgotten by and by, and one back is made up for.
template <class Real, class Limits>
void compare_with_definition(std::uint64_t seed) {
  constexpr double kDt = 0.005;
  test::Sequence any(seed);
  TurnBalance<Real, Limits> balance;
  double all_rad = 0.0, slow_rad = 0.0;
  int reports = 0;
  for (int drive = 0; drive < 3000; ++drive) {
    const double turn = any.chance(0.5) ? 0.0 : any.between(-0.5, 0.5);
    const double difference = any.between(-1.0, 1.0) * (any.chance(0.5) ? 0.1 : 1.0);
    const double slip = any.between(0.0, 0.1) * kDt;
    const double slow = std::clamp(difference, -0.1745, 0.1745);
    for (int i = any.below(400); i > 0; --i) {
      all_rad += difference * kDt;
      slow_rad += slow * kDt;
      for (double* sum : {&all_rad, &slow_rad})
        *sum = std::copysign(std::max(0.0, std::abs(*sum) - slip), *sum);
      const bool reported =
          balance.update(static_cast<Real>((turn + difference) * kDt),
                         static_cast<Real>(turn * kDt), static_cast<Real>(slip), Real(kDt));
      const double beyond =
          std::max(std::abs(all_rad) - static_cast<double>(Limits::max_turn_rad()),
                   std::abs(slow_rad) - static_cast<double>(Limits::max_slow_turn_rad()));
      if (std::abs(beyond) > 1e-3) {
        ASSERT_EQ(reported, beyond > 0.0) << drive;
      }
      if (!reported) continue;
      if (std::abs(beyond) > 1e-3) {
        const bool all = std::abs(all_rad) > static_cast<double>(Limits::max_turn_rad());
        EXPECT_EQ(balance.leftward(), (all ? all_rad : slow_rad) > 0.0);
      }
      ++reports;
      balance.restart();
      all_rad = slow_rad = 0.0;
    }
  }
  EXPECT_GT(reports, 100);
}

TEST(TurnBalance, GyroAndTracksMayDifferByWhatSlipExplainsAndSomeDegrees) {
  compare_with_definition<double, HostLimits<double>>(22);
  compare_with_definition<float, RobotLimits<float>>(23);
}

}  // namespace
}  // namespace tp100::shared
