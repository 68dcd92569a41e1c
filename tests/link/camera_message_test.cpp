// The datagram of a camera about where it saw the robot.
#include "link/camera_message.h"

#include <gtest/gtest.h>

#include <vector>

namespace tp100::link {
namespace {

CameraMessage example() {
  return {.stream = 4'294'967'295U,
          .clock = "6b0c5b2e-0d6f-4a8e-9a5e-4cf2b0c9a111",
          .sequence = 412,
          .stamp_us = 9'007'199'254'740'992,
          .age_us = 41'250,
          .marker = 7,
          .x_m = 1.20341149,
          .y_m = -0.41821951,
          .yaw_rad = 3.14159251};
}

// Other programs rely on this format: a change here breaks them.
TEST(CameraMessage, IsWrittenAsDocumented) {
  EXPECT_EQ(encode(example()), R"({"format":"tp100-camera/1","stream":4294967295,)"
                               R"("clock":"6b0c5b2e-0d6f-4a8e-9a5e-4cf2b0c9a111","sequence":412,)"
                               R"("stamp_us":9007199254740992,"age_us":41250,"marker":7,)"
                               R"("x_m":1.203411,"y_m":-0.41822,"yaw_rad":3.141593})");
}

TEST(CameraMessage, ComesBackAsItWent) {
  const auto back = decode_camera(encode(example()));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(encode(*back), encode(example()));
}

std::string changed(const std::string& from, const std::string& to) {
  std::string text = encode(example());
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(CameraMessage, OtherOrderSpacesAndUnknownKeysAreTaken) {
  EXPECT_TRUE(decode_camera(changed("{", "{ \"more\" : [1, {}], ")).has_value());
  EXPECT_TRUE(decode_camera(encode(example()) + "\n").has_value());
  EXPECT_EQ(decode_camera(changed("1.203411", "1"))->x_m, 1.0);
}

TEST(CameraMessage, WhatIsNotOfTheFormatIsRefused) {
  for (const std::string& text :
       {std::string(), std::string("[]"), std::string("null"), std::string("{}"),
        encode(example()) + "}", changed("camera/1", "camera/2"), changed("1.203411", "\"1\""),
        changed("412", "412.5"), changed("412", "true"), changed("6b0c", "\xff\xfe"),
        std::string(600, '[') + std::string(400, ']')})
    EXPECT_FALSE(decode_camera(text)) << text;
}

TEST(CameraMessage, EachOfItsKeysIsRequired) {
  for (const char* key : {"format", "stream", "clock", "sequence", "stamp_us", "age_us", "marker",
                          "x_m", "y_m", "yaw_rad"}) {
    const std::string quoted = "\"" + std::string(key) + "\"";
    EXPECT_FALSE(decode_camera(changed(quoted, "\"other\""))) << key;
    EXPECT_FALSE(decode_camera(changed(quoted + ":", quoted + ":null,\"more\":"))) << key;
  }
}

TEST(CameraMessage, TheBoundsOfEachKeyBelongToItsRange) {
  struct Range {
    const char* value;
    std::vector<const char*> good, bad;
  };
  const std::vector<Range> ranges = {
      {"\"stream\":4294967295", {"0", "1", "4294967295"}, {"-1", "4294967296", "8589934591"}},
      {"\"sequence\":412", {"0", "4294967295"}, {"-1", "4294967296", "9223372036854775808"}},
      {"\"stamp_us\":9007199254740992",
       {"0", "9007199254740992"},
       {"-1", "9007199254740993", "9223372036854775808", "18446744073709551615"}},
      {"\"age_us\":41250", {"0", "10000000"}, {"-1", "10000001", "20000000"}},
      {"\"marker\":7", {"0", "1000000"}, {"-1", "1000001", "2000000"}},
      {"\"x_m\":1.203411",
       {"1000", "-1000.0", "0"},
       {"1000.001", "-1000.001", "2000", "1e999", "-1e999", "NaN", "Infinity", "-1e300"}},
      {"\"y_m\":-0.41822", {"1000", "-1000.0", "0"}, {"1000.001", "-1000.001", "2000"}},
      {"\"yaw_rad\":3.141593", {"100", "-100.0", "0"}, {"100.001", "-100.001", "200"}},
  };
  for (const Range& range : ranges) {
    const std::string from = range.value;
    const std::string key = from.substr(0, from.find(':') + 1);
    for (const char* value : range.good)
      EXPECT_TRUE(decode_camera(changed(from, key + value))) << key << value;
    for (const char* value : range.bad)
      EXPECT_FALSE(decode_camera(changed(from, key + value))) << key << value;
  }
}

TEST(CameraMessage, AClockHasANameOfOneTo64Characters) {
  const std::string& clock = example().clock;
  for (const std::size_t size : {1U, 2U, 64U})
    EXPECT_EQ(decode_camera(changed(clock, std::string(size, 'a')))->clock.size(), size);
  EXPECT_FALSE(decode_camera(changed(clock, std::string(65, 'a'))));
  EXPECT_FALSE(decode_camera(changed(clock, "")));
  EXPECT_FALSE(decode_camera(changed("\"" + clock + "\"", "5")));
}

TEST(CameraMessage, ADatagramHasAGreatestSize) {
  const std::string good = encode(example());
  EXPECT_TRUE(decode_camera(good + std::string(kMaxCameraDatagram - good.size(), ' ')));
  EXPECT_FALSE(decode_camera(good + std::string(kMaxCameraDatagram - good.size() + 1, ' ')));
}

}  // namespace
}  // namespace tp100::link
