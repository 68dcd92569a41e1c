#include "sim/faults/frame_faults.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/wire_host.h"
#include "core/time.h"

namespace tp100::sim {
namespace {

// Receives a hello, then samples and answers to clock requests in turn, 5 ms apart, through a cable
// with this fault.
struct Passed : test::ReceivedFrames {
  explicit Passed(const std::string& fault) {
    FrameFaults cable({parse_fault(fault)});
    for (std::uint16_t i = 0; i < 100; ++i) {
      const std::int64_t at_ns = i * 5 * kNsPerMs;
      std::vector<TimedByte> bytes;
      const auto send = [&](const auto& message) {
        for (const std::uint8_t byte : test::frame_of(message)) bytes.push_back({at_ns, byte});
      };
      wire::Hello hello{};
      hello.protocol = 1;
      hello.schema = 8;
      if (i == 0) send(hello);
      wire::Sample sample{};
      sample.sequence = static_cast<std::uint16_t>(1000 + i);
      sample.device_us = i * 5000U;
      send(sample);
      send(wire::SyncReply{i, i * 5000U, i * 5000U, 0, 0});
      for (const TimedByte& byte : cable.pass(bytes, at_ns + 5 * kNsPerMs - 1)) receive(byte.value);
      const int missing = i + 1 - static_cast<int>(sync_replies.size());
      longest_ns = std::max(longest_ns, missing * 5 * kNsPerMs);
    }
  }
  std::int64_t longest_ns = 0;  ///< that an answer was late
};

TEST(FrameFaults, HelloSaysAnotherVersionSchemaOrBoard) {
  EXPECT_EQ(Passed("version:2").hellos.at(0).protocol, 2);
  EXPECT_EQ(Passed("version:2").hellos.at(0).schema, 8u);
  EXPECT_NE(Passed("schema").hellos.at(0).schema, 8u);
  EXPECT_EQ(Passed("board:77").hellos.at(0).board, 77);
}

TEST(FrameFaults, TimesJumpInSamplesAndAnswersAlike) {
  const Passed all("clock-step:500@0.25");
  EXPECT_EQ(all.samples[49].device_us, 49 * 5000u);
  EXPECT_EQ(all.samples[50].device_us, 50 * 5000u + 500000u);
  EXPECT_EQ(all.sync_replies[50].received_us, all.samples[50].device_us);
  EXPECT_EQ(all.sync_replies[50].sent_us, all.samples[50].device_us);
}

TEST(FrameFaults, SamplesCountFromNothingAgain) {
  const Passed all("sequence@0.25");
  EXPECT_EQ(all.samples[49].sequence, 1049);
  EXPECT_EQ(all.samples[50].sequence, 0);
  EXPECT_EQ(all.samples[99].sequence, 49);
  EXPECT_EQ(all.samples[99].device_us, 99 * 5000u);
}

TEST(FrameFaults, OldFramesAndUnknownOnesComeBetween) {
  const Passed replayed("replay:10");
  EXPECT_EQ(replayed.hellos.size() + replayed.samples.size() + replayed.sync_replies.size(),
            201u + 191u);
  EXPECT_EQ(replayed.hellos.size(), 2u);
  EXPECT_EQ(replayed.bad_frames, 0);
  const Passed unknown("unknown-message:63");
  EXPECT_EQ(unknown.bad_frames, 201) << "one after each of the others";
  EXPECT_EQ(unknown.samples.size(), 100u);
}

TEST(FrameFaults, ClockAnswersWaitOrComeTwice) {
  EXPECT_EQ(Passed("sync-twice").sync_replies.size(), 200u);
  EXPECT_EQ(Passed("sync-twice").longest_ns, 0);
  const Passed late("sync-late:30");
  EXPECT_EQ(late.samples.size(), 100u);
  EXPECT_EQ(late.longest_ns, 30 * kNsPerMs);
}

TEST(FrameFaults, WhatIsNoFrameGoesOnAsItWas) {
  FrameFaults cable({parse_fault("board:7")});
  const std::vector<TimedByte> noise = {{1, 9}, {2, 8}, {3, 7}, {4, wire::kDelimiter}};
  const std::vector<TimedByte> out = cable.pass(noise, 5);
  ASSERT_EQ(out.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(out[i].value, noise[i].value);
}

}  // namespace
}  // namespace tp100::sim
