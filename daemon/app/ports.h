#pragma once
// `tp100d ports`: which serial ports there are.

#include <string>
#include <vector>

#include "link/port_discovery.h"

namespace tp100::app {

/// One line per port, likely ones first, with the configuration line to copy. Pure.
/// `stable_names[i]` is a path for ports[i] that survives replugging, or empty; `passed_over`: what
/// `auto` does not open.
std::string ports_text(const std::vector<link::PortInfo>& ports,
                       const std::vector<std::string>& stable_names,
                       const std::vector<link::PassedOver>& passed_over);

/// The command. Always 0. Throws SetupError.
int run_ports();

}  // namespace tp100::app
