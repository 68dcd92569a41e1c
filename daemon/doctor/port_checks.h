#pragma once
// Checks of what can keep a port from being used: the choice of the port, permission, other
// programs, USB.

#include <sys/types.h>

#include <string>
#include <vector>

#include "doctor/finding.h"
#include "doctor/system.h"
#include "link/port_discovery.h"

namespace tp100::doctor {

// Finds the robot's port and the programs that have it open.

/// The port to examine.
struct ChosenPort {
  std::string path;              ///< as configured; empty: there is none
  std::string device;            ///< the device file behind it, "/dev/..."
  link::PortInfo info{};         ///< as its bus reports it
  bool pseudo_terminal = false;  ///< an emulator's, or a serial server's
  Findings findings{};           ///< names: device, by-id
};

/// `port`: a path, or "auto" for the one of `ports` that `tp100d run` would open. `open`: the port
/// that this process already has open instead; empty: none.
ChosenPort choose_port(const System& system, const std::string& port,
                       const std::vector<link::PortInfo>& ports, const std::string& open = {});

/// The name that udev gives a device and that survives replugging; empty if it has none.
std::string stable_name(const System& system, const std::string& device);

/// The program that has `device` open, as far as permissions show. Name: holder.
Findings holder_findings(const System& system, const std::string& device);

// Whether an account may use a device file, or first has to log in again.

/// The account that runs this session.
struct Account {
  std::string name;
  std::vector<gid_t> groups;  ///< of this session, including the primary one
};

/// The account of this process.
Account this_account();

/// Whether the account may read and write `device`. `usable` is the result of System::usable; mode
/// and groups only explain a refusal. Names: permission, group.
Findings permission_findings(const System& system, const std::string& device,
                             const Account& account, bool usable);

// ModemManager sends AT commands to every new port that it believes to be a modem: they reach the
// bootloader and the firmware.

/// Whether it runs, and whether a udev rule excludes `device`. Name: modem-manager.
Findings modem_manager_findings(const System& system, const std::string& device,
                                const link::PortInfo& info);

/// The findings of the choice, and whether this process may use the port and no other program keeps
/// it from that. `open`: this process has it open.
Findings port_findings(const System& system, const ChosenPort& port, bool open = false);

// Settings of the USB bus and the bridge chip that affect the robot's bytes.

/// Names: autosuspend, latency-timer, bridge; nothing for a port that is not on USB. Call it while
/// tp100d has had the port open: opening requests low latency from the bridge.
Findings usb_findings(const System& system, const std::string& device, const link::PortInfo& info);

}  // namespace tp100::doctor
