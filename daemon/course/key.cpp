#include "course/key.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace tp100::course {
namespace {

constexpr std::size_t kColumns = 100;

}  // namespace

std::string toml_number(double value) {
  std::string text = number_text(value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string toml_string(std::string_view value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') {
      text += '\\';
      text += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      std::array<char, 8> buffer{};
      std::snprintf(buffer.data(), buffer.size(), "\\u%04X", static_cast<unsigned>(c));
      text += buffer.data();
    } else {
      text += c;
    }
  }
  return text + "\"";
}

std::string toml_comment(std::string_view text) {
  std::string result, line = "#";
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (line.size() + 1 + end > kColumns) {
      result += line + "\n";
      line = "#";
    }
    line += " " + std::string(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result + line + "\n";
}

std::string range_and_unit(std::string_view key, Range range) {
  const std::string_view unit = unit_of(key);
  return number_text(range.min) + " to " + number_text(range.max) +
         (unit.empty() ? std::string() : " " + std::string(unit));
}

}  // namespace tp100::course
