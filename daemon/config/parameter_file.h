#pragma once
// Parameters in the text of a configuration file: changed in place, checked by its own reader, and
// what differs between two texts. Pure.

#include <string>
#include <utility>
#include <vector>

#include "course/bundled_files.h"
#include "text/key.h"

namespace tp100::config {

/// Names, and values in the file's unit.
using ParameterValues = std::vector<std::pair<std::string, text::KeyText::Value>>;

/// Whether clients may have that key of the configuration saved. Only the file's owner can change
/// keys that decide who reaches the daemon and which files it opens: the tables [server] and
/// [ros2], and texts, except the names of robot and course.
bool may_save(const text::KeyText& key);

/// The text of the file with these values; every other line stays byte for byte. Throws UserError:
/// a name that the configuration does not have, a value of another type, or a resulting text that
/// the reader of the configuration refuses or reads as another value.
std::string with_parameters(const course::TextFile& file, const ParameterValues& values);

/// A parameter that two texts give different values, as written in a file.
struct ParameterDifference {
  std::string name, before, after;
};

/// In the order of the file; an absent key has its default. Throws UserError: a text that the
/// reader of the configuration refuses.
std::vector<ParameterDifference> parameter_differences(const course::TextFile& before,
                                                       const course::TextFile& after);

}  // namespace tp100::config
