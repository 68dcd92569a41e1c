#include "text/encoding.h"

#include <cstdint>

namespace tp100::text {
namespace {

constexpr std::uint32_t kReplacement = 0xFFFD;

void append(std::string& out, std::uint32_t code) {
  const auto add = [&out](std::uint32_t byte) { out += static_cast<char>(byte); };
  const auto rest = [&add](std::uint32_t bits) { add(0x80U | (bits & 0x3fU)); };
  if (code < 0x80) return add(code);
  if (code < 0x800) {
    add(0xC0U | code >> 6U);
  } else {
    if (code < 0x10000) {
      add(0xE0U | code >> 12U);
    } else {
      add(0xF0U | code >> 18U);
      rest(code >> 12U);
    }
    rest(code >> 6U);
  }
  rest(code);
}

bool is_high(std::uint32_t unit) { return unit >= 0xD800 && unit < 0xDC00; }
bool is_low(std::uint32_t unit) { return unit >= 0xDC00 && unit < 0xE000; }

}  // namespace

std::string as_utf8(std::string text) {
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  const bool little = text.starts_with("\xff\xfe");
  if (!little && !text.starts_with("\xfe\xff")) return text;
  const auto unit = [&](std::size_t at) -> std::uint32_t {
    if (at + 1 >= text.size()) return 0;
    const auto first = static_cast<unsigned char>(text[at]);
    const auto second = static_cast<unsigned char>(text[at + 1]);
    return little ? second * 256U + first : first * 256U + second;
  };
  std::string out;
  for (std::size_t at = 2; at + 1 < text.size(); at += 2) {
    const std::uint32_t code = unit(at), next = unit(at + 2);
    if (is_high(code) && is_low(next)) {
      append(out, 0x10000U + ((code - 0xD800U) << 10U) + (next - 0xDC00U));
      at += 2;
    } else {
      append(out, is_high(code) || is_low(code) ? kReplacement : code);
    }
  }
  return out;
}

}  // namespace tp100::text
