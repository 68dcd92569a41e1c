#include "core/time.h"

#include <gtest/gtest.h>

namespace tp100 {
namespace {

TEST(Unwrapped, CountsOnAcrossTheWrap) {
  Unwrapped<std::uint32_t> clock;
  clock.reset(0xFFFFFF00u);
  EXPECT_EQ(clock.extend(0x00000100u), 0x100000100LL);
  EXPECT_EQ(clock.extend(0x00000200u), 0x100000200LL);
}

TEST(Unwrapped, AnOlderValueStaysOlderAndMovesNothing) {
  Unwrapped<std::uint16_t> sequence;
  sequence.reset(10);
  EXPECT_EQ(sequence.extend(20), 20);
  EXPECT_EQ(sequence.extend(15), 15);
  EXPECT_EQ(sequence.extend(21), 21);
}

}  // namespace
}  // namespace tp100
