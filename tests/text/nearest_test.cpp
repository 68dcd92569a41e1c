#include <gtest/gtest.h>

#include <string>

#include "text/format.h"

namespace tp100::text {
namespace {

const std::vector<std::string_view> kNames = {"speed_mps", "length_m", "radius_m", "at_m"};

TEST(NearestName, FindsInsertedDeletedReplacedAndSwappedLetters) {
  EXPECT_EQ(nearest_name("speeed_mps", kNames), "speed_mps");
  EXPECT_EQ(nearest_name("sped_mps", kNames), "speed_mps");
  EXPECT_EQ(nearest_name("speet_mps", kNames), "speed_mps");
  EXPECT_EQ(nearest_name("lenght_m", kNames), "length_m");
}

TEST(NearestName, FindsAUnitThatWasLeftOut) {
  EXPECT_EQ(nearest_name("at", kNames), "at_m");
  EXPECT_EQ(nearest_name("rate", {"date", "rate_hz"}), "date");
  EXPECT_EQ(nearest_name("rate", {"spin_us", "rate_hz"}), "rate_hz");
}

TEST(NearestName, FindsAShortNameInALongerOne) {
  EXPECT_EQ(nearest_name("33", {"1-curve", "2", "3"}), "3");
  EXPECT_EQ(nearest_name("4", {"2", "3"}), "");
  EXPECT_EQ(nearest_name("ab", {"2", "3"}), "");
}

TEST(NearestName, IsEmptyForNamesThatAreNoTypingError) {
  EXPECT_EQ(nearest_name("colour", kNames), "");
  EXPECT_EQ(nearest_name("", kNames), "");
  EXPECT_EQ(nearest_name(std::string(1000, 's'), kNames), "");
  EXPECT_EQ(nearest_name("speed_mps", {}), "");
}

}  // namespace
}  // namespace tp100::text
