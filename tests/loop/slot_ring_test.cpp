#include <gtest/gtest.h>

#include <array>
#include <thread>

#include "loop/rings.h"

namespace tp100::loop {
namespace {

TEST(SlotRing, AFullRingTakesNothingMoreUntilASlotIsReleased) {
  SlotRing<int> ring(3);
  EXPECT_EQ(ring.front(), nullptr);
  for (int i = 0; i < 3; ++i) {
    int* slot = ring.free_slot();
    ASSERT_NE(slot, nullptr);
    *slot = i;
    ring.publish();
  }
  EXPECT_EQ(ring.free_slot(), nullptr);
  ASSERT_NE(ring.front(), nullptr);
  EXPECT_EQ(*ring.front(), 0);
  ring.release();
  ASSERT_NE(ring.free_slot(), nullptr);
  ASSERT_NE(ring.front(), nullptr);
  EXPECT_EQ(*ring.front(), 1);
}

TEST(SlotRing, AReaderNeverSeesAHalfWrittenRecord) {
  struct Record {
    std::array<int, 64> values{};
  };
  constexpr int kRecords = 20000;
  SlotRing<Record> ring(4);
  std::thread writer([&ring] {
    for (int i = 0; i < kRecords;) {
      if (Record* slot = ring.free_slot()) {
        slot->values.fill(i++);
        ring.publish();
      } else {
        std::this_thread::yield();
      }
    }
  });
  int wrong = 0;
  for (int i = 0; i < kRecords;) {
    if (const Record* record = ring.front()) {
      for (const int value : record->values) wrong += value != i ? 1 : 0;
      ring.release();
      ++i;
    } else {
      std::this_thread::yield();
    }
  }
  writer.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(ring.front(), nullptr);
}

}  // namespace
}  // namespace tp100::loop
