#pragma once
// Who holds a device open. Set-up only.

#include <string>

namespace tp100::link {

/// "name (pid N)" of the first other process that has `real_path` open and that we may look at;
/// else empty.
std::string port_holder(const std::string& real_path);

}  // namespace tp100::link
