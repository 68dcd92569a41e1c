#include "link/clock_sync.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

namespace tp100::link {
namespace {

// A device with a known clock behind a line with delays.
struct Line {
  double ppm = 0.0;
  DeviceUs offset_us = 123'456'789;
  std::function<HostNs(std::mt19937&)> out_delay = [](std::mt19937&) { return HostNs{0}; };
  std::function<HostNs(std::mt19937&, HostNs)> back_delay = [](std::mt19937&, HostNs) {
    return HostNs{0};
  };
  HostNs wire_ns = 100 * kNsPerUs;
  HostNs poll_ns = 1 * kNsPerMs;  // polling period of the host

  DeviceUs device_us(HostNs t) const {
    // The Mega's clock ticks in steps of 4 us.
    const double us = static_cast<double>(t) * 1e-3 * (1.0 + ppm * 1e-6);
    return offset_us + static_cast<DeviceUs>(us / 4.0) * 4;
  }
  double true_host_ns(DeviceUs device) const {
    return (static_cast<double>(device - offset_us)) * 1e3 / (1.0 + ppm * 1e-6);
  }
};

struct Errors {
  std::vector<double> us;
  int accepted = 0;
  int rejected = 0;
  double percentile(double p) {
    std::sort(us.begin(), us.end());
    return us[static_cast<std::size_t>(p * static_cast<double>(us.size() - 1))];
  }
};

// Runs exchanges for `seconds`. Collects |predicted - true| every 5 ms while the clock is valid and
// after `settle_s` have passed.
Errors measure(const Line& line, double seconds, double settle_s, unsigned seed) {
  std::mt19937 random(seed);
  ClockSync sync;
  HostNs now = 3 * kNsPerS;
  const HostNs start = now;
  sync.reset(now);
  Errors errors;
  HostNs reply_at = -1;
  std::uint16_t id = 0;
  DeviceUs received = 0;
  DeviceUs sent = 0;
  while (now < start + from_s(seconds)) {
    now += line.poll_ns;
    if (reply_at >= 0 && now >= reply_at) {
      // The host wakes up when the reply has arrived.
      const auto verdict = sync.answered(id, received, sent, reply_at, line.wire_ns);
      ++(verdict == ClockSync::Verdict::kAccepted ? errors.accepted : errors.rejected);
      reply_at = -1;
    }
    if (const auto due = sync.due(now)) {
      id = *due;
      sync.asked(id, now, line.wire_ns);
      const HostNs arrives = now + line.wire_ns + line.out_delay(random);
      const HostNs leaves = arrives + 200 * kNsPerUs;
      received = line.device_us(arrives);
      sent = line.device_us(leaves);
      const HostNs ends = leaves + line.wire_ns;
      reply_at = ends + line.back_delay(random, ends);
    }
    if (sync.state().valid && now > start + from_s(settle_s)) {
      const DeviceUs device = line.device_us(now);
      errors.us.push_back(
          std::abs(static_cast<double>(sync.state().to_host(device)) - line.true_host_ns(device)) *
          1e-3);
    }
  }
  return errors;
}

std::function<HostNs(std::mt19937&, HostNs)> exponential_back(double mean_us) {
  return [mean_us](std::mt19937& random, HostNs) {
    return static_cast<HostNs>(std::exponential_distribution<>(1.0 / mean_us)(random) * 1e3);
  };
}
std::function<HostNs(std::mt19937&)> exponential_out(double mean_us) {
  return [mean_us](std::mt19937& random) {
    return static_cast<HostNs>(std::exponential_distribution<>(1.0 / mean_us)(random) * 1e3);
  };
}

void expect(const char* name, const Line& line, double seconds, double settle_s, double p50_us,
            double p99_us) {
  Errors errors = measure(line, seconds, settle_s, 7);
  ASSERT_FALSE(errors.us.empty());
  std::printf("%-28s p50 %7.1f us  p99 %7.1f us  rejected %d of %d\n", name, errors.percentile(0.5),
              errors.percentile(0.99), errors.rejected, errors.rejected + errors.accepted);
  EXPECT_LT(errors.percentile(0.5), p50_us) << name;
  EXPECT_LT(errors.percentile(0.99), p99_us) << name;
}

TEST(ClockSync, IsExactToTheTickOnAPerfectLine) { expect("perfect", {}, 60, 0.5, 6, 8); }

TEST(ClockSync, AnswersThatTakeLongerThanTheQuickPeriodAreUsed) {
  Line slow;
  slow.out_delay = [](std::mt19937&) { return 60 * kNsPerMs; };
  slow.back_delay = [](std::mt19937&, HostNs) { return 60 * kNsPerMs; };
  expect("60 ms each way", slow, 20, 3, 2000, 2000);
}

TEST(ClockSync, ALongTripThatIsUsualIsNoStall) {
  Line slow;
  slow.out_delay = [](std::mt19937&) { return 60 * kNsPerMs; };
  slow.back_delay = [](std::mt19937&, HostNs) { return 60 * kNsPerMs; };
  const Errors errors = measure(slow, 20, 3, 7);
  EXPECT_GT(errors.accepted, 60);
  EXPECT_EQ(errors.rejected, 0);
}

TEST(ClockSync, AfterAMissingAnswerTheNextRequestWaitsForThePeriodAndForTheLimit) {
  for (const HostNs answer_ns : {200 * kNsPerMs, 500 * kNsPerMs}) {
    ClockSync sync(answer_ns);
    sync.reset(0);
    for (int i = 0; i < ClockSync::kQuickExchanges; ++i) {
      const HostNs now = sync.next_ns();
      const std::uint16_t id = *sync.due(now);
      sync.asked(id, now, 0);
      sync.answered(id, now / kNsPerUs, now / kNsPerUs, now, 0);
    }
    const HostNs now = sync.next_ns();
    sync.asked(*sync.due(now), now, 0);
    EXPECT_EQ(sync.next_ns() - now,
              answer_ns > ClockSync::kPeriodNs ? answer_ns : ClockSync::kPeriodNs);
  }
}

TEST(ClockSync, AnswersLaterThanTheLimitAreCountedAsLate) {
  ClockSync sync(100 * kNsPerMs);
  sync.reset(0);
  const std::uint16_t first = *sync.due(0);
  sync.asked(first, 0, 0);
  EXPECT_FALSE(sync.due(99 * kNsPerMs));
  const std::uint16_t second = *sync.due(100 * kNsPerMs);
  sync.asked(second, 100 * kNsPerMs, 0);
  EXPECT_EQ(sync.answered(first, 1, 1, 101 * kNsPerMs, 0), ClockSync::Verdict::kLate);
  EXPECT_EQ(sync.late(), 1U);
  EXPECT_EQ(sync.answered(second, 100'001, 100'001, 102 * kNsPerMs, 0),
            ClockSync::Verdict::kAccepted);
}

TEST(ClockSync, FollowsDrift) {
  for (const double ppm : {-1000.0, -100.0, 100.0, 1000.0}) {
    Line line;
    line.ppm = ppm;
    expect(("drift " + std::to_string(static_cast<int>(ppm)) + " ppm").c_str(), line, 60, 10, 10,
           20);
  }
}

TEST(ClockSync, IsUsableFromTheStartAtLargeDrift) {
  Line line;
  line.ppm = 1000;
  Errors errors = measure(line, 3, 0.2, 7);
  EXPECT_LT(errors.percentile(1.0), 1200);
}

TEST(ClockSync, AveragesJitter) {
  Line line;
  line.ppm = 40;
  line.out_delay = exponential_out(100);
  line.back_delay = exponential_back(100);
  expect("jitter 100 us each way", line, 120, 10, 60, 150);
}

TEST(ClockSync, SurvivesBatchesOf16Ms) {
  Line line;
  line.ppm = 40;
  line.out_delay = exponential_out(50);
  line.back_delay = [](std::mt19937&, HostNs t) { return 16'384'000 - t % 16'384'000; };
  expect("16 ms batching", line, 120, 30, 2000, 5000);
}

// The earliest request and the earliest reply may belong to different exchanges.
TEST(ClockSync, TakesTheEarliestOfEachDirection) {
  Line line;
  line.ppm = 100;
  line.out_delay = [](std::mt19937& random) {
    return HostNs{random() % 4 == 0 ? 5 : 400} * kNsPerUs;
  };
  line.back_delay = [](std::mt19937& random, HostNs) {
    return HostNs{random() % 4 == 0 ? 5 : 900} * kNsPerUs;
  };
  expect("one direction fast in four", line, 120, 20, 20, 60);
}

TEST(ClockSync, GatesStalls) {
  Line line;
  line.ppm = -100;
  line.out_delay = exponential_out(20);
  line.back_delay = [](std::mt19937& random, HostNs) {
    return random() % 5 == 0 ? 30 * kNsPerMs : 20 * kNsPerUs;
  };
  Errors errors = measure(line, 120, 10, 7);
  EXPECT_GT(errors.rejected, 5);
  EXPECT_LT(errors.percentile(0.99), 100);
}

TEST(ClockSync, DriftIsFoundWithinAFewPpm) {
  Line line;
  line.ppm = 250;
  ClockSync sync;
  HostNs now = 0;
  sync.reset(now);
  while (now < 40 * kNsPerS) {
    now += kNsPerMs;
    if (const auto id = sync.due(now)) {
      sync.asked(*id, now, 0);
      const DeviceUs device = line.device_us(now + 50 * kNsPerUs);
      sync.answered(*id, device, device, now + 100 * kNsPerUs, 0);
    }
  }
  EXPECT_NEAR(sync.state().drift, -250e-6, 5e-6);
  EXPECT_NEAR(sync.state().uncertainty_us, 50, 15);
}

TEST(ClockSync, StartsAnewAfterAJumpOfTheDeviceClock) {
  Line line;
  ClockSync sync;
  HostNs now = 0;
  sync.reset(now);
  int restarts = 0;
  HostNs restarted_ns = 0;
  int within_a_second = 0;
  while (now < 30 * kNsPerS) {
    now += kNsPerMs;
    if (now == 10 * kNsPerS) line.offset_us += 500'000;
    if (const auto id = sync.due(now)) {
      sync.asked(*id, now, 0);
      if (restarts > 0 && now - restarted_ns < kNsPerS) ++within_a_second;
      const DeviceUs device = line.device_us(now);
      if (sync.answered(*id, device, device, now, 0) != ClockSync::Verdict::kRestarted) continue;
      ++restarts;
      restarted_ns = now;
    }
  }
  EXPECT_EQ(restarts, 1);
  EXPECT_GE(within_a_second, ClockSync::kQuickExchanges) << "it must ask quickly again";
  EXPECT_NEAR(static_cast<double>(sync.state().to_host(line.device_us(now)) - now), 0.0, 10e3);
}

TEST(ClockSync, TakesTheRequestsWireTimeFromItsBeginningAndTheReplysFromItsEnd) {
  // A request behind 50 spare delimiters takes three times as long as its reply, and there are no
  // other delays.
  constexpr HostNs kRequestNs = 1140 * kNsPerUs;
  constexpr HostNs kReplyNs = 380 * kNsPerUs;
  ClockSync sync;
  HostNs now = kNsPerS;
  sync.reset(now);
  for (std::uint16_t id = 1; id <= ClockSync::kValidAfter; ++id) {
    sync.asked(id, now, kRequestNs);
    const HostNs received_ns = now + kRequestNs;
    const HostNs sent_ns = received_ns + 100 * kNsPerUs;
    EXPECT_EQ(
        sync.answered(id, received_ns / kNsPerUs, sent_ns / kNsPerUs, sent_ns + kReplyNs, kReplyNs),
        ClockSync::Verdict::kAccepted);
    now += ClockSync::kQuickPeriodNs;
  }
  ASSERT_TRUE(sync.state().valid);
  EXPECT_NEAR(static_cast<double>(sync.state().to_host(now / kNsPerUs) - now), 0.0, 5e3);
}

TEST(ClockSync, ARepliesMiddleIsExactForEvenAndOddTimesInTheRobot) {
  for (const DeviceUs inside_us : {100, 101}) {
    ClockSync sync;
    HostNs now = kNsPerS;
    sync.reset(now);
    for (std::uint16_t id = 1; id <= ClockSync::kValidAfter; ++id) {
      sync.asked(id, now, 0);
      const DeviceUs received_us = now / kNsPerUs;
      const HostNs back_ns = now + inside_us * kNsPerUs;
      EXPECT_EQ(sync.answered(id, received_us, received_us + inside_us, back_ns, 0),
                ClockSync::Verdict::kAccepted);
      now += ClockSync::kQuickPeriodNs;
    }
    ASSERT_TRUE(sync.state().valid);
    EXPECT_NEAR(static_cast<double>(sync.state().to_host(now / kNsPerUs) - now), 0.0, 100.0)
        << inside_us;
  }
}

TEST(ClockSync, TakesOnlyTheReplyThatItWaitsFor) {
  ClockSync sync;
  sync.reset(0);
  const std::uint16_t first = *sync.due(0);
  sync.asked(first, 0, 0);
  EXPECT_EQ(sync.answered(static_cast<std::uint16_t>(first + 9), 5, 5, 1000, 0),
            ClockSync::Verdict::kUnmatched);
  EXPECT_EQ(sync.answered(first, 5, 5, 100'000, 0), ClockSync::Verdict::kAccepted);
  EXPECT_EQ(sync.answered(first, 5, 5, 100'000, 0), ClockSync::Verdict::kUnmatched);
  const HostNs later = 60 * kNsPerMs;
  const std::uint16_t second = *sync.due(later);
  EXPECT_NE(first, second);
  sync.asked(second, later, 0);
  const HostNs latest = 300 * kNsPerMs;
  const std::uint16_t third = *sync.due(latest);
  sync.asked(third, latest, 0);
  EXPECT_EQ(sync.answered(second, 60'000, 60'000, latest + 1000, 0), ClockSync::Verdict::kLate);
}

TEST(ClockSync, RejectsTimesThatCannotBe) {
  ClockSync sync;
  sync.reset(0);
  sync.asked(1, 0, 0);
  EXPECT_EQ(sync.answered(1, 1000, 900, 10 * kNsPerMs, 0), ClockSync::Verdict::kOutlier);
  sync.asked(2, 0, 0);
  EXPECT_EQ(sync.answered(2, 1000, 900'000, 10 * kNsPerMs, 0), ClockSync::Verdict::kOutlier);
  EXPECT_FALSE(sync.state().valid);
}

TEST(ClockSync, AsksQuicklyAtFirstAndThenFourTimesASecond) {
  ClockSync sync;
  HostNs now = 0;
  sync.reset(now);
  std::vector<HostNs> asked;
  while (now < 10 * kNsPerS) {
    if (const auto id = sync.due(now)) {
      asked.push_back(now);
      sync.asked(*id, now, 0);
      sync.answered(*id, now / 1000, now / 1000, now, 0);
    }
    now += kNsPerMs;
  }
  ASSERT_GT(asked.size(), 12u);
  EXPECT_EQ(asked[1] - asked[0], ClockSync::kQuickPeriodNs);
  EXPECT_LT(asked[7], 500 * kNsPerMs);
  EXPECT_NEAR(to_s(asked[11] - asked[10]), 0.247, 0.002);
  EXPECT_LT(asked.size(), 50u);
}

TEST(ClockSync, WireTimesThatCannotBeRightAreNotExact) {
  // On a pseudo-terminal, bytes take no time, whatever the baud rate is.
  ClockSync sync;
  HostNs now = kNsPerS;
  sync.reset(now);
  for (int i = 0; i < 20; ++i) {
    std::optional<std::uint16_t> id;
    while (!id) id = sync.due(now += 50 * kNsPerMs);
    sync.asked(*id, now, 200 * kNsPerUs);
    now += 300 * kNsPerUs;
    const DeviceUs device_us = now / kNsPerUs - 150;
    sync.answered(*id, device_us, device_us, now, 200 * kNsPerUs);
  }
  EXPECT_GE(sync.state().uncertainty_us, 150.0);
  EXPECT_GE(sync.state_at(now).uncertainty_us, 150.0);
}

TEST(ClockSync, ExchangesThatContradictEachOtherAreNotExact) {
  ClockSync sync;
  HostNs now = kNsPerS;
  sync.reset(now);
  // Each way takes 50 us; then the device's clock is found 400 us ahead.
  for (int i = 0; i < 12; ++i) {
    now = sync.next_ns();
    sync.asked(static_cast<std::uint16_t>(i), now, 0);
    const DeviceUs device = (now + 50 * kNsPerUs) / kNsPerUs + (i < 11 ? 0 : 400);
    now += 100 * kNsPerUs;
    EXPECT_EQ(sync.answered(static_cast<std::uint16_t>(i), device, device, now, 0),
              ClockSync::Verdict::kAccepted);
  }
  EXPECT_GE(sync.state().uncertainty_us, 45.0);
}

TEST(ClockSync, UncertaintyGrowsWithoutReplies) {
  ClockSync sync;
  sync.reset(0);
  for (HostNs now = 0; now < kNsPerS; now += 50 * kNsPerMs) {
    sync.asked(1, now, 0);
    sync.answered(1, now / 1000, now / 1000, now, 0);
  }
  EXPECT_GT(sync.state_at(100 * kNsPerS).uncertainty_us,
            sync.state_at(2 * kNsPerS).uncertainty_us + 250);
}

}  // namespace
}  // namespace tp100::link
