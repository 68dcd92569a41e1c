#pragma once
// What the USB bus and the bridge chip do to the robot's bytes.

#include <string>

#include "doctor/finding.h"
#include "doctor/system.h"
#include "link/port_discovery.h"

namespace tp100::doctor {

/// Names: autosuspend, latency-timer, bridge; nothing for a port that is not on USB. Look when
/// tp100d has had the port open: it asks the bridge for low latency itself.
Findings usb_findings(const System& system, const std::string& device, const link::PortInfo& info);

}  // namespace tp100::doctor
