#pragma once
// Base64 (RFC 4648, with padding), in which JSON carries bytes.

#include <string>
#include <string_view>

namespace tp100::text {

std::string base64(std::string_view bytes);

}  // namespace tp100::text
