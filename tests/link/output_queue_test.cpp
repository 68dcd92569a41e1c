#include "link/output_queue.h"

#include <gtest/gtest.h>

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
  // The first frame of a port is led by a delimiter.
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
  write(frame);  // with the leading delimiter: all but its last byte
  EXPECT_EQ(counters.frames_out, 0u);
  queue.pad(3);
  write(queue.bytes().size());
  EXPECT_EQ(counters.frames_out, 1u);
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
