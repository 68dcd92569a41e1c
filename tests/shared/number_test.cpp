#include "shared/number.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace tp100::shared {
namespace {

// Sequences and times of both sides wrap; a wrong difference takes a new command for an old one.
TEST(WrappedDifference, IsTheShorterWayAroundTheWrap) {
  EXPECT_EQ(wrapped_difference(std::uint32_t{0x100}, std::uint32_t{0xFFFFFF00}), 0x200);
  EXPECT_EQ(wrapped_difference(std::uint32_t{0xFFFFFF00}, std::uint32_t{0x100}), -0x200);
  EXPECT_EQ(wrapped_difference(INT32_MIN, INT32_MAX), 1);
  EXPECT_EQ(wrapped_difference(std::uint16_t{15}, std::uint16_t{20}), -5);
  EXPECT_EQ(wrapped_difference(std::uint16_t{3}, std::uint16_t{0xFFFE}), 5);
}

}  // namespace
}  // namespace tp100::shared
