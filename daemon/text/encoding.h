#pragma once
// The encoding of text files, which people's editors choose for them.

#include <string>

namespace tp100::text {

/// `text` as UTF-8 without a byte-order mark: UTF-16 with one, as programs on Windows save it, is
/// converted, a half pair reads as U+FFFD; anything else stays as it is. Pure.
std::string as_utf8(std::string text);

}  // namespace tp100::text
