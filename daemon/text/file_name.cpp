#include "text/file_name.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "text/json_writer.h"

namespace tp100::text {
namespace {

constexpr std::size_t kMaxFound = 255;

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || c == '.';
}

// For U+00C0 to U+017F, two characters each; a space: nothing.
constexpr std::string_view kLatin =
    "A A A A AeA AeC E E E E I I I I D N O O O O Oe  O U U U UeY Thss"
    "a a a a aea aec e e e e i i i i d n o o o o oe  o u u u uey thy "
    "A a A a A a C c C c C c C c D d D d E e E e E e E e E e G g G g "
    "G g G g H h H h I i I i I i I i I i IjijJ j K k q L l L l L l L "
    "l L l N n N n N n n N n O o O o O o OeoeR r R r R r S s S s S s "
    "S s T t T t T t U u U u U u U u U u U u W w Y y Y Z z Z z Z z s ";
static_assert(kLatin.size() == std::size_t{2} * (0x180 - 0xC0));

/// The letters for a character of UTF-8; empty: there are none.
std::string_view letters_for(std::string_view character) {
  if (character.size() == 1) return is_plain(character[0]) ? character : std::string_view();
  if (character.size() != 2) return {};
  const auto code = static_cast<std::size_t>((character[0] & 0x1f) << 6 | (character[1] & 0x3f));
  if (code < 0xC0 || code >= 0x180) return {};
  const std::string_view found = kLatin.substr(2 * (code - 0xC0), 2);
  return found.substr(0, found.find(' '));
}

}  // namespace

bool is_file_name(std::string_view name, std::size_t most) {
  return !name.empty() && name.size() <= most && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), is_plain);
}

std::string file_name_of(std::string_view text, std::size_t most) {
  std::string name;
  bool gap = false;
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(utf8_length(text), 1);
    const std::string_view letters = letters_for(text.substr(0, length));
    text.remove_prefix(length);
    if (letters.empty()) {
      gap = true;
      continue;
    }
    if (name.empty() && letters == ".") continue;
    const bool parted = gap && !name.empty() && name.back() != '-' && letters != "-";
    if (name.size() + (parted ? 1 : 0) + letters.size() > most) break;
    if (parted) name += '-';
    name += letters;
    gap = false;
  }
  return name.empty() ? std::string("unnamed").substr(0, most) : name;
}

bool is_found_name(std::string_view name) {
  if (name.empty() || name.size() > kMaxFound || name.front() == '.') return false;
  while (!name.empty()) {
    const std::size_t length = utf8_length(name);
    const auto first = static_cast<unsigned char>(name.front());
    if (length == 0 || first < 0x20 || first == 0x7f ||
        std::string_view("/\\:%#?").find(name.front()) != std::string_view::npos)
      return false;
    name.remove_prefix(length);
  }
  return true;
}

std::string percent_encoded(std::string_view name) {
  constexpr std::string_view kHexDigits = "0123456789ABCDEF";
  std::string out;
  for (const char c : name) {
    const auto byte = static_cast<std::uint8_t>(c);
    if (is_plain(c) || c == '~')
      out += c;
    else
      (out += '%') += {kHexDigits[byte >> 4U], kHexDigits[byte & 15U]};
  }
  return out;
}

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string out;
  for (; !text.empty(); text.remove_prefix(1)) {
    if (text.front() != '%') {
      out += text.front();
      continue;
    }
    std::uint8_t byte = 0;
    if (text.size() < 3) return std::nullopt;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 3, byte, 16);
    if (error != std::errc() || end != text.data() + 3) return std::nullopt;
    out += static_cast<char>(byte);
    text.remove_prefix(2);
  }
  return out;
}

}  // namespace tp100::text
