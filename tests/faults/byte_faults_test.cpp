#include "sim/faults/byte_faults.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/time.h"
#include "wire/frame.h"

namespace tp100::sim {
namespace {

constexpr std::int64_t kByteNs = 20'000;
constexpr std::size_t kFrame = 46;

// A second of frames, one after the other.
std::vector<TimedByte> stream(std::size_t frames = 1000) {
  std::vector<TimedByte> bytes;
  for (std::size_t i = 0; i < frames * kFrame; ++i) {
    const bool end = i % kFrame == kFrame - 1;
    bytes.push_back({static_cast<std::int64_t>(i + 1) * kByteNs,
                     end ? wire::kDelimiter : static_cast<std::uint8_t>(1 + i % 250)});
  }
  return bytes;
}

// Passes the bytes through the cable millisecond by millisecond, until all have arrived.
std::vector<TimedByte> carried(const std::string& fault, const std::vector<TimedByte>& bytes,
                               std::int64_t spacing_ns = 0, std::uint64_t seed = 1) {
  ByteFaults cable({parse_fault(fault)}, spacing_ns, seed);
  std::vector<TimedByte> out;
  std::size_t next = 0;
  for (std::int64_t until = kNsPerMs; until < 4 * kNsPerS; until += kNsPerMs) {
    std::size_t end = next;
    while (end < bytes.size() && bytes[end].at_ns <= until) ++end;
    for (const TimedByte& byte : cable.pass(std::span(bytes).subspan(next, end - next), until)) {
      EXPECT_LE(byte.at_ns, until);
      EXPECT_GE(byte.at_ns, out.empty() ? 0 : out.back().at_ns + spacing_ns);
      out.push_back(byte);
    }
    next = end;
  }
  return out;
}

std::vector<std::uint8_t> values(const std::vector<TimedByte>& bytes) {
  std::vector<std::uint8_t> out;
  for (const TimedByte& byte : bytes) out.push_back(byte.value);
  return out;
}

TEST(ByteFaults, TheSameSeedDoesTheSameCorruption) {
  const std::vector<TimedByte> bytes = stream();
  EXPECT_EQ(values(carried("flip:0.1", bytes)), values(carried("flip:0.1", bytes)));
  EXPECT_NE(values(carried("flip:0.1", bytes)), values(carried("flip:0.1", bytes, 0, 2)));
}

TEST(ByteFaults, SharesAreOfTheBytes) {
  const std::vector<TimedByte> bytes = stream();
  const double count = static_cast<double>(bytes.size());
  for (const auto& [fault, share] :
       {std::pair{"drop:0.1", 0.9}, {"duplicate:0.1", 1.1}, {"insert:0.1", 1.1}})
    EXPECT_NEAR(static_cast<double>(carried(fault, bytes).size()), share * count, 0.01 * count);
  const std::vector<std::uint8_t> before = values(bytes),
                                  after = values(carried("flip:0.1", bytes));
  ASSERT_EQ(before.size(), after.size());
  std::size_t differ = 0;
  for (std::size_t i = 0; i < before.size(); ++i) differ += before[i] != after[i] ? 1U : 0U;
  EXPECT_NEAR(static_cast<double>(differ), 0.1 * count, 0.01 * count);
}

TEST(ByteFaults, FramesLoseTheirEndsOrTheirTailsOrEndTooEarly) {
  const std::vector<TimedByte> bytes = stream();
  const auto ends = [](const std::vector<TimedByte>& stream) {
    return static_cast<double>(
        std::count_if(stream.begin(), stream.end(),
                      [](const TimedByte& byte) { return byte.value == wire::kDelimiter; }));
  };
  EXPECT_EQ(ends(carried("truncate:0.2", bytes)), 1000.0);
  EXPECT_NEAR(static_cast<double>(bytes.size() - carried("truncate:0.2", bytes).size()),
              200.0 * (kFrame - 9), 60.0 * kFrame);
  EXPECT_NEAR(ends(carried("fuse:0.2", bytes)), 800.0, 60.0);
  EXPECT_NEAR(ends(carried("delimiter:0.1", bytes)), 1000.0 + 4500.0, 200.0);
}

TEST(ByteFaults, LateBytesKeepTheirOrderAndTheirNumberAndNothingComesDuringAPause) {
  const std::vector<TimedByte> bytes = stream();
  for (const char* fault : {"delay:20", "jitter:5", "batch:16", "stall:300@0.2"}) {
    const std::vector<TimedByte> out = carried(fault, bytes);
    EXPECT_EQ(values(out), values(bytes)) << fault;
    for (std::size_t i = 0; i < std::min(out.size(), bytes.size()); ++i)
      ASSERT_GE(out[i].at_ns, bytes[i].at_ns) << fault;
  }
  EXPECT_EQ(carried("delay:20", bytes)[7].at_ns, bytes[7].at_ns + 20 * kNsPerMs);
  EXPECT_EQ(carried("batch:16", bytes)[7].at_ns, 16 * kNsPerMs);
  for (const char* fault : {"stall:300@0.2", "cut@0.2+0.3"})
    for (const TimedByte& byte : carried(fault, bytes))
      EXPECT_TRUE(byte.at_ns < from_s(0.2) || byte.at_ns >= from_s(0.5)) << fault << byte.at_ns;
  EXPECT_EQ(bytes.size() - carried("cut@0.2+0.3", bytes).size(),
            static_cast<std::size_t>(from_s(0.3) / kByteNs));
}

TEST(ByteFaults, AFarEndWithAUartGetsNoTwoBytesAtOnce) {
  const std::vector<TimedByte> bytes = stream(100);
  for (const char* fault : {"batch:16", "insert:0.2", "noise:200@0.01", "chatter:20"})
    EXPECT_GE(carried(fault, bytes, kByteNs).size(), bytes.size()) << fault;
}

TEST(ByteFaults, NoiseAndChatterComeThoughNobodySends) {
  EXPECT_EQ(carried("noise:200@0.01", {}).size(), 200u);
  const std::vector<std::uint8_t> sent = values(carried("chatter:1000@1", {}));
  const std::string text(sent.begin(), sent.end());
  EXPECT_EQ(text.substr(0, 4), "AT\r\n");
  EXPECT_EQ(text.substr(text.size() / 3, 4), "AT\r\n") << "three times, once a second";
}

}  // namespace
}  // namespace tp100::sim
