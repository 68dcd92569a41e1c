// JSON of any numbers and bytes is valid, and read back as it was.

#include "text/json_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

namespace tp100::text {
namespace {

using Json = nlohmann::json;

std::string json_text(std::string_view text) {
  std::string out;
  JsonWriter(out).value(text);
  return out;
}

TEST(JsonWriter, WritesNestedObjectsAndArrays) {
  std::string text;
  JsonWriter(text)
      .begin_object()
      .field("a", 1)
      .key("b")
      .begin_array()
      .value(true)
      .begin_object()
      .end_object()
      .null()
      .end_array()
      .field("c", "d")
      .field("e", std::optional<int>())
      .field("f", std::nan(""))
      .end_object();
  EXPECT_EQ(text, R"({"a":1,"b":[true,{},null],"c":"d"})");
}

TEST(JsonWriter, EveryFiniteDoubleComesBackExactly) {
  std::mt19937_64 random(1);
  // One in 2000 of these is no finite number.
  for (int i = 0; i < 20'000; ++i) {
    const auto value = std::bit_cast<double>(random());
    std::string text;
    JsonWriter(text).value(value);
    EXPECT_EQ(Json::parse(text), std::isfinite(value) ? Json(value) : Json()) << text;
  }
}

TEST(JsonWriter, TextComesBackAsItWas) {
  for (const std::string text : {"", "plain", "quote \" and \\", "line\nand\ttab", "\x01\x1f",
                                 "grün ≈ 3 🤖", "</script>"}) {
    EXPECT_EQ(Json::parse(json_text(text)).get<std::string>(), text);
  }
}

TEST(JsonWriter, AnyBytesBecomeValidJsonWithBrokenCharactersReplaced) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes(random() % 12, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    EXPECT_TRUE(Json::accept(json_text(bytes))) << i;
  }

  // A surrogate, what is longer than necessary or beyond Unicode, a lone continuation byte, and a
  // character that is cut off.
  for (const std::string bytes : {"\xED\xA0\x80", "\xC0\xAF", "\xE0\x9F\xBF", "\xF0\x8F\xBF\xBF",
                                  "\xF4\x90\x80\x80", "\x80", "\xE2\x82"}) {
    const std::string out = json_text(bytes);
    EXPECT_TRUE(Json::accept(out));
    EXPECT_NE(out.find("\xEF\xBF\xBD"), std::string::npos);
  }
}

}  // namespace
}  // namespace tp100::text
