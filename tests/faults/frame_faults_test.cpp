#include "sim/faults/frame_faults.h"

#include <gtest/gtest.h>

#include <array>

#include "core/time.h"
#include "wire/messages.h"

namespace tp100::sim {
namespace {

template <class Message>
void append(std::vector<TimedByte>& bytes, std::int64_t at_ns, const Message& message) {
  std::array<std::uint8_t, Message::kSize> payload{};
  std::array<std::uint8_t, wire::kMaxFrame> frame{};
  wire::write_payload(message, payload.data());
  const std::size_t size = wire::encode_frame(static_cast<std::uint8_t>(Message::kType),
                                              payload.data(), payload.size(), frame.data());
  for (std::size_t i = 0; i < size; ++i) bytes.push_back({at_ns, frame[i]});
}

struct Received {
  std::vector<wire::Sample> samples;
  std::vector<wire::Hello> hellos;
  std::vector<wire::SyncReply> replies;
  std::vector<std::uint8_t> types;
  int corrupted = 0;
};

Received received(const std::vector<TimedByte>& bytes) {
  Received out;
  wire::FrameDecoder decoder;
  for (const TimedByte& byte : bytes) {
    const wire::DecodeResult received = decoder.push(byte.value);
    if (received == wire::DecodeResult::kNothing) continue;
    if (received != wire::DecodeResult::kFrame) {
      ++out.corrupted;
      continue;
    }
    out.types.push_back(decoder.type());
    wire::Sample sample{};
    wire::Hello hello{};
    wire::SyncReply reply{};
    if (decoder.type() == static_cast<std::uint8_t>(wire::Type::kSample) &&
        wire::read_payload(decoder.payload(), decoder.size(), sample))
      out.samples.push_back(sample);
    if (decoder.type() == static_cast<std::uint8_t>(wire::Type::kHello) &&
        wire::read_payload(decoder.payload(), decoder.size(), hello))
      out.hellos.push_back(hello);
    if (decoder.type() == static_cast<std::uint8_t>(wire::Type::kSyncReply) &&
        wire::read_payload(decoder.payload(), decoder.size(), reply))
      out.replies.push_back(reply);
  }
  return out;
}

// Passes a hello, then samples and answers to clock requests in turn, 5 ms apart.
Received passed(const std::string& fault, std::int64_t* longest_ns = nullptr) {
  FrameFaults cable({parse_fault(fault)});
  std::vector<TimedByte> out;
  for (std::uint16_t i = 0; i < 100; ++i) {
    const std::int64_t at_ns = i * 5 * kNsPerMs;
    std::vector<TimedByte> bytes;
    wire::Hello hello{};
    hello.protocol = 1;
    hello.schema = 8;
    if (i == 0) append(bytes, at_ns, hello);
    wire::Sample sample{};
    sample.sequence = static_cast<std::uint16_t>(1000 + i);
    sample.device_us = i * 5000U;
    append(bytes, at_ns, sample);
    wire::SyncReply reply{};
    reply.id = i;
    reply.received_us = reply.sent_us = i * 5000U;
    append(bytes, at_ns, reply);
    for (const TimedByte& byte : cable.pass(bytes, at_ns + 5 * kNsPerMs - 1)) out.push_back(byte);
    if (longest_ns != nullptr)
      *longest_ns = std::max<std::int64_t>(
          *longest_ns, (i - static_cast<int>(received(out).replies.size()) + 1) * 5 * kNsPerMs);
  }
  const Received all = received(out);
  EXPECT_EQ(all.corrupted, 0) << fault;
  return all;
}

TEST(FrameFaults, HelloSaysAnotherVersionSchemaOrBoard) {
  EXPECT_EQ(passed("version:2").hellos.at(0).protocol, 2);
  EXPECT_EQ(passed("version:2").hellos.at(0).schema, 8u);
  EXPECT_NE(passed("schema").hellos.at(0).schema, 8u);
  EXPECT_EQ(passed("board:77").hellos.at(0).board, 77);
}

TEST(FrameFaults, TimesJumpInSamplesAndAnswersAlike) {
  const Received all = passed("clock-step:500@0.25");
  EXPECT_EQ(all.samples[49].device_us, 49 * 5000u);
  EXPECT_EQ(all.samples[50].device_us, 50 * 5000u + 500000u);
  EXPECT_EQ(all.replies[50].received_us, all.samples[50].device_us);
  EXPECT_EQ(all.replies[50].sent_us, all.samples[50].device_us);
}

TEST(FrameFaults, SamplesCountFromNothingAgain) {
  const Received all = passed("sequence@0.25");
  EXPECT_EQ(all.samples[49].sequence, 1049);
  EXPECT_EQ(all.samples[50].sequence, 0);
  EXPECT_EQ(all.samples[99].sequence, 49);
  EXPECT_EQ(all.samples[99].device_us, 99 * 5000u);
}

TEST(FrameFaults, OldFramesAndUnknownOnesComeBetween) {
  const Received replayed = passed("replay:10");
  EXPECT_EQ(replayed.types.size(), 201u + 191u);
  const Received unknown = passed("unknown-message:63");
  EXPECT_EQ(unknown.types.size(), 402u);
  EXPECT_EQ(std::count(unknown.types.begin(), unknown.types.end(), 63), 201);
  EXPECT_EQ(unknown.samples.size(), 100u);
}

TEST(FrameFaults, ClockAnswersWaitOrComeTwice) {
  EXPECT_EQ(passed("sync-twice").replies.size(), 200u);
  std::int64_t longest_ns = 0;
  const Received late = passed("sync-late:30", &longest_ns);
  EXPECT_EQ(late.samples.size(), 100u);
  EXPECT_EQ(longest_ns, 30 * kNsPerMs);
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
