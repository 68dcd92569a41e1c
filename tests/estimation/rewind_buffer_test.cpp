#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "estimation/pose_filter.h"

namespace tp100::estimation {
namespace {

RewindEntry ends_at(HostNs end_ns) {
  RewindEntry entry;
  entry.motion.end_ns = end_ns;
  return entry;
}

std::vector<HostNs> ends_of(const RewindBuffer& buffer) {
  std::vector<HostNs> ends;
  for (std::size_t i = 0; i < buffer.size(); ++i) ends.push_back(buffer[i].motion.end_ns);
  return ends;
}

class RewindBufferTest : public testing::Test {
 protected:
  /// Ends at 10, 20, ...
  void push(int steps) {
    for (int i = 0; i < steps; ++i) buffer_->push(ends_at(10 * ++pushed_));
  }
  static constexpr int kFull = static_cast<int>(RewindBuffer::kCapacity);

  std::unique_ptr<RewindBuffer> buffer_ = std::make_unique<RewindBuffer>();
  int pushed_ = 0;
};

TEST_F(RewindBufferTest, HoldsWhatWasPushedLast) {
  EXPECT_TRUE(buffer_->empty());
  push(3);
  EXPECT_FALSE(buffer_->empty());
  EXPECT_EQ(ends_of(*buffer_), (std::vector<HostNs>{10, 20, 30}));
  push(kFull);
  const std::vector<HostNs> ends = ends_of(*buffer_);
  ASSERT_EQ(ends.size(), RewindBuffer::kCapacity);
  for (std::size_t i = 0; i < ends.size(); ++i)
    EXPECT_EQ(ends[i], 10 * (4 + static_cast<HostNs>(i)));
  EXPECT_EQ(buffer_->back().motion.end_ns, 10 * (kFull + 3));
  EXPECT_EQ(std::as_const(*buffer_).back().motion.end_ns, 10 * (kFull + 3));
}

TEST_F(RewindBufferTest, FindsTheFirstStepThatEndsNoSooner) {
  push(kFull + 5);
  EXPECT_EQ(buffer_->find(60), 0U);
  EXPECT_EQ(buffer_->find(61), 1U);
  EXPECT_EQ(buffer_->find(70), 1U);
  EXPECT_EQ(buffer_->find(10 * (kFull + 5)), RewindBuffer::kCapacity - 1);
  EXPECT_EQ(buffer_->find(10 * (kFull + 5) + 1), RewindBuffer::kCapacity);
}

TEST_F(RewindBufferTest, InsertsBeforeAStepAndDropsTheOldestOnlyIfFull) {
  push(4);
  EXPECT_EQ(buffer_->insert(2, ends_at(25)), 2U);
  EXPECT_EQ(ends_of(*buffer_), (std::vector<HostNs>{10, 20, 25, 30, 40}));
  push(kFull);
  EXPECT_EQ(buffer_->insert(2, ends_at(65)), 1U);
  const std::vector<HostNs> ends = ends_of(*buffer_);
  ASSERT_EQ(ends.size(), RewindBuffer::kCapacity);
  EXPECT_EQ(ends[0], 60);
  EXPECT_EQ(ends[1], 65);
  EXPECT_EQ(ends[2], 70);
  EXPECT_EQ(ends.back(), 10 * (kFull + 4));
  EXPECT_EQ(buffer_->insert(1, ends_at(62)), 0U);
  EXPECT_EQ(ends_of(*buffer_)[0], 62);
  EXPECT_EQ(ends_of(*buffer_)[1], 65);
}

TEST_F(RewindBufferTest, IsEmptyAfterAClear) {
  push(7);
  buffer_->clear();
  EXPECT_TRUE(buffer_->empty());
  EXPECT_EQ(buffer_->find(10), 0U);
  push(1);
  EXPECT_EQ(ends_of(*buffer_), (std::vector<HostNs>{80}));
}

}  // namespace
}  // namespace tp100::estimation
