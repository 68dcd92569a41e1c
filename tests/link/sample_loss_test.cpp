#include <gtest/gtest.h>

#include <array>
#include <random>

#include "session_rig.h"

namespace tp100::link {
namespace {

// A ready session that the test then feeds sample by sample.
class SampleLoss : public ::testing::Test {
 protected:
  SampleLoss() {
    rig_.connect();
    rig_.robot.silent = true;
    rig_.samples.clear();
    before_ = rig_.session.counters();
    base_us_ = rig_.robot.device_us(rig_.now) + 5000U;
  }

  wire::Sample at(int index) {
    wire::Sample sample = rig_.robot.sample(rig_.now);
    sample.sequence = static_cast<std::uint16_t>(rig_.robot.sequence + index);
    sample.device_us = base_us_ + 5000U * static_cast<std::uint32_t>(index);
    return sample;
  }
  void feed(const wire::Sample& sample) {
    rig_.session.receive(frame_of(sample), rig_.now);
    for (const Sample& taken : rig_.session.take_samples()) rig_.samples.push_back(taken);
  }
  LinkCounters delta() const {
    LinkCounters d = rig_.session.counters();
    d.samples -= before_.samples;
    d.lost -= before_.lost;
    d.frames_in -= before_.frames_in;
    return d;
  }

  SessionRig rig_;
  LinkCounters before_{};
  std::uint32_t base_us_ = 0;
};

TEST_F(SampleLoss, GapsAreCountedAndReportedToTheConsumer) {
  rig_.now += 200 * kNsPerMs;
  feed(at(0));
  feed(at(3));
  feed(at(4));
  ASSERT_EQ(rig_.samples.size(), 3u);
  EXPECT_EQ(rig_.samples[1].lost_before, 2u);
  EXPECT_EQ(rig_.samples[2].lost_before, 0u);
  EXPECT_EQ(delta().lost, 2u);
}

TEST_F(SampleLoss, ASampleKeepsTheDutyOfEachTrackWithItsSign) {
  rig_.now += 200 * kNsPerMs;
  wire::Sample sample = at(0);
  sample.left_duty = -wire::kFullDuty;
  sample.right_duty = wire::kFullDuty / 4;
  feed(sample);
  ASSERT_EQ(rig_.samples.size(), 1u);
  EXPECT_DOUBLE_EQ(rig_.samples[0].left_duty, -1.0);
  EXPECT_DOUBLE_EQ(rig_.samples[0].right_duty, 0.25);
}

TEST_F(SampleLoss, ADutyBeyondFullIsImplausibleBothWays) {
  rig_.now += 200 * kNsPerMs;
  for (const int duty : {wire::kFullDuty + 1, -wire::kFullDuty - 1}) {
    wire::Sample left = at(0), right = at(0);
    left.left_duty = right.right_duty = static_cast<std::int16_t>(duty);
    feed(left);
    feed(right);
  }
  EXPECT_TRUE(rig_.samples.empty());
}

TEST_F(SampleLoss, DuplicatesAreCountedAndNotHandedOn) {
  rig_.now += 200 * kNsPerMs;
  feed(at(0));
  feed(at(0));
  feed(at(1));
  feed(at(0));
  EXPECT_EQ(rig_.samples.size(), 2u);
  EXPECT_EQ(delta().duplicated, 2u);
  EXPECT_EQ(delta().lost, 0u);
}

TEST_F(SampleLoss, ALateSampleIsReorderedAndNoLongerLost) {
  rig_.now += 200 * kNsPerMs;
  feed(at(0));
  feed(at(2));
  feed(at(1));
  EXPECT_EQ(rig_.samples.size(), 2u);
  EXPECT_EQ(delta().reordered, 1u);
  EXPECT_EQ(delta().lost, 0u);
}

TEST_F(SampleLoss, DeviceTimeGoingBackIsImplausible) {
  rig_.now += 200 * kNsPerMs;
  feed(at(0));
  wire::Sample sample = at(1);
  sample.device_us -= 20'000;
  feed(sample);
  EXPECT_EQ(rig_.samples.size(), 1u);
  EXPECT_EQ(delta().implausible, 1u);
}

TEST_F(SampleLoss, ASampleFromTheFutureIsImplausible) {
  rig_.now += 200 * kNsPerMs;
  wire::Sample sample = at(0);
  sample.device_us += 2'000'000;
  feed(sample);
  EXPECT_TRUE(rig_.samples.empty());
  EXPECT_EQ(delta().implausible, 1u);
}

TEST_F(SampleLoss, AStreamThatMakesNoSenseLeadsToANewSession) {
  rig_.now += 200 * kNsPerMs;
  feed(at(0));
  for (int i = 0; i < SampleIntake::kNonsense; ++i) {
    wire::Sample sample = at(1 + i);
    sample.device_us -= 3'000'000;
    feed(sample);
  }
  EXPECT_EQ(rig_.session.state(), SessionState::kHello);
}

TEST_F(SampleLoss, WhatNobodyTakesIsBoundedAndCountsAsLost) {
  rig_.now += 450 * kNsPerMs;
  const int total = 90;
  for (int i = 0; i < total; ++i) rig_.session.receive(frame_of(at(i)), rig_.now);
  const auto samples = rig_.session.take_samples();
  ASSERT_EQ(samples.size(), Session::kMaxSamples);
  EXPECT_EQ(samples[0].lost_before, total - Session::kMaxSamples);
  EXPECT_EQ(delta().lost, total - Session::kMaxSamples);
  EXPECT_EQ(delta().samples, Session::kMaxSamples);
}

TEST_F(SampleLoss, WhateverCorruptsAFrameIsCountedByItsCause) {
  const auto counts = [&] {
    const LinkCounters& c = rig_.session.counters();
    return std::array{c.oversize, c.cobs_errors, c.undersize, c.crc_errors};
  };
  std::vector<std::uint8_t> oversize(wire::kMaxFrame + 5, 0x01);
  oversize.push_back(0x00);
  const std::array<std::vector<std::uint8_t>, 4> corrupted{
      oversize, {0x09, 'x', 'y', 0x00}, {0x02, 'x', 0x00}, {0x05, 'x', 'y', 'z', 'u', 0x00}};
  for (std::size_t cause = 0; cause < corrupted.size(); ++cause) {
    auto expected = counts();
    ++expected.at(cause);
    rig_.session.receive(corrupted.at(cause), rig_.now);
    EXPECT_EQ(counts(), expected) << cause;
  }
}

TEST(SampleWrap, SequenceTimeAndCountsRunThroughTheirWraps) {
  SessionRig rig;
  rig.robot.device_offset_us = 0xFFFFFFFFU - 2'000'000U;
  rig.robot.sequence = 65500;
  rig.robot.metres_per_s = 10.0;
  rig.connect();
  rig.run(3000);
  ASSERT_GT(rig.samples.size(), 500u);
  EXPECT_EQ(rig.session.counters().lost, 0u);
  for (std::size_t i = 1; i < rig.samples.size(); ++i) {
    ASSERT_EQ(rig.samples[i].device_us - rig.samples[i - 1].device_us, 5000);
    ASSERT_NEAR(static_cast<double>(rig.samples[i].left_counts - rig.samples[i - 1].left_counts),
                557.0, 1.0);
    ASSERT_NEAR(to_s(rig.samples[i].measured_ns - rig.samples[i - 1].measured_ns), 0.005, 1e-4);
  }
}

TEST(SampleWrap, DeviceTimeSurvivesASilenceOfHours) {
  DeviceClock clock;
  const DeviceUs start = clock.extend(1000, 0);
  const HostNs later = 7200 * kNsPerS;
  const auto device = static_cast<std::uint32_t>(1000 + later / kNsPerUs + 300);
  EXPECT_EQ(clock.extend(device, later) - start, later / kNsPerUs + 300);
}

TEST(SampleWrap, DeviceTimeIsExactForWeeksWhateverTheDrift) {
  for (const double rate : {0.995, 1.0, 1.005}) {
    DeviceClock clock;
    const DeviceUs start = clock.extend(0, 0);
    for (HostNs now = 0; now < 30 * 86400 * kNsPerS; now += 600 * kNsPerS) {
      const auto us = static_cast<DeviceUs>(static_cast<double>(now / kNsPerUs) * rate);
      ASSERT_EQ(clock.extend(static_cast<std::uint32_t>(us), now) - start, us) << rate;
    }
  }
}

// Under random corruption, every sample is either passed on or counted by exactly one loss counter.
TEST(SampleConservation, EverySampleIsHandedOnOrCounted) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SessionRig rig;
    rig.connect();
    rig.run(1000);
    std::mt19937 random(seed);
    const std::size_t before = rig.samples.size();
    const std::uint16_t first = rig.robot.sequence;
    std::uint64_t flips = 0;
    rig.mangle = [&](std::vector<std::uint8_t>& bytes) {
      if (bytes.empty() || random() % 10 != 0) return;
      bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1U << (random() % 8));
      ++flips;
    };
    rig.run(5000);
    rig.mangle = nullptr;
    rig.run(50);
    ASSERT_GT(flips, 10u);
    const LinkCounters& counters = rig.session.counters();
    const std::uint64_t sent = static_cast<std::uint16_t>(rig.robot.sequence - first);
    ASSERT_EQ(rig.samples.size() - before + counters.lost, sent) << seed;
    ASSERT_LE(counters.lost, 2 * flips) << seed;
    ASSERT_GT(counters.crc_errors + counters.cobs_errors, 0u);
    ASSERT_EQ(rig.session.session_number(), 1u);
  }
}

TEST(SampleConservation, RandomBytesDoNoHarm) {
  std::mt19937 random(99);
  SessionRig rig;
  rig.connect();
  rig.mangle = [&](std::vector<std::uint8_t>& bytes) {
    for (int i = 0; i < 200; ++i)
      bytes.push_back(static_cast<std::uint8_t>(random() % 4 ? random() : 0));
  };
  rig.run(2000);
  rig.mangle = nullptr;
  rig.run(1500);
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

}  // namespace
}  // namespace tp100::link
