#include "text/format.h"

#include <gtest/gtest.h>

namespace tp100::text {
namespace {

TEST(Format, PrintsAsPrintfDoesHoweverLongItIs) {
  EXPECT_EQ(format("%s %5.2f|%-4d|", "a", 1.005, 7), "a  1.00|7   |");
  EXPECT_EQ(format("%s", ""), "");
  const std::string is_long(10'000, 'x');
  EXPECT_EQ(format("%s.", is_long.c_str()), is_long + ".");
}

TEST(Format, CountsOneInTheSingular) {
  EXPECT_EQ(counted(0, "run"), "0 runs");
  EXPECT_EQ(counted(1, "run"), "1 run");
  EXPECT_EQ(counted(2, "run"), "2 runs");
}

TEST(Format, TellsSecondsSince1970AsADate) {
  EXPECT_EQ(utc_minute(0), "1970-01-01 00:00 UTC");
  EXPECT_EQ(utc_minute(1780236300), "2026-05-31 14:05 UTC");
}

}  // namespace
}  // namespace tp100::text
