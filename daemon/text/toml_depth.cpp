#include "text/toml_depth.h"

#include <algorithm>
#include <cstdint>

#include "core/error.h"

namespace tp100::text {
namespace {

// toml++ recurses once per dotted part, and its own limit counts brackets only.
constexpr int kMaxDots = 32;

/// Where the comment or string ends that begins at `begin`, as TOML reads it; `begin`: there is
/// none.
std::size_t end_of_text(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  if (quote == '#') return std::min(text.find('\n', begin), text.size());
  if (quote != '"' && quote != '\'') return begin;
  const std::string three(3, quote);
  const bool lines = text.substr(begin).starts_with(three);
  std::size_t next = begin + (lines ? 3 : 1);
  for (; next < text.size(); ++next) {
    if (text[next] == '\\' && quote == '"') {
      ++next;
    } else if (!lines && (text[next] == quote || text[next] == '\n')) {
      return next + 1;
    } else if (lines && text.substr(next).starts_with(three)) {
      next += 3;
      // Up to two quotes may stand before the three that end the string.
      for (int i = 0; i < 2 && next < text.size() && text[next] == quote; ++i) ++next;
      return next;
    }
  }
  return text.size();
}

}  // namespace

// Between the dots of a key are its parts, strings among them, and blanks.
void refuse_deep_keys(std::string_view text, const std::string& file) {
  std::uint32_t line = 1;
  int dots = 0;
  for (std::size_t next = 0; next < text.size();) {
    if (const std::size_t end = end_of_text(text, next); end > next) {
      const std::string_view passed = text.substr(next, end - next);
      line += static_cast<std::uint32_t>(std::count(passed.begin(), passed.end(), '\n'));
      next = end;
      continue;
    }
    const char c = text[next++];
    if (c == '\n') ++line;
    if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) dots = 0;
    if (c == '.' && ++dots > kMaxDots)
      throw UserError(file + ":" + std::to_string(line) + ":1: more than " +
                      std::to_string(kMaxDots) + " dots in a key; no key is nested that deep");
  }
}

}  // namespace tp100::text
