#pragma once
// Compresses text for browsers.

#include <string>
#include <string_view>

namespace tp100::server {

/// RFC 1952. Takes a millisecond for each 100 kB.
std::string gzipped(std::string_view text);

}  // namespace tp100::server
