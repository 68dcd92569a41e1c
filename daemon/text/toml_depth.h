#pragma once
// How deep the keys of a TOML text are nested.

#include <string>
#include <string_view>

namespace tp100::text {

/// Throws UserError (file:line:column) if a key of the text has more than 32 dots, which the
/// reader of TOML would follow by recursion. Pure.
void refuse_deep_keys(std::string_view text, const std::string& file);

}  // namespace tp100::text
