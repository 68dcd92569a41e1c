#pragma once
// Finds the process that holds a device open. Set-up only.

#include <filesystem>
#include <string>

namespace tp100::link {

struct PortHolder {
  std::string name{};          ///< "name (pid N)"; empty: none found
  bool others_hidden = false;  ///< some processes of the machine could not be inspected
};

/// The first other process that has the device `real_path` open, under any name in /dev. Only root
/// sees what programs of other accounts have open; from within a container, those outside are
/// invisible. `proc` is the proc file system to search.
PortHolder port_holder(const std::string& real_path, const std::filesystem::path& proc = "/proc");

}  // namespace tp100::link
