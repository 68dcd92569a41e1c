#pragma once
// Which port the robot is on, and who else has it open.

#include <string>
#include <vector>

#include "doctor/finding.h"
#include "doctor/system.h"
#include "link/port_discovery.h"

namespace tp100::doctor {

/// The port to examine.
struct ChosenPort {
  std::string path;              ///< as it was named; empty: there is none
  std::string device;            ///< the device file behind it, "/dev/..."
  link::PortInfo info{};         ///< what its bus says of it
  bool pseudo_terminal = false;  ///< an emulator's, or a serial server's
  Findings findings{};           ///< names: device, by-id
};

/// `port`: a path, or "auto" for the one of `ports` that `tp100d run` would take.
ChosenPort choose_port(const System& system, const std::string& port,
                       const std::vector<link::PortInfo>& ports);

/// udev's name for a device that survives replugging; empty if it has none.
std::string stable_name(const System& system, const std::string& device);

/// Which program has `device` open, as far as we may look. Name: holder.
Findings holder_findings(const System& system, const std::string& device);

}  // namespace tp100::doctor
