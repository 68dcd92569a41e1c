#pragma once
// Changes values in the text of a TOML file as a person does: everything else, comments, order and
// line ends included, stays byte for byte.

#include <string>

#include "text/toml_document.h"

namespace tp100::text {

/// `text` with these values in the place of the present ones. A key that is absent is added behind
/// the last key of its table; a table that is absent, at the end. Names are bare keys joined by
/// dots, without repetition. `file` is only used in messages. Throws SetupError: text that is not
/// TOML, a name that leads through a value or names a table, and a table that is written on one
/// line and lacks the key. Pure.
std::string with_values_in_place(const std::string& text, const std::string& file,
                                 const NamedValues& values);

}  // namespace tp100::text
