#pragma once
// Who holds a device open. Set-up only.

#include <filesystem>
#include <string>

namespace tp100::link {

struct PortHolder {
  std::string name{};          ///< "name (pid N)"; empty: none was seen
  bool others_hidden = false;  ///< not every process of the machine could be looked at
};

/// The first other process that has the device `real_path` open, under whatever name in /dev. What
/// programs of other accounts have open, only root sees; from within a container nobody sees those
/// outside. `proc` is where processes are looked up.
PortHolder port_holder(const std::string& real_path, const std::filesystem::path& proc = "/proc");

}  // namespace tp100::link
