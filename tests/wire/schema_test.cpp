// Tests that the messages are those of firmware/PROTOCOL.md, on which authors of other robots and
// hosts rely.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "all_messages.h"
#include "support/paths.h"
#include "wire/faults.h"
#include "wire/frame.h"

namespace tp100::wire {
namespace {

struct Field {
  std::string name, type;  // `i16[3]`
  std::size_t bytes;
};

class Fields {
 public:
  template <class T>
  void field(const char* name, const T&) {
    all.push_back({text(name), type_of<T>(), sizeof(T)});
  }
  template <class T, std::size_t N>
  void field(const char* name, const T (&)[N]) {
    all.push_back({text(name), type_of<T>() + "[" + std::to_string(N) + "]", N * sizeof(T)});
  }
  std::vector<Field> all;

 private:
  static std::string text(const char* name) { return {name, std::strcspn(name, ",")}; }
  template <class T>
  static std::string type_of() {
    const char* kind = std::is_same_v<T, float> ? "f" : std::is_signed_v<T> ? "i" : "u";
    return kind + std::to_string(8 * sizeof(T));
  }
};

template <class Message>
std::vector<Field> fields_of(Message message) {
  Fields fields;
  message.visit(fields);
  return fields.all;
}

std::string hex(std::uint32_t value, int digits) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%0*X", digits, value);
  return text;
}

/// A line `0x43 boot_nonce:u32 sequence:u16 ... gyro:i16[3]\n` per message.
std::string schema_text() {
  std::string text;
  for_each_message([&](const char*, auto message) {
    text += hex(static_cast<std::uint8_t>(message.kType), 2);
    for (const Field& field : fields_of(message)) text += ' ' + field.name + ':' + field.type;
    text += '\n';
  });
  return text;
}

std::uint32_t fnv1a(const std::string& text) {
  std::uint32_t hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 16777619U;
  return hash;
}

std::string document() {
  std::ifstream file(source_path("firmware/PROTOCOL.md"));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void expect_in_document(const std::string& text) {
  EXPECT_NE(document().find(text), std::string::npos) << text;
}

TEST(Schema, HashIsThatOfTheMessagesAsTheyAre) {
  EXPECT_EQ(fnv1a("foobar"), 0xBF9CF968U) << "the published test vector";
  EXPECT_EQ(kSchemaHash, fnv1a(schema_text()))
      << "kSchemaHash must be " << hex(fnv1a(schema_text()), 8) << " for\n"
      << schema_text();
}

TEST(Schema, APayloadHasTheStatedSizeAndIsReadOnlyWithIt) {
  for_each_message([](const char* name, auto message) {
    const std::size_t size = message.kSize;
    for (const std::uint8_t fill : {std::uint8_t{0x00}, std::uint8_t{0xFF}}) {
      std::uint8_t payload[kMaxPayload * 2];
      std::fill(std::begin(payload), std::end(payload), fill);
      EXPECT_EQ(write_payload(decltype(message){}, payload), size) << name;
      EXPECT_TRUE(std::all_of(payload, payload + size, [](std::uint8_t b) { return b == 0; }))
          << name << " is not written completely";
      EXPECT_TRUE(
          std::all_of(payload + size, std::end(payload), [&](std::uint8_t b) { return b == fill; }))
          << name << " is written beyond its end";
    }
    const std::uint8_t payload[kMaxPayload + 1] = {};
    EXPECT_TRUE(read_payload(payload, size, message)) << name;
    for (const std::size_t other : {std::size_t{0}, size - 1, size + 1}) {
      EXPECT_FALSE(read_payload(payload, other, message)) << name;
    }
  });
}

TEST(ProtocolDocument, ListsEveryFaultWithItsBit) {
#define TP100_FAULT_ROW(bit, name, cause, fix) \
  expect_in_document("| " #bit " | `" #name "` | " cause " | " fix " |");
  TP100_ROBOT_FAULTS(TP100_FAULT_ROW)
  TP100_DAEMON_FAULTS(TP100_FAULT_ROW)
#undef TP100_FAULT_ROW
}

// A row is `| offset | type | name |`.
TEST(ProtocolDocument, HasEveryMessageWithTypeAndSizeAndEveryFieldWithOffsetAndType) {
  const std::string text = document();
  for_each_message([&](const char* name, auto message) {
    const std::string title = std::string("### `") + name + "` " +
                              hex(static_cast<std::uint8_t>(message.kType), 2) + ", " +
                              std::to_string(message.kSize) + " bytes";
    std::size_t at = text.find(title);
    ASSERT_NE(at, std::string::npos) << title;
    const std::size_t end = text.find("\n#", at + 1);
    std::size_t offset = 0;
    for (const Field& field : fields_of(message)) {
      const std::string row =
          "| " + std::to_string(offset) + " | " + field.type + " | `" + field.name + "` | ";
      at = text.find(row, at);
      ASSERT_TRUE(at != std::string::npos && at < end) << title << ": " << row;
      offset += field.bytes;
    }
  });
}

TEST(ProtocolDocument, StatesVersionAndSchema) {
  expect_in_document("protocol version " + std::to_string(kProtocolVersion) + ", schema hash " +
                     hex(kSchemaHash, 8));
}

}  // namespace
}  // namespace tp100::wire
