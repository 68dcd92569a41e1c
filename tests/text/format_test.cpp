// Texts for people: formatted values, and the name that was meant by a mistyped one. Bytes as text.

#include "text/format.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "text/base64.h"
#include "text/progress.h"

namespace tp100::text {
namespace {

TEST(Format, PrintsAsPrintfDoesHoweverLongItIs) {
  EXPECT_EQ(format("%s %5.2f|%-4d|", "a", 1.005, 7), "a  1.00|7   |");
  const std::string is_long(10'000, 'x');
  EXPECT_EQ(format("%s.", is_long.c_str()), is_long + ".");
}

// Whoever waits wants to know whether to go for lunch.
TEST(Progress, TellsHowMuchIsDoneAndHowLongTheRestTakes) {
  EXPECT_EQ(progress_text("run", 0, 40, 3.0), "0 of 40 runs");
  EXPECT_EQ(progress_text("run", 10, 40, 20.0), "10 of 40 runs, 1 min 00 s left");
  EXPECT_EQ(progress_text("run", 1, 1, 5.0), "1 of 1 run, 0 s left");
  EXPECT_EQ(progress_text("part", 1, 100, 100.0), "1 of 100 parts, 2 h 45 min left");
}

TEST(UtcMinute, IsTheDateOfTheCalendar) {
  EXPECT_EQ(utc_minute(1780236359), "2026-05-31 14:05 UTC");
}

TEST(NearestName, FindsTypingErrorsUnitsLeftOutAndShortNamesInLongerOnes) {
  const std::vector<std::string_view> names = {"speed_mps", "length_m", "radius_m", "at_m"};
  for (const auto& [typed, meant] : {std::pair{"speeed_mps", "speed_mps"},
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

TEST(Base64, IsThatOfRfc4648AndIsReadBack) {
  for (const auto& [bytes, text] : {std::pair{"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}})
    EXPECT_EQ(base64(bytes), text);
  EXPECT_EQ(base64(std::string("\0\xff\xfe\x80\xfb\xef", 6)), "AP/+gPvv");
  std::string bytes;
  for (int i = 0; i < 600; ++i) {
    EXPECT_EQ(from_base64(base64(bytes)), bytes);
    bytes += static_cast<char>(i * 7);
  }
}

TEST(Base64, WhatIsNoneIsRefused) {
  for (const char* text :
       {"Z", "Zg", "Zg=", "=", "====", "Zg==Zg==", "Z===", "Zm9v!!!!", "Zm 9", "Zm9v\n"})
    EXPECT_FALSE(from_base64(text)) << text;
}

}  // namespace
}  // namespace tp100::text
