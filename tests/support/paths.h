#pragma once
// Paths of this checkout and this build. Only one object contains them, so that in another
// directory the compiler cache serves all others.

#include <string>

namespace tp100 {

/// Path of a file or folder of the checkout or of the build, which is given relative to its root.
std::string source_path(const std::string& relative = "");
std::string build_path(const std::string& relative = "");

}  // namespace tp100
