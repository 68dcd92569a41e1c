#include "text/key.h"

#include <algorithm>

#include "text/format.h"

namespace tp100::text {
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
      text += format("\\u%04X", static_cast<unsigned>(c));
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

std::string toml_value(const TomlValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<long long>(&value)) return std::to_string(*whole);
  if (const double* number = std::get_if<double>(&value)) return toml_number(*number);
  return toml_string(std::get<std::string>(value));
}

KeyText::Value shown_value(const TomlValue& value) {
  if (const auto* whole = std::get_if<long long>(&value)) return static_cast<double>(*whole);
  if (const bool* flag = std::get_if<bool>(&value)) return *flag;
  if (const double* number = std::get_if<double>(&value)) return *number;
  return std::get<std::string>(value);
}

Origins read_origins(std::string_view text, std::string_view table) {
  constexpr std::string_view kFirst = "# From";
  Origins origins;
  bool inside = false, within = false;
  std::string origin;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with('[')) inside = line == "[" + std::string(table) + "]";
    // A continuation line may begin with "From", too, and a long word leaves it alone on the first
    // line.
    if (within && line.starts_with("# ")) {
      origin += line.substr(1);
    } else if (line == kFirst || line.starts_with(std::string(kFirst) + " ")) {
      within = true;
      origin = line.substr(kFirst.size());
    } else {
      const std::size_t equals = line.find(" = ");
      if (origin.starts_with(' ')) origin.erase(0, 1);
      if (origin.ends_with('.')) origin.pop_back();
      if (inside && !origin.empty() && equals != std::string_view::npos)
        origins[std::string(line.substr(0, equals))] = origin;
      within = false;
      origin.clear();
    }
  }
  return origins;
}

}  // namespace tp100::text
