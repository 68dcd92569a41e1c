#include <gtest/gtest.h>

#include <array>
#include <random>

#include "session_bench.h"

namespace tp100::link {
namespace {

// A ready session that the test then feeds sample by sample.
class SampleLoss : public ::testing::Test {
 protected:
  SampleLoss() {
    bench_.connect();
    bench_.robot.silent = true;
    bench_.samples.clear();
    before_ = bench_.session.counters();
    base_us_ = bench_.robot.device_us(bench_.now) + 5000U;
  }

  wire::Sample at(int index) {
    wire::Sample sample = bench_.robot.sample(bench_.now);
    sample.sequence = static_cast<std::uint16_t>(bench_.robot.sequence + index);
    sample.device_us = base_us_ + 5000U * static_cast<std::uint32_t>(index);
    return sample;
  }
  void feed(const wire::Sample& sample) {
    bench_.session.receive(frame_of(sample), bench_.now);
    for (const Sample& taken : bench_.session.take_samples()) bench_.samples.push_back(taken);
  }
  LinkCounters delta() const {
    LinkCounters d = bench_.session.counters();
    d.samples -= before_.samples;
    d.lost -= before_.lost;
    d.frames_in -= before_.frames_in;
    return d;
  }

  SessionBench bench_;
  LinkCounters before_{};
  std::uint32_t base_us_ = 0;
};

TEST_F(SampleLoss, GapsAreCountedAndReportedToTheConsumer) {
  bench_.now += 200 * kNsPerMs;
  feed(at(0));
  feed(at(3));
  feed(at(4));
  ASSERT_EQ(bench_.samples.size(), 3u);
  EXPECT_EQ(bench_.samples[1].lost_before, 2u);
  EXPECT_EQ(bench_.samples[2].lost_before, 0u);
  EXPECT_EQ(delta().lost, 2u);
}

TEST_F(SampleLoss, ASampleKeepsTheDutyOfEachTrackWithItsSign) {
  bench_.now += 200 * kNsPerMs;
  wire::Sample sample = at(0);
  sample.left_duty = -wire::kFullDuty;
  sample.right_duty = wire::kFullDuty / 4;
  feed(sample);
  ASSERT_EQ(bench_.samples.size(), 1u);
  EXPECT_DOUBLE_EQ(bench_.samples[0].left_duty, -1.0);
  EXPECT_DOUBLE_EQ(bench_.samples[0].right_duty, 0.25);
}

TEST_F(SampleLoss, ADutyBeyondFullIsImplausibleBothWays) {
  bench_.now += 200 * kNsPerMs;
  for (const int duty : {wire::kFullDuty + 1, -wire::kFullDuty - 1}) {
    wire::Sample left = at(0), right = at(0);
    left.left_duty = right.right_duty = static_cast<std::int16_t>(duty);
    feed(left);
    feed(right);
  }
  EXPECT_TRUE(bench_.samples.empty());
}

TEST_F(SampleLoss, DuplicatesAreCountedAndNotHandedOn) {
  bench_.now += 200 * kNsPerMs;
  feed(at(0));
  feed(at(0));
  feed(at(1));
  feed(at(0));
  EXPECT_EQ(bench_.samples.size(), 2u);
  EXPECT_EQ(delta().duplicated, 2u);
  EXPECT_EQ(delta().lost, 0u);
}

TEST_F(SampleLoss, ALateSampleIsReorderedAndNoLongerLost) {
  bench_.now += 200 * kNsPerMs;
  feed(at(0));
  feed(at(2));
  feed(at(1));
  EXPECT_EQ(bench_.samples.size(), 2u);
  EXPECT_EQ(delta().reordered, 1u);
  EXPECT_EQ(delta().lost, 0u);
}

TEST_F(SampleLoss, DeviceTimeGoingBackIsImplausible) {
  bench_.now += 200 * kNsPerMs;
  feed(at(0));
  wire::Sample sample = at(1);
  sample.device_us -= 20'000;
  feed(sample);
  EXPECT_EQ(bench_.samples.size(), 1u);
  EXPECT_EQ(delta().implausible, 1u);
}

TEST_F(SampleLoss, ASampleFromTheFutureIsImplausible) {
  bench_.now += 200 * kNsPerMs;
  wire::Sample sample = at(0);
  sample.device_us += 2'000'000;
  feed(sample);
  EXPECT_TRUE(bench_.samples.empty());
  EXPECT_EQ(delta().implausible, 1u);
}

TEST_F(SampleLoss, AStreamThatMakesNoSenseLeadsToANewSession) {
  bench_.now += 200 * kNsPerMs;
  feed(at(0));
  for (int i = 0; i < SampleIntake::kNonsense; ++i) {
    wire::Sample sample = at(1 + i);
    sample.device_us -= 3'000'000;
    feed(sample);
  }
  EXPECT_EQ(bench_.session.state(), SessionState::kHello);
}

TEST_F(SampleLoss, WhatNobodyTakesIsBoundedAndCountsAsLost) {
  bench_.now += 450 * kNsPerMs;
  const int total = 90;
  for (int i = 0; i < total; ++i) bench_.session.receive(frame_of(at(i)), bench_.now);
  const auto samples = bench_.session.take_samples();
  ASSERT_EQ(samples.size(), Session::kMaxSamples);
  EXPECT_EQ(samples[0].lost_before, total - Session::kMaxSamples);
  EXPECT_EQ(delta().lost, total - Session::kMaxSamples);
  EXPECT_EQ(delta().samples, Session::kMaxSamples);
}

TEST_F(SampleLoss, WhateverCorruptsAFrameIsCountedByItsCause) {
  const auto counts = [&] {
    const LinkCounters& c = bench_.session.counters();
    return std::array{c.oversize, c.cobs_errors, c.undersize, c.crc_errors};
  };
  std::vector<std::uint8_t> oversize(wire::kMaxFrame + 5, 0x01);
  oversize.push_back(0x00);
  const std::array<std::vector<std::uint8_t>, 4> corrupted{
      oversize, {0x09, 'x', 'y', 0x00}, {0x02, 'x', 0x00}, {0x05, 'x', 'y', 'z', 'u', 0x00}};
  for (std::size_t cause = 0; cause < corrupted.size(); ++cause) {
    auto expected = counts();
    ++expected.at(cause);
    bench_.session.receive(corrupted.at(cause), bench_.now);
    EXPECT_EQ(counts(), expected) << cause;
  }
}

TEST(SampleWrap, SequenceTimeAndCountsRunThroughTheirWraps) {
  SessionBench bench;
  bench.robot.device_offset_us = 0xFFFFFFFFU - 2'000'000U;
  bench.robot.sequence = 65500;
  bench.robot.metres_per_s = 10.0;
  bench.connect();
  bench.run(3000);
  ASSERT_GT(bench.samples.size(), 500u);
  EXPECT_EQ(bench.session.counters().lost, 0u);
  for (std::size_t i = 1; i < bench.samples.size(); ++i) {
    ASSERT_EQ(bench.samples[i].device_us - bench.samples[i - 1].device_us, 5000);
    ASSERT_NEAR(
        static_cast<double>(bench.samples[i].left_counts - bench.samples[i - 1].left_counts), 557.0,
        1.0);
    ASSERT_NEAR(to_s(bench.samples[i].measured_ns - bench.samples[i - 1].measured_ns), 0.005, 1e-4);
  }
}

TEST(SampleWrap, DeviceTimeSurvivesASilenceOfHours) {
  DeviceClock clock;
  const DeviceUs start = clock.extend(1000, 0);
  const HostNs later = 7200 * kNsPerS;
  const auto device = static_cast<std::uint32_t>(1000 + later / kNsPerUs + 300);
  EXPECT_EQ(clock.extend(device, later) - start, later / kNsPerUs + 300);
}

// Under random corruption, every sample is either passed on or counted by exactly one loss counter.
TEST(SampleConservation, EverySampleIsHandedOnOrCounted) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SessionBench bench;
    bench.connect();
    bench.run(1000);
    std::mt19937 random(seed);
    const std::size_t before = bench.samples.size();
    const std::uint16_t first = bench.robot.sequence;
    std::uint64_t flips = 0;
    bench.mangle = [&](std::vector<std::uint8_t>& bytes) {
      if (bytes.empty() || random() % 10 != 0) return;
      bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1U << (random() % 8));
      ++flips;
    };
    bench.run(5000);
    bench.mangle = nullptr;
    bench.run(50);
    ASSERT_GT(flips, 10u);
    const LinkCounters& counters = bench.session.counters();
    const std::uint64_t sent = static_cast<std::uint16_t>(bench.robot.sequence - first);
    ASSERT_EQ(bench.samples.size() - before + counters.lost, sent) << seed;
    ASSERT_LE(counters.lost, 2 * flips) << seed;
    ASSERT_GT(counters.crc_errors + counters.cobs_errors, 0u);
    ASSERT_EQ(bench.session.session_number(), 1u);
  }
}

TEST(SampleConservation, RandomBytesDoNoHarm) {
  std::mt19937 random(99);
  SessionBench bench;
  bench.connect();
  bench.mangle = [&](std::vector<std::uint8_t>& bytes) {
    for (int i = 0; i < 200; ++i)
      bytes.push_back(static_cast<std::uint8_t>(random() % 4 ? random() : 0));
  };
  bench.run(2000);
  bench.mangle = nullptr;
  bench.run(1500);
  EXPECT_EQ(bench.session.state(), SessionState::kReady);
}

}  // namespace
}  // namespace tp100::link
