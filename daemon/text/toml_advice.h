#pragma once
// What text that is not TOML seems to be, for the message that refuses it.

#include <cstdint>
#include <string>
#include <string_view>

namespace tp100::text {

/// What to do about `text`, of which TOML does not permit line `line` (from 1) for the reason
/// `why`: "a git conflict; keep one of its sides". One line, never empty. Pure.
std::string toml_advice(std::string_view text, std::uint32_t line, std::string_view why);

}  // namespace tp100::text
