#include "text/format.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

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

TEST(NearestName, FindsTypingErrorsUnitsLeftOutAndShortNamesInLongerOnes) {
  const std::vector<std::string_view> names = {"speed_mps", "length_m", "radius_m", "at_m"};
  for (const auto& [typed, meant] : {std::pair{"speeed_mps", "speed_mps"},
                                     {"sped_mps", "speed_mps"},
                                     {"speet_mps", "speed_mps"},
                                     {"lenght_m", "length_m"},
                                     {"at", "at_m"},
                                     {"colour", ""},
                                     {"", ""}})
    EXPECT_EQ(nearest_name(typed, names), meant) << typed;
  EXPECT_EQ(nearest_name(std::string(1000, 's'), names), "");
  EXPECT_EQ(nearest_name("speed_mps", {}), "");
  EXPECT_EQ(nearest_name("rate", {"date", "rate_hz"}), "date");
  EXPECT_EQ(nearest_name("rate", {"spin_us", "rate_hz"}), "rate_hz");
  EXPECT_EQ(nearest_name("33", {"1-curve", "2", "3"}), "3");
  EXPECT_EQ(nearest_name("4", {"2", "3"}), "");
  EXPECT_EQ(nearest_name("ab", {"2", "3"}), "");
}

}  // namespace
}  // namespace tp100::text
