#pragma once
// The name that somebody probably meant.

#include <string_view>
#include <vector>

namespace tp100::text {

/// The candidate with the smallest edit distance to `name` (insert, delete, replace, swap
/// neighbours), or empty if none is near enough to be a typing error. Long names are never near.
std::string_view nearest_name(std::string_view name,
                              const std::vector<std::string_view>& candidates);

}  // namespace tp100::text
