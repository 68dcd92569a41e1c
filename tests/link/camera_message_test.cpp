// The datagrams of a camera: where it saw the robot, and images for viewers.
#include "link/camera_message.h"

#include <gtest/gtest.h>

#include <vector>

#include "jpeg.h"

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

ImageMessage example(std::string_view jpeg) {
  const CameraMessage head = example();
  return {head.stream, head.clock, head.sequence, head.stamp_us, head.age_us, jpeg};
}

/// The datagram of an image of this size.
std::string datagram(unsigned width_px = 64, unsigned height_px = 48) {
  return encode(example(test::jpeg(width_px, height_px)));
}

std::string image_with(const std::string& from, const std::string& to) {
  std::string text = datagram();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// Other programs rely on this format: a change here breaks them.
TEST(CameraImage, IsWrittenAsDocumented) {
  EXPECT_EQ(encode(example("\xff\xd8")),
            R"({"format":"tp100-image/1","stream":4294967295,)"
            R"("clock":"6b0c5b2e-0d6f-4a8e-9a5e-4cf2b0c9a111","sequence":412,)"
            R"("stamp_us":9007199254740992,"age_us":41250})"
            "\n\xff\xd8");
}

// Its keys are those of a detection, which are tried one by one above.
TEST(CameraImage, WhatIsNotOfTheFormatIsRefused) {
  for (const char* line : {"", "{}", "[]", "null"})
    EXPECT_FALSE(decode_image(std::string(line) + "\n" + test::jpeg(64, 48))) << line;
  EXPECT_FALSE(decode_image(""));
  EXPECT_FALSE(decode_image("\n"));
  EXPECT_FALSE(decode_image(test::jpeg(64, 48)));
  EXPECT_FALSE(decode_image(image_with("image/1", "camera/1")));
  EXPECT_FALSE(decode_image(image_with("\"stream\"", "\"s\"")));
  EXPECT_FALSE(decode_image(image_with("41250", "10000001")));
  EXPECT_FALSE(decode_image(std::string(900, '[') + "\n" + test::jpeg(64, 48)));
}

/// A baseline frame header of 64 x 48 pixels with these values.
std::string frame(unsigned kind, unsigned precision, unsigned components, unsigned length = 17) {
  return "\xff" + std::string(1, static_cast<char>(kind)) + test::word(length) +
         std::string(1, static_cast<char>(precision)) + test::word(48) + test::word(64) +
         std::string(1, static_cast<char>(components)) + std::string(9, '\x11');
}
const std::string kScan = "\xff\xda" + test::word(8) + std::string("\1\1\0\0\x3f\0", 6);
bool shows(const std::string& segments) {
  return decode_image(encode(example("\xff\xd8" + segments + "content\xff\xd9"))).has_value();
}

// A viewer must neither be asked to decode a huge image nor be given what it cannot show.
TEST(CameraImage, OnlyAJpegThatEveryBrowserShowsIsTaken) {
  const std::string good = frame(0xc0, 8, 3);
  const auto segment = [](unsigned kind, unsigned length) {
    return "\xff" + std::string(1, static_cast<char>(kind)) + test::word(length);
  };
  struct Case {
    const char* what;
    bool shown;
    std::string segments;
  };
  std::vector<Case> cases = {
      {"one component", true, frame(0xc0, 8, 1) + kScan},
      {"an empty comment", true, segment(0xfe, 2) + good + kScan},
      {"a segment shorter than its length", false, segment(0xfe, 1) + good + kScan},
      {"a segment beyond the end", false, good + segment(0xfe, 60'000) + kScan},
      {"a segment without a marker", false, "\xfe\xc4" + test::word(2) + good + kScan},
      {"a frame behind the scan", false, kScan + good},
      {"no scan", false, good},
      {"nothing", false, ""},
      {"two frames", false, good + good + kScan},
      {"a huge frame first", false, test::frame_header(65535, 65535) + good + kScan},
      {"a huge frame behind", false, good + test::frame_header(65535, 65535) + kScan},
      {"a scan of any length, which is not read", true, good + segment(0xda, 60'000)},
      {"a scan shorter than its length", false, good + segment(0xda, 1)},
      {"a frame up to its components", true, frame(0xc0, 8, 3, 8).substr(0, 10) + kScan},
      {"a frame without them", false, frame(0xc0, 8, 3, 7).substr(0, 9) + kScan},
  };
  for (const unsigned kind : {0xc0U, 0xc1U, 0xc2U})
    cases.push_back({"baseline, extended, progressive", true, frame(kind, 8, 3) + kScan});
  for (const unsigned kind : {0xbfU, 0xc3U, 0xc5U, 0x01U})
    cases.push_back({"another kind of frame", false, frame(kind, 8, 3) + kScan});
  for (const unsigned precision : {0U, 7U, 9U, 12U, 16U})
    cases.push_back({"another precision", false, frame(0xc0, precision, 3) + kScan});
  for (const unsigned components : {0U, 2U, 4U, 255U})
    cases.push_back({"another number of components", false, frame(0xc0, 8, components) + kScan});
  for (const unsigned kind : {0xc3U, 0xc4U, 0xd8U, 0xdbU, 0xe1U, 0xfeU}) {
    const std::string other = frame(kind, 0, 0);
    cases.push_back({"other segments around it", true, other + good + other + kScan});
  }
  cases.push_back({"a segment below the first frame", false, frame(0xbf, 0, 0) + good + kScan});
  for (const Case& each : cases) EXPECT_EQ(shows(each.segments), each.shown) << each.what;
}

TEST(CameraImage, BothSidesArePixelsOfOneToTheMost) {
  for (const unsigned side : {1U, 255U, 256U, 4096U}) {
    EXPECT_TRUE(decode_image(datagram(side, 48))) << side;
    EXPECT_TRUE(decode_image(datagram(64, side))) << side;
  }
  for (const unsigned side : {0U, 4097U, 4352U}) {
    EXPECT_FALSE(decode_image(datagram(side, 48))) << side;
    EXPECT_FALSE(decode_image(datagram(64, side))) << side;
  }
}

TEST(CameraImage, ItsBeginningAndItsEndAreThoseOfAJpeg) {
  const std::string good = test::jpeg(64, 48);
  for (const std::size_t at : {std::size_t{0}, std::size_t{1}, good.size() - 2, good.size() - 1}) {
    std::string bad = good;
    bad[at] = '\x7e';
    EXPECT_FALSE(decode_image(encode(example(bad)))) << at;
  }
  const std::string whole = datagram();
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(decode_image(whole.substr(0, size))) << size;
}

TEST(CameraImage, ADatagramAndItsLineHaveAGreatestSize) {
  const auto sized = [](std::size_t size) {
    std::string jpeg = test::jpeg(64, 48);
    const std::size_t now = encode(example(jpeg)).size();
    return encode(example(jpeg.insert(jpeg.size() - 2, size - now, 'x')));
  };
  EXPECT_EQ(sized(kMaxImageDatagram).size(), kMaxImageDatagram);
  EXPECT_TRUE(decode_image(sized(kMaxImageDatagram)));
  EXPECT_FALSE(decode_image(sized(kMaxImageDatagram + 1)));
  const auto with_line = [](std::size_t size) {
    const std::string good = datagram();
    return good.substr(0, 1) + std::string(size - good.find('\n'), ' ') + good.substr(1);
  };
  EXPECT_TRUE(decode_image(with_line(kMaxCameraDatagram)));
  EXPECT_FALSE(decode_image(with_line(kMaxCameraDatagram + 1)));
}

TEST(CameraImage, ADetectionThatEndsItsLineIsNone) {
  const std::string detection = encode(CameraMessage{.clock = "c"}) + "\n";
  // A receiver's buffer may still hold an image behind it.
  const std::string buffer = detection + "\xff\xd8";
  EXPECT_FALSE(is_image(std::string_view(buffer).substr(0, detection.size())));
  EXPECT_FALSE(is_image(std::string_view(buffer).substr(0, detection.size() + 1)));
  EXPECT_TRUE(is_image(buffer));
  EXPECT_TRUE(is_image("\n\xff\xd8")) << "its line may be empty";
  EXPECT_FALSE(is_image("\xff\xd8\xff\xd9")) << "it has no line";
}

}  // namespace
}  // namespace tp100::link
