// Golden traces of the monitors of tracks and encoders.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "../support/wire_host.h"
#include "firmware/track_monitor.h"
#include "support/golden_trace.h"
#include "trace_inputs.h"

namespace tp100::firmware {
namespace {

using test::GoldenTrace;

// What acts on a track at one moment.
struct Drive {
  double duty = 0.0;  // [0..1]
  double mps = 0.0;
  float load = 0.0f;
  bool free = true;
};

class TrackTrace {
 public:
  void run(int scenario, int steps, const std::function<Drive(int)>& drive,
           std::uint16_t dt_ms = 5) {
    int stalled = 0, reversed = 0;
    double sum = 0.0;
    trace.row({1.0 * scenario, -1.0, 0.0, 0.0, static_cast<double>(monitor.missing_m()), 0.0});
    for (int i = 0; i < steps; ++i) {
      const Drive now = drive(i);
      counts += now.mps * dt_ms * 1e-3 * static_cast<double>(p.counts_per_metre);
      const auto verdict = monitor.update(static_cast<std::int16_t>(now.duty * 1000.0),
                                          static_cast<std::int32_t>(std::floor(counts)), dt_ms,
                                          now.load, now.free, p);
      stalled += verdict == TrackMonitor::kStalled;
      reversed += verdict == TrackMonitor::kReversed;
      sum += static_cast<double>(monitor.missing_m());
      if (i % 16 != 15) continue;
      trace.row({1.0 * scenario, 1.0 * i, 1.0 * stalled, 1.0 * reversed,
                 static_cast<double>(monitor.missing_m()), sum});
      stalled = reversed = 0;
      sum = 0.0;
    }
  }

  GoldenTrace trace{"firmware/track_monitor.csv",
                    {"scenario", "step", "stalled", "reversed", "missing_m", "sum_m"}};
  TrackMonitor monitor;
  wire::Parameters p = uneven_parameters();
  double counts = -1000.0;
};

TEST(GoldenTrackMonitor, LearnsAndJudgesAsRecorded) {
  TrackTrace t;
  const double dead = static_cast<double>(t.p.dead_band);
  const double feed = static_cast<double>(t.p.feed_forward);
  for (const double sign : {1.0, -1.0}) {
    // Its gain sinks and rises slowly while its duty ripples about what it takes.
    t.run(1, 1200, [&](int i) {
      const double mps = 0.09 + 0.06 * zigzag(i, 700);
      const double gain = 1.05 - 0.3 * zigzag(i, 900) + 0.12 * zigzag(i, 34);
      return Drive{sign * (dead + feed * mps * gain), sign * mps};
    });
    t.monitor.reset();
    // The same gain, probed now and then by duties from which it may not learn.
    t.run(6, 2000, [&](int i) {
      const double mps = 0.08 + 0.045 * zigzag(i, 1500);
      const bool probe = i / 16 % 4 == 3;
      const double load = i < 1000 ? 0.0 : 0.02 + 0.02 * zigzag(i, 380);
      const double gain = probe ? 1.6 : 1.0 - 0.35 * zigzag(i, 1100);
      return Drive{sign * (dead + feed * mps * gain + (probe ? 0.12 : 0.01)), sign * mps,
                   static_cast<float>(load), !probe};
    });
    t.monitor.reset();
    // Slow and fast in steps, under loads that it may or may not learn from.
    t.run(2, 1200, [&](int i) {
      const double mps = i % 300 < 150 ? 0.025 + 0.02 * zigzag(i, 1200) : 0.14;
      const double load = 0.03 + 0.03 * zigzag(i, 410);
      return Drive{sign * (dead + 0.9 * feed * mps + load + 0.05 * zigzag(i, 130)), sign * mps,
                   static_cast<float>(load), load < 0.05};
    });
    // Blocked again and again, under different duties.
    t.run(3, 800, [&](int i) {
      const double size = 0.2 + 0.7 * (i / 160) / 5.0;
      return Drive{sign * size, i % 160 < 40 ? sign * (size - dead) / feed : sign * 0.001, 0.02f};
    });
    // Rolls back against its duty, pulled or not.
    t.run(4, 900, [&](int i) {
      const bool pulled = i % 300 >= 150;
      return Drive{sign * (pulled ? 0.2 : 0.35),
                   sign * (pulled ? 0.05 * zigzag(i, 150) - 0.01 : -0.1), pulled ? 0.11f : 0.0f,
                   false};
    });
    // Changes its direction and passes the dead band.
    t.run(
        5, 600,
        [&](int i) {
          const double mps = 0.1 * zigzag(i, 240);
          return Drive{mps * 4.4 + std::copysign(0.13, mps), mps - 0.01 * zigzag(i, 70), 0.01f};
        },
        7);
    t.monitor.reset();
  }
  EXPECT_EQ(t.trace.difference(1e-8), "");
}

/// Time until a verdict, 0: none. Negative: reversed.
int verdict_ms(TrackMonitor& monitor, const wire::Parameters& p, int duty, double mps, int dt_ms,
               float load, int most_ms) {
  double counts = 0.0;
  for (int ms = dt_ms; ms <= most_ms; ms += dt_ms) {
    const auto verdict = monitor.update(static_cast<std::int16_t>(duty),
                                        static_cast<std::int32_t>(std::floor(counts)),
                                        static_cast<std::uint16_t>(dt_ms), load, false, p);
    if (verdict != TrackMonitor::kGood) return verdict == TrackMonitor::kStalled ? ms : -ms;
    counts += mps * dt_ms * 1e-3 * static_cast<double>(p.counts_per_metre);
  }
  return 0;
}

TEST(GoldenTrackMonitor, TakesAsLongAsRecordedToFindAFault) {
  GoldenTrace trace{
      "firmware/track_faults.csv",
      {"stall_ms", "duty", "mps", "load", "dt_ms", "with_estimate", "weak_estimate", "without"}};
  for (const int stall_ms : {120, 333, 1900}) {
    for (const int duty : {140, 160, 310, 449, 450, 640, 990}) {
      for (const double mps : {0.0, 0.0007, 0.004, 0.01, 0.06, -0.003, -0.08}) {
        for (const float load : {0.0f, 0.13f}) {
          const int dt_ms = 3 + (duty + stall_ms) % 7;
          wire::Parameters p = uneven_parameters();
          p.stall_ms = static_cast<std::uint16_t>(stall_ms);
          const int sign = duty % 20 == 0 ? -1 : 1;
          TrackMonitor with, weak, without;
          const int ms = verdict_ms(with, p, sign * duty, sign * mps, dt_ms, load, 4000);
          p.feed_forward = 0.7f;
          const int weak_ms = verdict_ms(weak, p, sign * duty, sign * mps, dt_ms, load, 4000);
          p.feed_forward = 0.0f;
          trace.row({1.0 * stall_ms, 1.0 * sign * duty, mps, static_cast<double>(load), 1.0 * dt_ms,
                     1.0 * ms, 1.0 * weak_ms,
                     1.0 * verdict_ms(without, p, sign * duty, sign * mps, dt_ms, load, 4000)});
        }
      }
    }
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

// Two jumps of the counts, relative to the direction of the duty.
struct Jumps {
  int first = 1;
  int second = 0;
  int spread = 1;  ///< number of samples over which each is spread
};

/// Smallest size of jumps that are found, 0: none.
int smallest_found(const wire::Parameters& p, int dt_ms, int sign, int apart_ms,
                   const Jumps& jumps) {
  constexpr int kFirstMs = 90;
  // All are found or none: from 4 mm or from 8 counts on.
  const int least = p.counts_per_metre < 1000.0f ? 1 : 40;
  for (int size = least; size < least + 70; ++size) {
    TrackMonitor monitor;
    double counts = -3000.0 * sign;
    int first = 0, second = 0;
    for (int ms = 0; ms <= kFirstMs + apart_ms + jumps.spread * dt_ms; ms += dt_ms) {
      counts += sign * 0.06e-3 * dt_ms * static_cast<double>(p.counts_per_metre);
      if (ms >= kFirstMs && first++ < jumps.spread)
        counts += 1.0 * sign * size * jumps.first / jumps.spread;
      if (ms >= kFirstMs + apart_ms && second++ < jumps.spread)
        counts += 1.0 * sign * size * jumps.second / jumps.spread;
      if (monitor.update(static_cast<std::int16_t>(sign * 420),
                         static_cast<std::int32_t>(std::floor(counts)),
                         static_cast<std::uint16_t>(dt_ms), 0.1f, false, p) != TrackMonitor::kGood)
        return size;
    }
  }
  return 0;
}

TEST(GoldenTrackMonitor, ToleratesASingleJumpOfTheRecordedSize) {
  GoldenTrace trace{"firmware/track_jumps.csv",
                    {"dt_ms", "sign", "apart_ms", "one", "onwards", "to_and_fro", "back",
                     "fro_and_to", "slowly_back", "slowly_fro_and_to"}};
  wire::Parameters p = uneven_parameters();
  constexpr Jumps kJumps[] = {{1, 0, 1},  {1, 1, 1},   {1, -1, 1}, {-1, -1, 1},
                              {-1, 1, 1}, {-1, -1, 6}, {-1, 1, 4}};
  const auto record = [&](int dt_ms, int sign, int apart_ms) {
    std::vector<double> row{1.0 * dt_ms, 1.0 * sign, 1.0 * apart_ms};
    for (const Jumps& jumps : kJumps)
      row.push_back(smallest_found(p, dt_ms, sign, apart_ms, jumps));
    trace.row(row);
  };
  for (const int dt_ms : {2, 5, 9}) {
    for (const int sign : {1, -1}) {
      for (int apart_ms = dt_ms; apart_ms < 1200; apart_ms += apart_ms < 140 ? 11 : 155)
        record(dt_ms, sign, apart_ms);
    }
  }
  for (const int apart_ms : {99, 100, 101, 102, 999, 1000, 1001}) record(1, 1, apart_ms);
  p.counts_per_metre = 300.0f;
  for (const int apart_ms : {90, 150, 400}) record(5, apart_ms == 400 ? -1 : 1, apart_ms);
  EXPECT_EQ(trace.difference(1e-8), "");
}

// A robot whose tracks move over the ground.
struct Turning {
  double left_mps = 0.0;
  double right_mps = 0.0;
  double left_counted = 1.0;
  double right_counted = 1.0;
  double offset_radps = 0.0;
  int accel_x = 0;
};

class TurnRun {
 public:
  TurnMonitor::Verdict step(const Turning& now, int dt_ms) {
    const double s = dt_ms * 1e-3;
    left_m += now.left_mps * s / 0.83 * now.left_counted;
    right_m += now.right_mps * s / 0.91 * now.right_counted;
    turned_rad += ((now.right_mps - now.left_mps) / 0.33 + now.offset_radps + bias_radps) * s;
    us += static_cast<std::uint32_t>(dt_ms * 1000);
    const double lsb = turned_rad / static_cast<double>(test::kGyroRadpsPerLsb) / 8e-6;
    const TurnMark mark{us, static_cast<std::uint32_t>(static_cast<std::int64_t>(lsb)),
                        static_cast<std::int32_t>(std::floor(left_m * 11140.0)),
                        static_cast<std::int32_t>(std::floor(right_m * 11140.0))};
    return monitor.update(mark, static_cast<std::int16_t>(now.accel_x),
                          static_cast<float>(bias_radps), p);
  }

  wire::Parameters p = uneven_parameters();
  TurnMonitor monitor;

 private:
  static constexpr double bias_radps = 0.013;
  std::uint32_t us = 0xFFFF0000U;
  double left_m = -0.5;
  double right_m = 0.7;
  double turned_rad = 0.0;
};

TEST(GoldenTurnMonitor, WeighsTurnsAndSlopesAsRecorded) {
  GoldenTrace trace{"firmware/turn_duties.csv", {"step", "slope", "turn", "verdicts"}};
  TurnRun run;
  int verdicts = 0;
  for (int i = 0; i < 4800; ++i) {
    Turning now;
    const double mps = 0.1 * zigzag(i, 1900);
    const double turn = 0.02 * zigzag(i, 700);
    now.left_mps = mps - turn;
    now.right_mps = mps + turn;
    now.accel_x = static_cast<int>(130.0 + 1900.0 * zigzag(i, 1300) * zigzag(i, 4100));
    const auto verdict = run.step(now, 5);
    verdicts += 1 << verdict;
    if (i % 16 == 8) {
      trace.row({1.0 * i, static_cast<double>(run.monitor.slope_duty()),
                 static_cast<double>(run.monitor.turn_duty()), 1.0 * verdicts});
      verdicts = 0;
    }
    if (i == 3000) run.monitor.reset();
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

TEST(GoldenTurnMonitor, TakesAsLongAsRecordedToFindAFault) {
  GoldenTrace trace{"firmware/turn_faults.csv",
                    {"left_mps", "right_mps", "left_counted", "right_counted", "offset_radps",
                     "accel_x", "share", "ms", "verdict"}};
  constexpr double kPairs[][2] = {{0.1, 0.1},     {-0.07, -0.07}, {0.05, 0.12},  {0.13, 0.045},
                                  {-0.12, -0.05}, {-0.03, -0.1},  {0.08, -0.08}, {-0.05, 0.09},
                                  {0.0, 0.1},     {0.09, 0.013},  {0.1, 0.081},  {-0.02, 0.02},
                                  {0.004, 0.11},  {-0.003, 0.1}};
  int n = 0;
  for (const auto& pair : kPairs) {
    for (const double counted : {0.0, 0.4, 0.7, 0.85, 1.0, 1.2}) {
      for (const double offset : {-0.31, -0.1, -0.03, 0.0, 0.025, 0.09, 0.28}) {
        TurnRun run;
        ++n;
        Turning now;
        now.left_mps = pair[0];
        now.right_mps = pair[1];
        now.offset_radps = offset;
        (n % 2 == 0 ? now.left_counted : now.right_counted) = counted;
        run.p.turn_slip_share = static_cast<float>(n % 5) * 0.06f;
        TurnMonitor::Verdict verdict = TurnMonitor::kGood;
        int ms = 0;
        while (verdict == TurnMonitor::kGood && ms < 9000) {
          now.accel_x = ms < 200 || n % 3 != 0 ? 0 : 400;
          verdict = run.step(now, 1 + n % 4);
          ms += 1 + n % 4;
        }
        trace.row({pair[0], pair[1], now.left_counted, now.right_counted, offset, 1.0 * now.accel_x,
                   static_cast<double>(run.p.turn_slip_share), 1.0 * ms,
                   1.0 * static_cast<int>(verdict)});
      }
    }
  }
  EXPECT_EQ(trace.difference(1e-8), "");
}

}  // namespace
}  // namespace tp100::firmware
