// Which datagrams of cameras are used, and when what they saw was measured.
#include "link/camera_intake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../support/corrupted.h"
#include "jpeg.h"

namespace tp100::link {
namespace {

constexpr HostNs kAge = 60 * kNsPerMs;

/// A sender with its own clock.
struct Sender {
  std::string clock = "here";
  HostNs ahead_ns = 0;  ///< its clock minus the receiver's
  std::uint32_t stream = 1;
  std::uint32_t sequence = 0;

  /// A message about an image taken at `taken_ns` of the receiver's clock and sent `age_ns` later.
  std::string datagram(HostNs taken_ns, HostNs age_ns = kAge) {
    CameraMessage message;
    message.stream = stream;
    message.clock = clock;
    message.sequence = ++sequence;
    message.stamp_us = (taken_ns + ahead_ns) / kNsPerUs;
    message.age_us = age_ns / kNsPerUs;
    message.x_m = 1.0;
    return encode(message);
  }
  /// An image that was taken then.
  std::string image(HostNs taken_ns) {
    return encode(ImageMessage{stream, clock, ++sequence, taken_ns / kNsPerUs, 0, kJpeg});
  }

  static inline const std::string kJpeg = test::jpeg(64, 48);
};

class CameraIntakeTest : public ::testing::Test {
 protected:
  CameraIntake intake{"here", 400 * kNsPerMs};
  Sender sender;
  HostNs now = 100 * kNsPerS;
};

TEST_F(CameraIntakeTest, TheClockOfAnotherMachineIsFoundToTheShortestWay) {
  sender = {.clock = "there", .ahead_ns = 7777 * kNsPerS};
  std::mt19937 random(3);
  std::exponential_distribution<double> delay_ms(1.0 / 3.0);
  double worst_s = 0.0;
  for (int i = 0; i < 3000; ++i) {
    now += 30 * kNsPerMs;
    // The sender's clock drifts by 30 ppm.
    sender.ahead_ns += 900;
    const HostNs delay_ns = 200 * kNsPerUs + from_s(delay_ms(random) * 1e-3);
    const auto sample = intake.receive(sender.datagram(now - kAge), now + delay_ns);
    ASSERT_TRUE(sample.has_value());
    if (i > 100) worst_s = std::max(worst_s, std::abs(to_s(sample->measured_ns - (now - kAge))));
  }
  EXPECT_LT(worst_s, 0.001);
  EXPECT_GT(worst_s, 0.0001) << "the shortest delay remains as an error";
}

TEST(ClockOffsetTest, LastsForTwoWindowsWithoutDatagramsAtMost) {
  for (const HostNs silence_ns : {10 * kNsPerS - 1, 10 * kNsPerS}) {
    ClockOffset offset;
    offset.add(0, 5 * kNsPerMs);
    const HostNs now = 5 * kNsPerMs + silence_ns;
    offset.add(now - 9 * kNsPerMs, now);
    EXPECT_EQ(offset.offset_ns(), silence_ns < 10 * kNsPerS ? 5 * kNsPerMs : 9 * kNsPerMs);
  }
}

TEST_F(CameraIntakeTest, WhatIsTooOldOrFromTheFutureIsNotUsed) {
  EXPECT_FALSE(intake.receive(sender.datagram(now - 401 * kNsPerMs), now));
  EXPECT_EQ(intake.counters().late, 1U);
  EXPECT_FALSE(intake.receive(sender.datagram(now + 11 * kNsPerMs), now));
  EXPECT_EQ(intake.counters().early, 1U);
  const auto sample = intake.receive(sender.datagram(now - 399 * kNsPerMs), now);
  ASSERT_TRUE(sample.has_value());
  EXPECT_EQ(sample->measured_ns, now - 399 * kNsPerMs) << "stamps of this machine are as they are";
  EXPECT_EQ(sample->sequence, 3U);
  EXPECT_EQ(sample->x_m, 1.0);
  EXPECT_EQ(intake.counters().accepted, 1U);
}

TEST_F(CameraIntakeTest, RepeatedAndReorderedDatagramsAreNotUsedTwiceAndMissingOnesAreCounted) {
  const std::string first = sender.datagram(now - kAge);
  sender.sequence += 3;
  const std::string later = sender.datagram(now - kAge + 30 * kNsPerMs);
  const std::string last = sender.datagram(now);
  EXPECT_TRUE(intake.receive(first, now));
  EXPECT_TRUE(intake.receive(last, now));
  EXPECT_EQ(intake.counters().missing, 4U);
  for (const std::string& again : {first, later, last}) EXPECT_FALSE(intake.receive(again, now));
  EXPECT_EQ(intake.counters().late, 3U);
}

TEST_F(CameraIntakeTest, ASecondStreamIsIgnoredWhileTheFirstSpeaksAndHeardAfterIt) {
  Sender first = sender, second{.stream = 2};
  for (int i = 0; i < 10; ++i) {
    now += 30 * kNsPerMs;
    EXPECT_TRUE(intake.receive(first.datagram(now - kAge), now));
    EXPECT_FALSE(intake.receive(second.datagram(now - kAge), now));
  }
  EXPECT_EQ(intake.counters().foreign, 10U);
  now += kNsPerS;
  EXPECT_TRUE(intake.receive(second.datagram(now - kAge), now));
  EXPECT_FALSE(intake.receive(first.datagram(now - kAge), now));
  EXPECT_EQ(intake.counters().streams, 2U);
}

TEST_F(CameraIntakeTest, OneDatagramWithAnAbsurdSequenceDoesNotDeafenItForLong) {
  sender.sequence = 4'000'000'000U;
  EXPECT_TRUE(intake.receive(sender.datagram(now - kAge), now));
  sender.sequence = 0;
  int used = 0;
  for (int i = 0; i < 100; ++i) {
    now += 30 * kNsPerMs;
    used += intake.receive(sender.datagram(now - kAge), now).has_value();
  }
  EXPECT_GT(used, 60);
  EXPECT_EQ(intake.counters().streams, 1U);
}

TEST(ImageIntake, AtMostTheRateThatIsAskedForIsTakenAndNoneIsLostAtThatRate) {
  constexpr HostNs kInterval = 100 * kNsPerMs;
  for (const HostNs period : {kInterval / 9, kInterval}) {
    CameraIntake intake("here", kNsPerS);
    Sender camera;
    std::mt19937 random(3);
    const HostNs most = period / 5;
    std::uniform_int_distribution<HostNs> jitter(-most, most);
    HostNs now = 100 * kNsPerS;
    const auto first = intake.receive_image(camera.image(now - kNsPerMs), kInterval, now);
    ASSERT_TRUE(first.has_value());
    EXPECT_EQ(first->taken_ns, now - kNsPerMs);
    EXPECT_EQ(first->jpeg, Sender::kJpeg);
    for (int i = 1; i < 900; ++i) {
      now += period;
      intake.receive_image(camera.image(now + jitter(random)), kInterval, now + most);
    }
    EXPECT_NEAR(static_cast<double>(intake.counters().accepted),
                static_cast<double>(900 * period / kInterval), 2.0);
    EXPECT_EQ(intake.counters().accepted + intake.counters().dropped, 900U);
  }
}

TEST_F(CameraIntakeTest, WhateverComesIsCountedOnceAndWhatIsUsedIsInRange) {
  std::mt19937 random(7);
  CameraIntake images("here", 400 * kNsPerMs);
  for (int i = 0; i < 20'000; ++i) {
    now += 30 * kNsPerMs;
    const auto seen =
        intake.receive(test::corrupted(sender.datagram(now - kAge), i, 5, random), now);
    const auto shown =
        images.receive_image(test::corrupted(sender.image(now - kAge), i, 5, random), 0, now);
    if (seen) {
      EXPECT_LE(std::abs(seen->x_m), 1000.0);
      EXPECT_LE(std::abs(seen->yaw_rad), 100.0);
    }
    for (const HostNs at : {seen ? seen->measured_ns : now, shown ? shown->taken_ns : now}) {
      EXPECT_GE(at, now - 400 * kNsPerMs);
      EXPECT_LE(at, now + 10 * kNsPerMs);
    }
  }
  for (const CameraCounters& c : {intake.counters(), images.counters()}) {
    EXPECT_EQ(c.received, 20'000U);
    EXPECT_EQ(c.received, c.accepted + c.malformed + c.late + c.early + c.foreign + c.dropped);
    EXPECT_GT(c.malformed, 1000U);
    EXPECT_GT(c.accepted, 0U) << "a message with a corrupted digit can still be valid";
  }
}

}  // namespace
}  // namespace tp100::link
