// Device times without wraps, and the exchanges of a session by which its clock is found.
#include <gtest/gtest.h>

#include "link/clock_sync.h"
#include "support/sequence.h"

namespace tp100::link {
namespace {

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

TEST_F(RobotClockTest, AnswersThatComeTooLateAreRejectedAndCounted) {
  RobotClock clock(0, 90 * kNsPerMs, output, counters);
  clock.begin_session(now);
  while (!clock.request(false, now)) now += kNsPerMs;
  const wire::SyncReply late{1, 5, 5, 0, 0};
  now += 90 * kNsPerMs;
  EXPECT_TRUE(clock.request(false, now)) << "the next is asked for";
  clock.on_reply(late, 19, now);
  EXPECT_EQ(clock.late(), 1U);
  EXPECT_EQ(counters.sync_rejected, 1U);
  EXPECT_EQ(counters.sync_replies, 0U);
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
