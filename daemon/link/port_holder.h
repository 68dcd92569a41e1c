#pragma once
// Who holds a device open. Set-up only.

#include <filesystem>
#include <string>

namespace tp100::link {

/// "name (pid N)" of the first other process that has `real_path` open and that we may look at;
/// else empty. `proc` is where processes are looked up.
std::string port_holder(const std::string& real_path, const std::filesystem::path& proc = "/proc");

}  // namespace tp100::link
