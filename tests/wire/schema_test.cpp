#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "all_messages.h"
#include "wire/frame.h"

namespace tp100::wire {
namespace {

// Writes a line `0x43 boot_nonce:u32 sequence:u16 ... gyro:i16[3]\n` per message.
class SchemaText {
 public:
  void field(const char* name, const std::uint8_t&) { add(name, "u8"); }
  void field(const char* name, const std::uint16_t&) { add(name, "u16"); }
  void field(const char* name, const std::uint32_t&) { add(name, "u32"); }
  void field(const char* name, const std::int16_t&) { add(name, "i16"); }
  void field(const char* name, const std::int32_t&) { add(name, "i32"); }
  void field(const char* name, const float&) { add(name, "f32"); }
  template <class T, std::size_t N>
  void field(const char* name, const T (&values)[N]) {
    field(name, values[0]);
    text_ += "[" + std::to_string(N) + "]";
  }
  const std::string& text() const { return text_; }

 private:
  void add(const char* name, const char* type) { text_ += std::string(" ") + name + ":" + type; }
  std::string text_;
};

std::string schema_text() {
  std::string text;
  for_each_message([&](const char*, auto message) {
    char type[8];
    std::snprintf(type, sizeof type, "0x%02X", static_cast<unsigned>(message.kType));
    SchemaText fields;
    message.visit(fields);
    text += type + fields.text() + "\n";
  });
  return text;
}

std::uint32_t fnv1a(const std::string& text) {
  std::uint32_t hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 16777619U;
  return hash;
}

TEST(Schema, HashIsThatOfTheMessagesAsTheyAre) {
  char right[64];
  std::snprintf(right, sizeof right, "kSchemaHash must be 0x%08X", fnv1a(schema_text()));
  EXPECT_EQ(kSchemaHash, fnv1a(schema_text())) << right << " for\n" << schema_text();
}

TEST(Schema, HashMatchesThePublishedTestVector) { EXPECT_EQ(fnv1a("foobar"), 0xBF9CF968U); }

// The numbers are those of firmware/PROTOCOL.md, on which authors of other robots and hosts rely.
TEST(Schema, EveryMessageHasItsTypeAndSize) {
  const std::map<std::string, std::pair<int, std::size_t>> messages = {
      {"Hello", {0x01, 18}},       {"Sample", {0x02, 40}},      {"Acknowledge", {0x03, 8}},
      {"SyncReply", {0x04, 14}},   {"FaultReport", {0x05, 11}}, {"Log", {0x06, 45}},
      {"HelloRequest", {0x41, 6}}, {"Parameters", {0x42, 83}},  {"Command", {0x43, 40}},
      {"Arm", {0x44, 12}},         {"Disarm", {0x45, 4}},       {"Stop", {0x46, 4}},
      {"SyncRequest", {0x47, 2}}};
  std::size_t seen = 0;
  for_each_message([&](const char* name, auto message) {
    ++seen;
    ASSERT_TRUE(messages.contains(name)) << name;
    const auto [type, size] = messages.at(name);
    EXPECT_EQ(static_cast<int>(message.kType), type) << name;
    EXPECT_EQ(message.kSize, size) << name;
    // The whole payload must be written, and nothing behind it.
    for (const std::uint8_t fill : {std::uint8_t{0x00}, std::uint8_t{0xFF}}) {
      std::uint8_t payload[kMaxPayload * 2];
      std::fill(std::begin(payload), std::end(payload), fill);
      EXPECT_EQ(write_payload(message, payload), size) << name;
      EXPECT_TRUE(std::all_of(payload, payload + size, [](std::uint8_t b) { return b == 0; }))
          << name;
      EXPECT_TRUE(std::all_of(payload + size, std::end(payload), [&](std::uint8_t b) {
        return b == fill;
      })) << name;
    }
  });
  EXPECT_EQ(seen, messages.size());
}

TEST(Schema, TypesAreDistinctAndTellTheDirection) {
  std::set<Type> types;
  for_each_message([&](const char* name, auto message) {
    EXPECT_TRUE(types.insert(message.kType).second) << name;
  });
  EXPECT_EQ(types.size(), 13u);
}

TEST(Schema, APayloadOfAnotherSizeIsNotRead) {
  for_each_message([](const char* name, auto message) {
    const std::uint8_t payload[kMaxPayload + 1] = {};
    EXPECT_TRUE(read_payload(payload, message.kSize, message)) << name;
    EXPECT_FALSE(read_payload(payload, message.kSize - 1, message)) << name;
    EXPECT_FALSE(read_payload(payload, message.kSize + 1, message)) << name;
    EXPECT_FALSE(read_payload(payload, 0, message)) << name;
  });
}

}  // namespace
}  // namespace tp100::wire
