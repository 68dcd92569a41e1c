#include <gtest/gtest.h>

#include <cstddef>
#include <deque>
#include <memory>
#include <utility>

#include "estimation/pose_filter.h"
#include "support/sequence.h"

namespace tp100::estimation {
namespace {

RewindEntry ends_at(HostNs end_ns) {
  RewindEntry entry;
  entry.motion.end_ns = end_ns;
  return entry;
}

void expect_same(const RewindBuffer& buffer, const std::deque<HostNs>& ends) {
  ASSERT_EQ(buffer.size(), ends.size());
  ASSERT_EQ(buffer.empty(), ends.empty());
  for (std::size_t i = 0; i < ends.size(); ++i) ASSERT_EQ(buffer[i].motion.end_ns, ends[i]) << i;
  if (!ends.empty()) {
    ASSERT_EQ(buffer.back().motion.end_ns, ends.back());
  }
}

// Whatever is pushed, inserted and cleared, it holds what a list would hold that drops its oldest
// entries, and finds the first that ends at or after a time.
TEST(RewindBuffer, IsTheEndOfAnOrderedList) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test::Sequence any(seed);
    const auto buffer = std::make_unique<RewindBuffer>();
    std::deque<HostNs> ends;
    for (int i = 1; i < 1000; ++i) {
      buffer->push(ends_at(10 * i));
      ends.push_back(10 * i);
      if (ends.size() > RewindBuffer::kCapacity) ends.pop_front();
      if (any.chance(0.002)) {
        buffer->clear();
        ends.clear();
      } else if (ends.size() > 1 && any.chance(0.2)) {
        const auto at = static_cast<std::size_t>(1 + any.below(static_cast<int>(ends.size()) - 1));
        const HostNs end = ends[at] - 1;
        const bool full = ends.size() == RewindBuffer::kCapacity;
        ASSERT_EQ(buffer->insert(at, ends_at(end)), full ? at - 1 : at);
        ends.insert(ends.begin() + static_cast<std::ptrdiff_t>(at), end);
        if (full) ends.pop_front();
      }
      expect_same(std::as_const(*buffer), ends);
      const HostNs time = any.below(10 * i + 20);
      std::size_t first = 0;
      while (first < ends.size() && ends[first] < time) ++first;
      ASSERT_EQ(buffer->find(time), first);
    }
  }
}

}  // namespace
}  // namespace tp100::estimation
