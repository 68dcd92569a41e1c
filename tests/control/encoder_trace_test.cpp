#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "control/monitor.h"
#include "support/golden_trace.h"
#include "support/sequence.h"

namespace tp100::control {
namespace {

constexpr double kTraceStepS = 0.0047;

/// A track with its duty that drives, climbs, turns, drags and is blocked, one after the other.
struct TrackScript {
  double duty = 0.0, track_mps = 0.0;
  Load load{};

  TrackScript(int step, double forward, double needed, const MotorModel& motor) {
    const double t = step * kTraceStepS;
    // Even for most of the time, so that the duty is learned.
    const double mps = 0.09 + 0.05 * std::floor(std::fmod(t, 9.0) / 3.0) +
                       (std::fmod(t, 5.0) < 1.0 ? 0.02 * std::sin(7.0 * t) : 0.0);
    const double phase = std::fmod(t, 4.0);
    load.turning = phase > 1.6 ? 0.0 : 0.03 + 0.3 * std::abs(std::sin(0.9 * t));
    load.pitch_rad = phase < 2.8 ? 0.0 : 0.12 * std::sin(0.7 * t);
    load.on_obstacle = std::fmod(t, 11.0) > 9.9;
    double over = 0.02 * std::sin(1.3 * t);
    if (std::fmod(t, 2.6) > 1.9) over += 0.22 + 0.1 * std::sin(0.37 * t);
    if (std::fmod(t, 10.4) > 8.2) over += 0.15;
    duty = motor.dead_band + needed * motor.feed_forward * mps + over;
    track_mps = std::fmod(t, 7.0) > 6.6 ? 0.3 * mps : mps;
    if (std::fmod(t, 13.0) > 12.5) duty = 0.5 * motor.dead_band;
    duty *= forward;
    track_mps *= forward;
    if (std::fmod(t, 17.0) > 16.6) track_mps = -track_mps;
  }
};

TEST(EncoderTrace, TheDutyTellsWhatDistanceIsMissing) {
  test::GoldenTrace trace("control/duty_monitor.csv", {"step", "m0", "m1", "m2", "m3", "m4", "m5",
                                                       "f0", "f1", "f2", "f3", "f4", "f5"});
  const MotorModel motors[] = {{}, {.dead_band = 0.09, .feed_forward = 3.4}};
  std::vector<DutyMonitor> monitors;
  for (int i = 0; i < 6; ++i) monitors.emplace_back(motors[i % 2]);
  std::vector<double> raised(6, 0.0);
  for (int step = 0; step < 9000; ++step) {
    if (step == 5000) {
      for (DutyMonitor& monitor : monitors) monitor.restart();
    }
    std::vector<double> row = {static_cast<double>(step)};
    for (std::size_t i = 0; i < monitors.size(); ++i) {
      const TrackScript now(step, i < 4 ? 1.0 : -1.0, 0.65 + 0.15 * static_cast<double>(i),
                            motors[i % 2]);
      raised[i] += monitors[i].update(now.duty, now.track_mps, now.load, kTraceStepS) ? 1.0 : 0.0;
      row.push_back(monitors[i].missing_m());
    }
    row.insert(row.end(), raised.begin(), raised.end());
    if (step % 23 == 0) trace.row(row);
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(EncoderTrace, TheGainIsLearnedWhereTheTrackRunsEvenlyAndFreely) {
  test::GoldenTrace trace("control/duty_learning.csv",
                          {"case", "learned", "after_turn", "after_slope", "after_faster",
                           "after_jolts", "after_gaps", "blocked"});
  test::Sequence any(21);
  for (int i = 0; i < 60; ++i) {
    const MotorModel motor{.dead_band = any.between(0.05, 0.2),
                           .feed_forward = any.between(2.5, 5.0)};
    DutyMonitor monitor(motor);
    const double needed = any.between(0.6, 1.5);
    const double mps = any.between(0.02, 0.1), side = i % 3 == 0 ? -1.0 : 1.0;
    // What the track gets beyond its usual duty turns the gain into a missing distance.
    const auto run = [&](double speed_mps, double gain, const Load& load, int steps,
                         double step_s = kTraceStepS) {
      for (int n = 0; n < steps; ++n) {
        monitor.update(side * (motor.dead_band + gain * motor.feed_forward * speed_mps),
                       side * speed_mps, load, step_s);
      }
    };
    const auto probe = [&] {
      DutyMonitor copy = monitor;
      const double before_m = copy.missing_m();
      for (int n = 0; n < 40; ++n)
        copy.update(side * (motor.dead_band + 0.02 + 1.6 * motor.feed_forward * mps), side * mps,
                    {}, kTraceStepS);
      return copy.missing_m() - before_m;
    };
    std::vector<double> row = {static_cast<double>(i)};
    run(mps, needed, {}, 120);
    row.push_back(probe());
    run(mps, 1.1 * needed, {.turning = any.between(0.0, 0.1)}, 100);
    row.push_back(probe());
    run(mps, 1.2 * needed, {.pitch_rad = any.between(-0.05, 0.05)}, 100);
    row.push_back(probe());
    const double faster = any.between(1.1, 1.6), lighter = any.between(0.8, 1.1);
    run(faster * mps, lighter * needed, {}, 70);
    row.push_back(probe());
    for (int n = 0; n < 100; ++n)
      run(mps * (1.0 + 0.15 * std::sin(0.2 * n)), needed * (1.0 - 0.001 * n), {}, 1);
    row.push_back(probe());
    // Samples that are missing make long steps.
    run(1.3 * mps, 0.95 * lighter * needed, {}, 1, 0.37);
    run(1.3 * mps, 0.9 * lighter * needed, {}, 2, 0.34);
    run(1.7 * mps, lighter * needed, {}, 3, 0.41);
    row.push_back(probe());
    int blocked = 0;
    while (blocked < 3000 && !monitor.update(side * (motor.dead_band + 0.2), side * 0.2 * mps,
                                             {.turning = 0.02 * (i % 5)}, kTraceStepS))
      ++blocked;
    row.push_back(blocked);
    trace.row(row);
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(EncoderTrace, GyroAndTracksMayDifferForSoLong) {
  test::GoldenTrace trace("control/turn_balance.csv", {"case", "steady", "slow", "swinging",
                                                       "obstacle", "after_pulse", "restarted"});
  test::Sequence any(22);
  for (int i = 0; i < 120; ++i) {
    const double wheelbase_m = any.between(0.2, 0.35), share = any.between(0.0, 0.08);
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    const double turning_radps = any.between(-0.5, 0.5), track_mps = any.between(0.0, 0.15);
    const double fast_radps = side * any.between(0.1, 1.0),
                 slow_radps = side * any.between(0.01, 0.15);
    TurnBalance balance(wheelbase_m, share);
    const auto steps = [&](const std::function<double(int)>& difference_radps, bool on_obstacle) {
      int step = 0;
      while (step < 4000 && !balance.update(turning_radps + difference_radps(step), turning_radps,
                                            track_mps, on_obstacle, kTraceStepS))
        ++step;
      return static_cast<double>(step);
    };
    const auto anew = [&](const std::function<double(int)>& difference_radps,
                          bool on_obstacle = false) {
      balance = TurnBalance(wheelbase_m, share);
      return steps(difference_radps, on_obstacle);
    };
    std::vector<double> row = {static_cast<double>(i)};
    row.push_back(anew([&](int) { return fast_radps; }));
    row.push_back(anew([&](int) { return slow_radps; }));
    row.push_back(anew([&](int n) { return 2.0 * fast_radps * std::sin(0.02 * n) + slow_radps; }));
    row.push_back(anew([&](int) { return 1.5 * fast_radps; }, true));
    row.push_back(anew([&](int n) { return n < 20 ? 2.0 * side : -fast_radps; }));
    balance.restart();
    row.push_back(steps([&](int) { return -slow_radps * 2.0; }, false));
    trace.row(row);
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(EncoderTrace, CountsMayGrowSoFast) {
  test::GoldenTrace trace("control/jumps.csv",
                          {"counts", "left", "right", "both", "gap", "restarted"});
  for (int counts = -60; counts <= 60; counts += 3) {
    const auto jumped = [&](double max_per_s, int left, int right, DeviceUs after_us,
                            bool restart) {
      JumpMonitor monitor(max_per_s);
      Sample sample;
      sample.device_us = 123456;
      sample.left_counts = 777;
      sample.right_counts = -555;
      double sum = monitor.update(sample) ? 1.0 : 0.0;
      sample.device_us += 5000;
      sample.left_counts += 3;
      sample.right_counts -= 2;
      sum += monitor.update(sample) ? 2.0 : 0.0;
      if (restart) monitor.restart();
      sample.device_us += after_us;
      sample.left_counts += left;
      sample.right_counts += right;
      sum += monitor.update(sample) ? 4.0 : 0.0;
      sum += monitor.update(sample) ? 8.0 : 0.0;
      return sum;
    };
    trace.row({static_cast<double>(counts), jumped(6100.0, counts, 2, 5000, false),
               jumped(3300.0, 4, -counts, 6000, false), jumped(0.0, counts, counts, 5000, false),
               jumped(600.0, -counts, counts / 2, 71000, false),
               jumped(600.0, counts, counts, 5000, true)});
  }
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::control
