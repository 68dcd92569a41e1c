// The relation of the robot's clock to the host's, on lines with every kind of delay.
#include "link/clock_sync.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "support/sequence.h"

namespace tp100::link {
namespace {

using Verdict = ClockSync::Verdict;

/// Times of one exchange beyond those on the wire, which are nominal. In us.
struct Delays {
  HostNs out = 0, inside = 200, back = 0;
};

/// A device behind a line, and the host's side of their exchanges.
class Line {
 public:
  explicit Line(double drift_ppm = 0.0, HostNs answer_ns = ClockSync::kAnswerNs)
      : sync(answer_ns), rate_(1.0 + drift_ppm * 1e-6) {
    sync.reset(now);
  }

  /// Makes the next exchange at the first whole millisecond at which it is due.
  Verdict exchange(const Delays& delays) {
    while (!sync.due(now)) now += kNsPerMs;
    const std::uint16_t id = *sync.due(now);
    sync.asked(id, now, request_wire_us * kNsPerUs);
    const HostNs arrives = now + (request_wire_us + delays.out) * kNsPerUs;
    const HostNs leaves = arrives + delays.inside * kNsPerUs;
    const HostNs back = leaves + (delays.back + reply_wire_us) * kNsPerUs;
    const Verdict verdict =
        sync.answered(id, device_us(arrives), device_us(leaves), back, reply_wire_us * kNsPerUs);
    now = std::max(back, now) / kNsPerMs * kNsPerMs + kNsPerMs;
    return verdict;
  }
  void exchange(int times, const Delays& delays) {
    for (int i = 0; i < times; ++i) exchange(delays);
  }
  DeviceUs device_us(HostNs at) const {
    const double us = static_cast<double>(at - kBegin) * 1e-3 * rate_;
    return offset_us +
           static_cast<DeviceUs>(std::floor(us / static_cast<double>(tick_us))) * tick_us;
  }
  /// Estimated less true host time of the device's time at `at`.
  double error_us(HostNs at) const {
    const DeviceUs device = device_us(at);
    const double true_ns = static_cast<double>(device - offset_us) * 1e3 / rate_;
    return (static_cast<double>(sync.state().to_host(device) - kBegin) - true_ns) * 1e-3;
  }

  static constexpr HostNs kBegin = 3 * kNsPerS;
  ClockSync sync;
  HostNs now = kBegin;
  DeviceUs offset_us = 123'456'789;
  DeviceUs tick_us = 4;  // of a Mega's clock
  HostNs request_wire_us = 100, reply_wire_us = 100;

 private:
  double rate_;
};

HostNs exponential(test::Sequence& random, double mean_us) {
  return static_cast<HostNs>(-mean_us * std::log(1.0 - random.between(0.0, 1.0)));
}

/// Delays of exchanges, given the time at which each begins.
using DelaysAt = std::function<Delays(test::Sequence&, HostNs)>;

DelaysAt jitter(double out_us, double back_us) {
  return [=](test::Sequence& random, HostNs) {
    return Delays{.out = exponential(random, out_us), .back = exponential(random, back_us)};
  };
}

TEST(ClockSync, IsAsExactAsTheLineAllows) {
  const DelaysAt none = [](test::Sequence&, HostNs) { return Delays{}; };
  struct Case {
    const char* name;
    double drift_ppm;
    DelaysAt delays;
    double settle_s, p50_us, p99_us;
  };
  const std::vector<Case> cases = {
      {"perfect", 0, none, 0.5, 6, 8},
      {"much drift, from the start", 1000, none, 0.2, 20, 1200},
      {"drift", -1000, none, 10, 10, 20},
      {"drift", 100, none, 10, 10, 20},
      {"drift", 1000, none, 10, 10, 20},
      {"jitter of 100 us each way", 40, jitter(100, 100), 10, 60, 150},
      {"60 ms each way", 0,
       [](test::Sequence&, HostNs) { return Delays{.out = 60'000, .back = 60'000}; }, 3, 20, 20},
      {"replies in batches of 16 ms", 40,
       [](test::Sequence& random, HostNs at) {
         return Delays{.out = exponential(random, 50), .back = 16'384 - at / kNsPerUs % 16'384};
       },
       30, 2000, 5000},
      // The earliest request and the earliest reply may belong to different exchanges.
      {"one direction fast in four", 100,
       [](test::Sequence& random, HostNs) {
         return Delays{.out = random.below(4) == 0 ? 5 : 400, .back = random.below(4) ? 900 : 5};
       },
       20, 20, 60},
      {"stalls", -100,
       [](test::Sequence& random, HostNs) {
         return Delays{.out = exponential(random, 20), .back = random.below(5) == 0 ? 30'000 : 20};
       },
       10, 60, 100},
  };
  for (const Case& each : cases) {
    SCOPED_TRACE(each.name);
    test::Sequence random(7);
    Line line(each.drift_ppm);
    std::vector<double> errors_us;
    while (line.now < Line::kBegin + 120 * kNsPerS) {
      line.exchange(each.delays(random, line.now));
      if (!line.sync.state().valid || line.now < Line::kBegin + from_s(each.settle_s)) continue;
      for (HostNs at = line.now; at < line.sync.next_ns(); at += 5 * kNsPerMs)
        errors_us.push_back(std::abs(line.error_us(at)));
    }
    std::sort(errors_us.begin(), errors_us.end());
    ASSERT_GT(errors_us.size(), 10'000U);
    EXPECT_LT(errors_us[errors_us.size() / 2], each.p50_us);
    EXPECT_LT(errors_us[errors_us.size() * 99 / 100], each.p99_us);
  }
}

TEST(ClockSync, TheTruthIsWithinTheUncertainty) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Line line(100.0 * static_cast<double>(seed) - 1000.0);
    line.tick_us = 1;
    test::Sequence random(seed);
    for (int i = 0; i < 150; ++i) {
      Delays delays = jitter(80, 250)(random, line.now);
      if (random.chance(0.1)) (random.chance(0.5) ? delays.out : delays.back) += random.below(3000);
      line.exchange(delays);
      // Before that the drift is a guess; the bounds are those of the drift that was found.
      if (i < 50) continue;
      const double uncertainty_us = line.sync.state_at(line.now).uncertainty_us;
      ASSERT_LE(std::abs(line.error_us(line.now)), uncertainty_us + 15.0) << i;
    }
  }
}

// Beyond 2 ms: from the fourth exchange in a row on it is another clock.
TEST(ClockSync, FollowsALastingJumpOfTheDeviceClockAndNoShortOne) {
  for (const int lasts : {1, 3, 4}) {
    for (const DeviceUs jump_us : {-2050, 2050}) {
      Line line, less;
      less.exchange(20, {});
      less.offset_us += jump_us / 2050 * 1950;
      EXPECT_EQ(less.exchange({}), Verdict::kAccepted) << "it is taken as an error";
      line.exchange(20, {});
      line.offset_us += jump_us;
      std::vector<Verdict> verdicts;
      for (int i = 0; i < lasts; ++i) verdicts.push_back(line.exchange({}));
      if (lasts < 4) line.offset_us -= jump_us;
      std::vector<Verdict> wanted(static_cast<std::size_t>(lasts), Verdict::kOutlier);
      if (lasts == 4) wanted.back() = Verdict::kRestarted;
      EXPECT_EQ(verdicts, wanted);
      EXPECT_EQ(line.exchange({}), Verdict::kAccepted);
      const HostNs before = line.now;
      line.exchange({});
      EXPECT_EQ(line.now - before < 100 * kNsPerMs, lasts == 4) << "it must ask quickly again";
      line.exchange(10, {});
      EXPECT_NEAR(line.error_us(line.now), 0.0, 10.0);
    }
  }
}

// The gate is 0.5 ms, and five times what is usual, above the best of the last exchanges. What is
// usual is a mean with a weight of 1/8: after 8 exchanges that are 0.4 ms late each way it is
// 0.4 (1 - (7/8)^8) = 0.26 ms, and the gate (0.5 + 5 * 0.26) ms each way, 3.62 ms both.
TEST(ClockSync, AnExchangeFarAboveTheUsualTripIsNotUsed) {
  const auto verdict = [](int usually_late, HostNs late_us) {
    Line line;
    line.exchange(8, {});
    line.exchange(usually_late, {.back = 800});
    return line.exchange({.back = late_us});
  };
  EXPECT_EQ(verdict(0, 990), Verdict::kAccepted);
  EXPECT_EQ(verdict(0, 1020), Verdict::kOutlier);
  EXPECT_EQ(verdict(8, 3500), Verdict::kAccepted);
  EXPECT_EQ(verdict(8, 3750), Verdict::kOutlier);
}

TEST(ClockSync, WireTimesThatCannotBeRightAreNotExact) {
  // On a pseudo-terminal bytes take less time than their baud rate says; here half of it is left.
  Line line;
  line.request_wire_us = line.reply_wire_us = 200;
  line.exchange(20, {.out = -100, .inside = 0, .back = -100});
  EXPECT_NEAR(line.sync.state().uncertainty_us, 100.0, 1.0);
  EXPECT_NEAR(line.sync.state_at(line.now).uncertainty_us, 100.0, 1.0);
}

TEST(ClockSync, ExchangesThatContradictEachOtherAreNotExact) {
  Line line;
  line.exchange(11, {.out = 50, .inside = 0, .back = 50});
  line.offset_us += 400;
  line.exchange({.out = 50, .inside = 0, .back = 50});
  EXPECT_NEAR(line.sync.state().uncertainty_us, 50.0, 1.0) << "half of the quickest trip";
}

TEST(ClockSync, AsksQuicklyAtFirstAndThenFourTimesASecond) {
  for (const HostNs answer_ns : {200 * kNsPerMs, 500 * kNsPerMs}) {
    ClockSync sync(answer_ns);
    sync.reset(0);
    for (int i = 0; i < 12; ++i) {
      const HostNs now = sync.next_ns();
      EXPECT_FALSE(sync.due(now - 1));
      const std::uint16_t id = *sync.due(now);
      sync.asked(id, now, 0);
      const HostNs period = i < ClockSync::kQuickExchanges ? 0 : ClockSync::kPeriodNs;
      EXPECT_EQ(sync.next_ns() - now, std::max(answer_ns, period)) << "an answer may be lost";
      EXPECT_TRUE(sync.expects_reply(now + 30 * kNsPerMs - 1));
      EXPECT_FALSE(sync.expects_reply(now + 30 * kNsPerMs));
      sync.answered(id, now / kNsPerUs, now / kNsPerUs, now, 0);
      EXPECT_FALSE(sync.expects_reply(now));
      const bool quick = i + 1 <= ClockSync::kQuickExchanges;
      EXPECT_EQ(sync.next_ns() - now, quick ? ClockSync::kQuickPeriodNs : ClockSync::kPeriodNs);
    }
  }
}

TEST(ClockSync, TakesOnlyTheReplyThatItWaitsForAndCallsThoseOfTheLast16RequestsLate) {
  ClockSync sync;
  sync.reset(0);
  for (std::uint16_t id = 1; id <= 20; ++id) sync.asked(id, id * kNsPerS, 0);
  const HostNs now = 20 * kNsPerS;
  const DeviceUs device_us = now / kNsPerUs;
  EXPECT_EQ(sync.answered(21, device_us, device_us, now, 0), Verdict::kUnmatched);
  EXPECT_EQ(sync.answered(3, device_us, device_us, now, 0), Verdict::kUnmatched);
  EXPECT_EQ(sync.answered(4, device_us, device_us, now, 0), Verdict::kLate);
  EXPECT_EQ(sync.answered(19, device_us, device_us, now, 0), Verdict::kLate);
  EXPECT_EQ(sync.late(), 2U);
  EXPECT_EQ(sync.answered(20, device_us, device_us, now, 0), Verdict::kAccepted);
  EXPECT_EQ(sync.answered(20, device_us, device_us, now, 0), Verdict::kUnmatched) << "repeated";
  sync.asked(21, now, 0);
  sync.reset(now);
  EXPECT_FALSE(sync.expects_reply(now));
  EXPECT_EQ(sync.late(), 0U);
  EXPECT_EQ(sync.answered(21, device_us, device_us, now, 0), Verdict::kUnmatched);
}

TEST(ClockSync, RejectsTimesThatCannotBe) {
  const HostNs asked = kNsPerS;
  const auto verdict = [&](DeviceUs received_us, DeviceUs sent_us, HostNs back_ns) {
    ClockSync sync;
    sync.reset(0);
    sync.asked(1, asked, 0);
    return sync.answered(1, received_us, sent_us, asked + back_ns, 0);
  };
  EXPECT_EQ(verdict(1000, 900, 10 * kNsPerMs), Verdict::kOutlier) << "it is sent before it came";
  EXPECT_EQ(verdict(1000, 900'000, 10 * kNsPerMs), Verdict::kOutlier) << "it lasted longer";
  // Clocks are read a little before or after the bytes move.
  EXPECT_EQ(verdict(5, 5, -200 * kNsPerUs), Verdict::kAccepted);
  EXPECT_EQ(verdict(5, 5, -200 * kNsPerUs - 1), Verdict::kOutlier);
}

// Read in any order within some seconds, and after silences of hours.
TEST(DeviceClock, IsExactForWeeksWhateverTheDrift) {
  for (const double rate : {0.995, 1.0, 1.005}) {
    DeviceClock clock;
    test::Sequence random(3);
    HostNs now = 5 * kNsPerS;
    const auto read_us = [&](HostNs at) {
      return 0xFFFF'0000 + static_cast<DeviceUs>(static_cast<double>(at / kNsPerUs) * rate);
    };
    const DeviceUs start =
        clock.extend(static_cast<std::uint32_t>(read_us(now)), now) - read_us(now);
    for (int i = 0; i < 3000; ++i) {
      now += random.chance(0.2) ? random.below(40'000) * kNsPerS : random.below(500) * kNsPerMs;
      const HostNs read = now - (random.chance(0.2) ? random.below(1600) * kNsPerMs : 0);
      ASSERT_EQ(clock.extend(static_cast<std::uint32_t>(read_us(read)), now) - start, read_us(read))
          << rate << " " << i;
    }
    EXPECT_GT(now, 14 * 86'400 * kNsPerS);
    clock.forget();
    EXPECT_EQ(clock.extend(77, now), 77) << "another boot";
  }
}

/// A clock of a robot that answers each request after a while.
struct RobotClockTest : testing::Test {
  /// Asks if that is due, and gets the answer after `delay_ns`; false: it was not due or had no
  /// room.
  bool exchange(RobotClock& clock, std::uint32_t baud, HostNs delay_ns = 0) {
    now += kNsPerMs;
    if (!clock.request(false, now)) return false;
    constexpr HostNs kInsideNs = 150 * kNsPerUs;
    constexpr std::size_t kReplyBytes = 19;
    const auto wire_ns = [&](std::size_t bytes) {
      return baud == 0 ? 0 : static_cast<HostNs>(bytes) * 10 * kNsPerS / baud;
    };
    const HostNs received = now + wire_ns(output.bytes().size());
    output.written(output.bytes().size());
    const HostNs back = received + kInsideNs + delay_ns + wire_ns(kReplyBytes);
    const auto device_us = [](HostNs at) { return static_cast<std::uint32_t>(at / kNsPerUs); };
    wire::SyncReply reply{};
    reply.id = ++id;
    reply.received_us = device_us(received);
    reply.sent_us = device_us(received + kInsideNs);
    clock.on_reply(reply, kReplyBytes, back);
    now = back / kNsPerMs * kNsPerMs;
    return true;
  }

  LinkCounters counters{};
  OutputQueue<kMaxOut> output{counters};
  HostNs now = 3 * kNsPerS;
  std::uint16_t id = 0;
};

TEST_F(RobotClockTest, KnowsWhatBytesTakeAtEachBaudRate) {
  for (const std::uint32_t baud : {57'600U, 500'000U, 0U}) {
    RobotClock clock(baud, 90 * kNsPerMs, output, counters);
    clock.begin_session(now);
    id = 0;
    for (int exchanges = 0; exchanges < 20;) exchanges += exchange(clock, baud) ? 1 : 0;
    ASSERT_TRUE(clock.state().valid);
    const auto error_ns = clock.state().to_host(now / kNsPerUs) - now;
    EXPECT_NEAR(static_cast<double>(error_ns), 0.0, 5e3) << baud;
    EXPECT_LT(clock.state().uncertainty_us, 5.0);
    clock.age(now + 20 * kNsPerS);
    EXPECT_GT(clock.state().uncertainty_us, 55.0);
    EXPECT_LT(clock.fitted().uncertainty_us, 5.0);
    clock.end_session();
    EXPECT_FALSE(clock.state().valid);
  }
  EXPECT_EQ(counters.sync_replies, 60U);
  EXPECT_EQ(counters.sync_rejected, 0U);
}

TEST_F(RobotClockTest, ARequestThatFindsNoRoomIsMadeOnceThereIsSome) {
  RobotClock clock(0, 90 * kNsPerMs, output, counters);
  clock.begin_session(now);
  output.pad(kMaxOut);
  EXPECT_FALSE(exchange(clock, 0));
  EXPECT_EQ(counters.unwritten, 1U);
  output.drop();
  EXPECT_TRUE(exchange(clock, 0));
  EXPECT_EQ(counters.sync_replies, 1U);
  EXPECT_TRUE(clock.request(true, now)) << "to keep the robot alive it asks at once";
}

}  // namespace
}  // namespace tp100::link
