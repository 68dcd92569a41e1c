// Compares PROTOCOL.md with the code where this is possible.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "all_messages.h"
#include "golden.h"
#include "support/paths.h"
#include "wire/faults.h"

namespace tp100::wire {
namespace {

std::string document() {
  std::ifstream file(source_path("firmware/PROTOCOL.md"));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(ProtocolDocument, QuotesEveryGoldenFrame) {
  const std::string text = document();
  const auto lines = golden::read_lines(source_path("tests/wire/golden_frames.txt"));
  ASSERT_FALSE(lines.empty());
  for (const golden::Line& line : lines) {
    EXPECT_NE(text.find("\n" + line.name + " " + line.hex + "\n"), std::string::npos) << line.name;
  }
}

TEST(ProtocolDocument, ListsEveryFaultWithItsBit) {
  const std::string text = document();
#define TP100_FAULT_ROW(bit, name, cause, fix)                                                \
  EXPECT_NE(text.find("| " #bit " | `" #name "` | " cause " | " fix " |"), std::string::npos) \
      << "| " #bit " | `" #name "` | " cause " | " fix " |";
  TP100_ROBOT_FAULTS(TP100_FAULT_ROW)
  TP100_DAEMON_FAULTS(TP100_FAULT_ROW)
#undef TP100_FAULT_ROW
}

// Collects the rows `| offset | type | name |` of one message.
class TableRows {
 public:
  void field(const char* name, const std::uint8_t&) { add(name, "u8", 1, 1); }
  void field(const char* name, const std::uint16_t&) { add(name, "u16", 2, 1); }
  void field(const char* name, const std::uint32_t&) { add(name, "u32", 4, 1); }
  void field(const char* name, const std::int16_t&) { add(name, "i16", 2, 1); }
  void field(const char* name, const std::int32_t&) { add(name, "i32", 4, 1); }
  void field(const char* name, const float&) { add(name, "f32", 4, 1); }
  template <std::size_t N>
  void field(const char* name, const std::uint8_t (&)[N]) {
    add(name, "u8[" + std::to_string(N) + "]", 1, N);
  }
  template <std::size_t N>
  void field(const char* name, const std::int16_t (&)[N]) {
    add(name, "i16[" + std::to_string(N) + "]", 2, N);
  }
  const std::vector<std::string>& rows() const { return rows_; }

 private:
  void add(const char* name, const std::string& type, std::size_t bytes, std::size_t count) {
    rows_.push_back("| " + std::to_string(offset_) + " | " + type + " | `" + name + "` | ");
    offset_ += bytes * count;
  }
  std::size_t offset_ = 0;
  std::vector<std::string> rows_;
};

TEST(ProtocolDocument, TablesHaveEveryFieldWithOffsetAndType) {
  const std::string text = document();
  for_each_message([&](const char* name, auto message) {
    char title[64];
    std::snprintf(title, sizeof title, "### `%s` 0x%02X, %zu bytes", name,
                  static_cast<unsigned>(message.kType), static_cast<std::size_t>(message.kSize));
    std::size_t at = text.find(title);
    ASSERT_NE(at, std::string::npos) << title;
    const std::size_t end = text.find("\n#", at + 1);
    TableRows table;
    message.visit(table);
    for (const std::string& row : table.rows()) {
      at = text.find(row, at);
      ASSERT_TRUE(at != std::string::npos && at < end) << title << ": " << row;
    }
  });
}

TEST(ProtocolDocument, StatesVersionAndSchema) {
  char line[80];
  std::snprintf(line, sizeof line, "protocol version %u, schema hash 0x%08X", kProtocolVersion,
                kSchemaHash);
  EXPECT_NE(document().find(line), std::string::npos) << line;
}

}  // namespace
}  // namespace tp100::wire
