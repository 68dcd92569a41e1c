#pragma once
// Names of files and folders: those that the program makes, and those that it finds. Every name
// that it makes is one that it finds.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tp100::text {

/// Whether the program may make a file of this name, in a folder of its own: letters, digits, '-',
/// '_' and '.', at most `most`, no '.' first.
bool is_file_name(std::string_view name, std::size_t most = 64);
/// The rule of is_file_name, for an argument called name.
inline constexpr const char* kFileNameRule =
    "name must be 1 to 64 letters, digits, '-', '_' or '.', not starting with '.'";

/// The name nearest to `text` that is_file_name() accepts: accents of European letters are dropped,
/// an umlaut becomes two letters, and anything else '-'. "unnamed" if nothing is left.
std::string file_name_of(std::string_view text, std::size_t most = 64);

/// Whether a file that is found is shown to viewers and opened for them by its name: UTF-8 of at
/// most 255 bytes without control characters, no '.' first, and without / \ : % # ?, which have a
/// meaning in paths and addresses.
bool is_found_name(std::string_view name);
/// The rule of is_found_name, for an argument called name.
inline constexpr const char* kFoundNameRule =
    "name must be 1 to 255 bytes without control characters and / \\ : % # ?, not starting with "
    "'.'";

/// `name` as a part of an address: what is no letter, digit, '-', '_', '.' or '~' as %XX.
std::string percent_encoded(std::string_view name);
/// The opposite; nothing: a % without two hexadecimal digits after it.
std::optional<std::string> percent_decoded(std::string_view text);

}  // namespace tp100::text
