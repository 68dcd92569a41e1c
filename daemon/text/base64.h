#pragma once
// Base64 (RFC 4648, with padding), for bytes in JSON.

#include <optional>
#include <string>
#include <string_view>

namespace tp100::text {

std::string base64(std::string_view bytes);

/// The bytes of such a text; nothing if it is invalid.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace tp100::text
