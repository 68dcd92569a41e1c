#include "link/output_queue.h"

#include <gtest/gtest.h>

#include <vector>

#include "wire/messages.h"

namespace tp100::link {
namespace {

class OutputQueueTest : public testing::Test {
 protected:
  void write(std::size_t n) { queue.written(n); }
  LinkCounters counters{};
  OutputQueue<128> queue{counters};
};

TEST_F(OutputQueueTest, SpareDelimitersAreNoFrames) {
  // A delimiter precedes the first frame of a port.
  const std::size_t frame = queue.push(wire::SyncRequest{1});
  EXPECT_EQ(queue.pad(10), 10u);
  queue.push(wire::SyncRequest{2});
  EXPECT_EQ(queue.bytes().size(), 1 + frame + 10 + frame);
  write(queue.bytes().size());
  EXPECT_EQ(counters.frames_out, 2u);
  queue.pad(10);
  queue.push(wire::SyncRequest{3});
  write(5);
  EXPECT_EQ(counters.frames_out, 2u);
  write(queue.bytes().size());
  EXPECT_EQ(counters.frames_out, 3u);
}

TEST_F(OutputQueueTest, AFrameCutBeforeItsDelimiterCountsOnce) {
  const std::size_t frame = queue.push(wire::SyncRequest{1});
  write(frame);  // with the leading delimiter, this is all but the frame's last byte
  EXPECT_EQ(counters.frames_out, 0u);
  queue.pad(3);
  write(queue.bytes().size());
  EXPECT_EQ(counters.frames_out, 1u);
}

TEST_F(OutputQueueTest, EachPortBeginsWithADelimiter) {
  for (int port = 0; port < 2; ++port) {
    const std::size_t frame = queue.push(wire::SyncRequest{1});
    ASSERT_EQ(queue.bytes().size(), 1 + frame);
    EXPECT_EQ(queue.bytes()[0], wire::kDelimiter);
    write(queue.bytes().size());
    const std::size_t second = queue.push(wire::SyncRequest{2});
    EXPECT_EQ(queue.bytes().size(), second) << "the second frame has no leading delimiter";
    write(queue.bytes().size());
    queue.reset();
  }
}

TEST_F(OutputQueueTest, AFrameThatFillsTheQueueLeavesWhatIsBehindItAlone) {
  // Whatever was queued and written before, frames are decoded as they were queued.
  wire::FrameDecoder decoder;
  std::uint32_t expected = 0;
  for (std::uint32_t id = 0; id < 300; ++id) {
    queue.push(wire::SyncRequest{static_cast<std::uint16_t>(id)});
    queue.pad(id % 7);
    const std::size_t taken = queue.bytes().size() - id % 3;
    const std::vector<std::uint8_t> bytes(
        queue.bytes().begin(), queue.bytes().begin() + static_cast<std::ptrdiff_t>(taken));
    for (const std::uint8_t byte : bytes) {
      if (decoder.push(byte) != wire::DecodeResult::kFrame) continue;
      wire::SyncRequest request{};
      ASSERT_TRUE(wire::read_payload(decoder.payload(), decoder.size(), request));
      EXPECT_EQ(request.id, expected++);
    }
    write(taken);
  }
  EXPECT_GE(expected, 298u);
  EXPECT_EQ(counters.frames_out, expected);
  EXPECT_EQ(counters.unwritten, 0u);
}

TEST_F(OutputQueueTest, MakingRoomKeepsTheBytesThatWait) {
  for (std::uint16_t id = 1; id <= 4; ++id) queue.push(wire::SyncRequest{id});
  write(9);
  std::vector<std::uint8_t> expected(queue.bytes().begin(), queue.bytes().end());
  const std::size_t room = 128 - expected.size();
  EXPECT_EQ(queue.pad(room), room);
  expected.resize(128, wire::kDelimiter);
  EXPECT_EQ(std::vector<std::uint8_t>(queue.bytes().begin(), queue.bytes().end()), expected);
}

TEST_F(OutputQueueTest, PadsNoFurtherThanThereIsRoom) {
  EXPECT_EQ(queue.pad(1000), 128u);
  EXPECT_EQ(queue.push(wire::SyncRequest{1}), 0u);
  EXPECT_EQ(counters.unwritten, 1u);
  queue.drop();
  EXPECT_EQ(counters.unwritten, 1u);
}

}  // namespace
}  // namespace tp100::link
