#pragma once
// Units of keys and columns. Pure.

#include <string_view>

namespace tp100::text {

/// Unit of a key, by the suffix of its name (speed_mps: "m/s"); empty if it has none.
std::string_view unit_of(std::string_view key);

}  // namespace tp100::text
