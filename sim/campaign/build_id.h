#pragma once
// Which build of a program runs.

#include <map>
#include <string>

namespace tp100::sim {

/// Build ids (hexadecimal, as the linker wrote them) of what is loaded into this process: by file
/// name without its folder; the program itself is "". What has none is not there.
std::map<std::string, std::string> build_ids();

}  // namespace tp100::sim
