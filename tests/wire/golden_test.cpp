// Every message has the bytes that PROTOCOL.md and robots in the field have.
#include "golden.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#include "all_messages.h"
#include "support/wire_host.h"

namespace tp100::golden {
namespace {

/// Fills the fields of a message with the values of a line.
class FromText {
 public:
  explicit FromText(const Line& line) : line_(line) {}
  template <class T>
  void field(const char* name, T& value) {
    value = number<T>(text(name));
  }
  template <class T, std::size_t N>
  void field(const char* name, T (&values)[N]) {
    std::istringstream parts(text(name));
    for (T& value : values) {
      std::string part;
      std::getline(parts, part, ',');
      value = number<T>(part);
    }
  }

 private:
  const std::string& text(const char* name) const {
    return line_.values.at(std::string(name, std::strcspn(name, ",")));
  }
  template <class T>
  static T number(const std::string& text) {
    if constexpr (std::is_same_v<T, float>)
      return std::strtof(text.c_str(), nullptr);
    else
      return static_cast<T>(std::strtoll(text.c_str(), nullptr, 0));
  }
  const Line& line_;
};

std::string to_hex(const std::vector<std::uint8_t>& bytes) {
  std::string hex;
  for (const unsigned byte : bytes) {
    hex += "0123456789ABCDEF"[byte >> 4U];
    hex += "0123456789ABCDEF"[byte & 15U];
  }
  return hex;
}

TEST(GoldenFrames, CodeAndDecodeAsCommitted) {
  const std::vector<Line> lines = read_lines();
  std::size_t at = 0;
  wire::for_each_message([&](const char* name, auto message) {
    ASSERT_LT(at, lines.size());
    const Line& line = lines[at++];
    ASSERT_EQ(line.name, name);
    FromText from(line);
    message.visit(from);
    const std::vector<std::uint8_t> frame = test::frame_of(message);
    EXPECT_EQ(to_hex(frame), line.hex) << name;
    wire::FrameDecoder decoder;
    wire::DecodeResult last{};
    for (const std::uint8_t byte : frame) last = decoder.push(byte);
    ASSERT_EQ(last, wire::DecodeResult::kFrame) << name;
    EXPECT_EQ(decoder.type(), static_cast<std::uint8_t>(message.kType)) << name;
    decltype(message) decoded{};
    ASSERT_TRUE(wire::read_payload(decoder.payload(), decoder.size(), decoded)) << name;
    EXPECT_EQ(test::frame_of(decoded), frame) << name;
  });
  EXPECT_EQ(at, lines.size());
}

}  // namespace
}  // namespace tp100::golden
