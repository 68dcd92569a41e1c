#pragma once
// ModemManager speaks AT commands to every new port that it takes for a modem: they reach the
// bootloader and the firmware.

#include <string>

#include "doctor/finding.h"
#include "doctor/system.h"
#include "link/port_discovery.h"

namespace tp100::doctor {

/// Does it run, and has udev told it to leave `device` alone? Name: modem-manager.
Findings modem_manager_findings(const System& system, const std::string& device,
                                const link::PortInfo& info);

}  // namespace tp100::doctor
