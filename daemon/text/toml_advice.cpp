#include "text/toml_advice.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace tp100::text {
namespace {

using Advice = std::pair<std::string_view, std::string_view>;

// By the first bytes of the file, white space left out.
constexpr std::array<Advice, 12> kBeginnings = {{
    {"PK\x03\x04", "a ZIP archive; unpack it"},
    {"\x89MCAP", "a recording; give it to tp100d report or replay"},
    {"\x1f\x8b", "packed by gzip; unpack it"},
    {"version https://git-lfs", "what Git LFS keeps in the place of a file; run git lfs pull"},
    {"<<<<<<<", "a git conflict; keep one of its sides, and remove the lines with <<< === >>>"},
    {"<!DOCTYPE html", "a web page; download the file itself (Raw)"},
    {"<html", "a web page; download the file itself (Raw)"},
    {"<gpx", "a GPX track; a course has segments, as in config/courses"},
    {"<", "XML; write TOML, as the files in config are"},
    {"{", "JSON; write TOML, KEY = VALUE, as the files in config are"},
    {"---", "YAML; write TOML, KEY = VALUE, as the files in config are"},
    {"%YAML", "YAML; write TOML, KEY = VALUE, as the files in config are"},
}};

// By what is anywhere in the line; the first that is there.
constexpr std::array<Advice, 19> kContents = {{
    {"<<<<<<<", kBeginnings[4].second},
    {"=======", kBeginnings[4].second},
    {">>>>>>>", kBeginnings[4].second},
    {"“", "typographic quotes; write \""},
    {"”", "typographic quotes; write \""},
    {"„", "typographic quotes; write \""},
    {"‘", "typographic quotes; write '"},
    {"’", "typographic quotes; write '"},
    {"«", "typographic quotes; write \""},
    {"»", "typographic quotes; write \""},
    {"−", "a typographic minus; write -"},
    {"–", "a dash; write -"},
    {"—", "a dash; write -"},
    {"\xc2\xa0", "a space that does not break, copied from a page; write a space"},
    {"\xe2\x80\x8b", "a character without width, copied from a page; write the line anew"},
    {"\xe2\x80\xaf", "a narrow space, copied from a page; write a space"},
    {"\xef\xbb\xbf", "a byte-order mark within the file; remove it"},
    {"，", "a wide comma; write ,"},
    {"＝", "a wide equals sign; write ="},
}};

bool digit(char c) { return c >= '0' && c <= '9'; }
bool letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

std::string_view skip_space(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

std::string_view line_of(std::string_view text, std::uint32_t line) {
  for (; line > 1 && text.find('\n') != text.npos; --line) text.remove_prefix(text.find('\n') + 1);
  return text.substr(0, text.find('\n'));
}

std::string_view of_value(std::string_view value) {
  const auto from = [&](std::string_view set) {
    return std::min(value.find_first_not_of(set), value.size());
  };
  if (value.empty()) return "a key without a value; write KEY = VALUE";
  const std::size_t end = from("+-0123456789._");
  if (end > 0 && value.find_first_of("0123456789") < end) {
    const std::string_view rest = value.substr(end);
    if (!rest.empty() && letter(rest[0]) && (value[end - 1] == '-' || value[end - 1] == '_'))
      return "a text without quotes; write KEY = \"TEXT\"";
    if (rest.size() > 1 && rest[0] == ',' && digit(rest[1]))
      return "a decimal comma; write a decimal point, 0.12";
    if (!skip_space(rest).empty() && letter(skip_space(rest)[0]) && !rest.starts_with('e'))
      return "a unit behind the number; the key's name has the unit, write the number alone";
    return "a number that TOML does not have; write 0.5, not .5 or 5.";
  }
  for (const std::string_view word : {"true", "false", "yes", "no", "on", "off", "none", "null"}) {
    const std::string_view is = value.substr(0, word.size());
    if (value.size() >= word.size() &&
        (value.size() == word.size() || !letter(value[word.size()])) &&
        std::equal(is.begin(), is.end(), word.begin(),
                   [](char a, char b) { return (a | 0x20) == b; }))
      return "a word that TOML does not have; write true or false, or leave the line out";
  }
  if (value[0] == '"' || value[0] == '\'')
    return value.find('\\') != value.npos
               ? "a text with a \\; put it in '...', where \\ has no meaning"
               : "a text whose quote is not closed, or goes on behind it; write KEY = \"TEXT\"";
  if (letter(value[0]) || value[0] == '/' || value[0] == '~')
    return "a text without quotes; write KEY = \"TEXT\"";
  return "";
}

std::string_view of_line(std::string_view line) {
  for (const auto& [part, advice] : kContents)
    if (line.find(part) != line.npos) return advice;
  line = skip_space(line);
  if (line.starts_with("//") || line.starts_with(';') || line.starts_with("--") ||
      line.starts_with("/*") || line.starts_with('%'))
    return "a comment of another language; write # before it";
  if (line.starts_with("- ") ||
      (line.find(':') < line.find('=') && !line.empty() && letter(line[0])))
    return "YAML; write TOML, KEY = VALUE, as the files in config are";
  if (const std::size_t equals = line.find('='); equals != line.npos)
    return of_value(skip_space(line.substr(equals + 1)));
  return line.starts_with('[') ? "the head of a table; write [TABLE] or [[TABLE]]" : "";
}

}  // namespace

std::string toml_advice(std::string_view text, std::uint32_t line, std::string_view why) {
  const auto has = [&](std::string_view word) { return why.find(word) != why.npos; };
  std::string_view advice, start = skip_space(text);
  // JSON may begin with an array, of which TOML makes a table's head.
  if (start.starts_with('[') && skip_space(start.substr(1)).starts_with('{'))
    start = skip_space(start.substr(1));
  if (!text.empty() && text.find_first_not_of('\0') == text.npos)
    return "only zero bytes, as a disk leaves them that lost power; take the .bak beside it, or "
           "write the file anew";
  for (const auto& [beginning, words] : kBeginnings)
    if (advice.empty() && start.starts_with(beginning)) advice = words;
  if (advice.empty() && text.find('\0') != text.npos)
    advice = "no text in UTF-8, or damaged; save it as UTF-8";
  if (advice.empty()) advice = of_line(line_of(text, line));
  if (has("utf-8") || has("UTF-8")) advice = "text in another encoding; save it as UTF-8";
  if (has("redefine") || has("already")) advice = "the key or table is there twice; keep one";
  return std::string(advice.empty()
                         ? "write KEY = VALUE, [TABLE] or # COMMENT, as in the files of config"
                         : advice);
}

}  // namespace tp100::text
