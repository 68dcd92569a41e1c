// Golden traces of the clock relation: exchanges on lines with drift, jitter, stalls and jumps.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "link/clock_sync.h"
#include "support/golden_trace.h"

namespace tp100::link {
namespace {

/// What the line does to exchange `i`; times in us.
struct Delays {
  HostNs out_us = 0, inside_us = 0, back_us = 0;
};

struct TracedLine {
  std::function<Delays(int)> delays;
  std::function<double(int)> ppm = [](int) { return 0.0; };
  std::function<double(int)> jump_us = [](int) { return 0.0; };
  HostNs request_wire_ns = 0, reply_wire_ns = 0;
  HostNs answer_ns = ClockSync::kAnswerNs;
  /// Whether the answer to exchange `i` is lost.
  std::function<bool(int)> lost = [](int) { return false; };
};

/// A number of 0 to `below`, by index.
HostNs scattered(int i, HostNs below) {
  auto mixed = static_cast<std::uint32_t>(i) * 2654435761U;
  mixed ^= mixed >> 15U;
  mixed *= 2246822519U;
  return static_cast<HostNs>(mixed >> 8U) % below;
}

std::string difference(const std::string& file, const TracedLine& line, int exchanges) {
  test::GoldenTrace trace(
      "link/" + file + ".csv",
      {"ms", "id", "verdict", "wait_us", "waits", "late", "valid", "reference_us", "error_us",
       "error_later_us", "drift_ppm", "uncertainty_us", "uncertainty_later_us"});
  ClockSync sync(line.answer_ns);
  const HostNs start = 7 * kNsPerS + 123;
  HostNs now = start;
  sync.reset(now);
  double device_us = 4e6;
  HostNs device_at = now;
  const auto device = [&](int i, HostNs at) {
    device_us += static_cast<double>(at - device_at) * 1e-3 * (1.0 + line.ppm(i) * 1e-6);
    device_at = at;
    return static_cast<DeviceUs>(device_us + line.jump_us(i));
  };
  for (int i = 0; i < exchanges; ++i) {
    now = sync.next_ns() + scattered(i, 900) * kNsPerUs;
    const std::optional<std::uint16_t> id = sync.due(now);
    if (!id) return "an exchange that is due is not asked for";
    sync.asked(*id, now, line.request_wire_ns);
    if (line.lost(i)) {
      trace.row({to_s(now - start) * 1e3, static_cast<double>(*id), -1.0,
                 static_cast<double>(sync.next_ns() - now) * 1e-3,
                 static_cast<double>(sync.expects_reply(now + 30 * kNsPerMs - 1)),
                 static_cast<double>(sync.late()), static_cast<double>(sync.state().valid), 0.0,
                 0.0, 0.0, 0.0, 0.0, 0.0});
      continue;
    }
    const Delays delays = line.delays(i);
    const HostNs arrives = now + line.request_wire_ns + delays.out_us * kNsPerUs;
    const HostNs leaves = arrives + delays.inside_us * kNsPerUs;
    const DeviceUs received_us = device(i, arrives), sent_us = device(i, leaves);
    const HostNs back = leaves + delays.back_us * kNsPerUs + line.reply_wire_ns;
    const auto verdict = sync.answered(*id, received_us, sent_us, back, line.reply_wire_ns);
    const ClockState state = sync.state();
    const auto error_us = [&](HostNs later) {
      const auto later_us = static_cast<DeviceUs>(static_cast<double>(later) * 1e-3);
      return static_cast<double>(state.to_host(sent_us + later_us) - leaves - later) * 1e-3;
    };
    trace.row({to_s(now - start) * 1e3, static_cast<double>(*id), static_cast<double>(verdict),
               static_cast<double>(sync.next_ns() - now) * 1e-3,
               static_cast<double>(sync.expects_reply(now + 30 * kNsPerMs)),
               static_cast<double>(sync.late()), static_cast<double>(state.valid),
               static_cast<double>(state.reference_us - sent_us), error_us(0),
               error_us(2 * kNsPerS), state.drift * 1e6, state.uncertainty_us,
               sync.state_at(back + 20 * kNsPerS).uncertainty_us});
    now = back;
  }
  return trace.difference(1e-5);
}

TEST(ClockSync, ANewOneKnowsAndExpectsNothing) {
  const ClockSync sync;
  EXPECT_FALSE(sync.state().valid);
  EXPECT_EQ(sync.late(), 0U);
  EXPECT_EQ(sync.next_ns(), 0);
  EXPECT_FALSE(sync.expects_reply(0));
  EXPECT_EQ(sync.state_at(5).uncertainty_us, 0.0);
}

TEST(ClockSync, ExpectsAReplyFor30MsAndNotAfterAReset) {
  ClockSync sync;
  sync.reset(0);
  sync.asked(1, 0, 0);
  EXPECT_TRUE(sync.expects_reply(30 * kNsPerMs - 1));
  EXPECT_FALSE(sync.expects_reply(30 * kNsPerMs));
  sync.reset(1);
  EXPECT_FALSE(sync.expects_reply(2));
  EXPECT_EQ(sync.answered(1, 5, 5, 2, 0), ClockSync::Verdict::kUnmatched);
}

TEST(ClockSync, AReplyMayBeReadLittleBeforeItsRequestOnly) {
  for (const HostNs early_ns : {200'000, 200'001}) {
    ClockSync sync;
    sync.reset(0);
    sync.asked(1, kNsPerS, 0);
    EXPECT_EQ(sync.answered(1, 5, 5, kNsPerS - early_ns, 0),
              early_ns > 200'000 ? ClockSync::Verdict::kOutlier : ClockSync::Verdict::kAccepted);
  }
}

TEST(ClockSync, AnAnswerIsLateForTheLast16RequestsAndUnknownForOlderOnes) {
  ClockSync sync;
  sync.reset(0);
  for (std::uint16_t id = 1; id <= 20; ++id) sync.asked(id, id * kNsPerS, 0);
  EXPECT_EQ(sync.answered(4, 5, 5, 20 * kNsPerS, 0), ClockSync::Verdict::kLate);
  EXPECT_EQ(sync.answered(3, 5, 5, 20 * kNsPerS, 0), ClockSync::Verdict::kUnmatched);
  EXPECT_EQ(sync.answered(21, 5, 5, 20 * kNsPerS, 0), ClockSync::Verdict::kUnmatched);
  EXPECT_EQ(sync.late(), 1U);
}

TEST(ClockTrace, JitterEachWayAndDriftThatChanges) {
  TracedLine line;
  line.request_wire_ns = 140 * kNsPerUs;
  line.reply_wire_ns = 380 * kNsPerUs;
  line.delays = [](int i) {
    return Delays{20 + scattered(i, 300), 40 + scattered(i + 500, 97),
                  35 + scattered(i + 900, 700)};
  };
  line.ppm = [](int i) { return 300.0 + 120.0 * std::sin(i * 0.05); };
  EXPECT_EQ(difference("clock_jitter", line, 300), "");
}

TEST(ClockTrace, StallsOfEverySizeBelowAndAboveTheGate) {
  TracedLine line;
  line.delays = [](int i) {
    const HostNs stall_us = i % 5 == 3 ? i * 13 : 0;
    const bool out = i % 2 == 0;
    return Delays{90 + scattered(i, 60) + (out ? stall_us : 0), 51,
                  60 + scattered(i + 77, 80) + (out ? 0 : stall_us)};
  };
  line.ppm = [](int) { return -450.0; };
  EXPECT_EQ(difference("clock_stalls", line, 320), "");
}

TEST(ClockTrace, WireTimesThatAreNominalOnly) {
  TracedLine line;
  line.request_wire_ns = 500 * kNsPerUs;
  line.reply_wire_ns = 400 * kNsPerUs;
  // The wire is quicker than assumed: from a little to more than can be.
  line.delays = [](int i) {
    return Delays{30 - i * 3 + scattered(i, 20), 33, -(i % 7) * 60 + scattered(i + 40, 30)};
  };
  EXPECT_EQ(difference("clock_nominal", line, 200), "");
}

TEST(ClockTrace, ShortJumpsOfTheDeviceClockAndLastingOnes) {
  TracedLine line;
  line.delays = [](int i) { return Delays{100 + scattered(i, 50), 20, 80 + scattered(i + 9, 70)}; };
  line.ppm = [](int) { return 90.0; };
  line.jump_us = [](int i) {
    const double size_us = 1500.0 + 60.0 * (i / 12);
    const double sign = i / 12 % 2 == 0 ? 1.0 : -1.0;
    const int lasts = 1 + i / 12 % 5;
    return i > 80 && i % 12 < lasts ? sign * size_us : 0.0;
  };
  EXPECT_EQ(difference("clock_jumps", line, 300), "");
}

TEST(ClockTrace, LostAnswersAndALimitAboveThePeriod) {
  TracedLine line;
  line.answer_ns = 410 * kNsPerMs;
  line.delays = [](int i) { return Delays{9000 + scattered(i, 9000), 300, 70'000 - i * 200}; };
  line.lost = [](int i) { return scattered(i + 3, 10) < 3; };
  EXPECT_EQ(difference("clock_lost", line, 120), "");
}

TEST(ClockTrace, DeviceTimesRunThroughTheirWrapsAndBack) {
  test::GoldenTrace trace("link/device_clock.csv", {"wraps", "us"});
  DeviceClock clock;
  HostNs now = 5 * kNsPerS;
  std::int64_t true_us = 0xFFFF'0000;
  for (int i = 0; i < 200; ++i) {
    if (i == 150) clock.forget();
    const HostNs step_us = i % 10 == 9 ? 1'700'000'000 : 40'000 + scattered(i, 10'000);
    now += step_us * kNsPerUs;
    true_us += step_us + (i % 3 == 0 ? 400 : -250);
    // Every fourth one is late.
    const std::int64_t read_us = true_us - (i % 4 == 1 ? 900'000 + scattered(i, 700'000) : 0);
    const DeviceUs extended = clock.extend(static_cast<std::uint32_t>(read_us), now);
    const auto wraps = static_cast<double>(extended >> 32);
    trace.row(
        {wraps, static_cast<double>(extended - (extended >> 32 << 32) - (read_us & 0xFFFFFFFF))});
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(ClockTrace, ExchangesOfASession) {
  test::GoldenTrace trace(
      "link/robot_clock.csv",
      {"ms", "kind", "bytes", "valid", "error_us", "uncertainty_us", "fitted_uncertainty_us",
       "late", "expects", "replies", "rejected", "corrupted", "missed", "unwritten"});
  for (const std::uint32_t baud : {57'600U, 500'000U, 0U}) {
    LinkCounters counters{};
    OutputQueue<kMaxOut> output(counters);
    RobotClock clock(baud, 90 * kNsPerMs, output, counters);
    HostNs now = 3 * kNsPerS;
    clock.begin_session(now);
    HostNs asked_ns = 0;
    std::uint16_t id = 0;
    const auto row = [&](double kind, double bytes) {
      const ClockState& state = clock.state();
      const auto device_us = static_cast<DeviceUs>(now / kNsPerUs + 0xFFF0'0000);
      trace.row(
          {to_s(now) * 1e3, kind, bytes, static_cast<double>(state.valid),
           state.valid ? static_cast<double>(state.to_host(device_us) - now) * 1e-3 : 0.0,
           state.uncertainty_us, clock.fitted().uncertainty_us, static_cast<double>(clock.late()),
           static_cast<double>(clock.expects_reply(now)),
           static_cast<double>(counters.sync_replies), static_cast<double>(counters.sync_rejected),
           static_cast<double>(counters.robot_corrupted),
           static_cast<double>(counters.missed_edges), static_cast<double>(counters.unwritten)});
    };
    for (int ms = 1; ms < 4000; ++ms) {
      now += kNsPerMs;
      if (ms == 2500) clock.end_session();
      if (ms == 2600) clock.begin_session(now);
      if (ms == 2600 && baud != 0) clock.forget_boot();
      if (ms == 3300) output.pad(1000);
      if (clock.request(ms % 500 == 333, now)) {
        asked_ns = now;
        ++id;
        row(0.0, static_cast<double>(output.bytes().size()));
        if (ms < 3300 || ms > 3350) output.written(output.bytes().size());
      } else if (ms == 3302) {
        row(1.0, static_cast<double>(output.bytes().size()));
      }
      if (ms == 3350) output.drop();
      const HostNs trip_ms = 12 + id % 5 + (id % 7 == 6 ? 85 : 0);
      if (now == asked_ns + trip_ms * kNsPerMs) {
        const auto device_us =
            static_cast<std::uint32_t>(now / kNsPerUs + 0xFFF0'0000 - 6000 + id % 3 * 200);
        clock.on_reply(
            wire::SyncReply{static_cast<std::uint16_t>(id), device_us - 150, device_us,
                            static_cast<std::uint16_t>(65'530 + id * (id % 6 == 2 ? 1 : 3)),
                            static_cast<std::uint16_t>(65'500 + id * (id % 5 == 1 ? 4 : 11))},
            19, now);
        row(2.0, 0.0);
      }
      clock.age(now);
      if (ms % 100 == 50) row(3.0, static_cast<double>(output.bytes().size()));
    }
  }
  EXPECT_EQ(trace.difference(1e-5), "");
}

}  // namespace
}  // namespace tp100::link
