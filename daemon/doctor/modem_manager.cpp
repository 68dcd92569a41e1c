#include "doctor/modem_manager.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace tp100::doctor {
namespace {

namespace fs = std::filesystem;

bool runs(const System& system, const std::string& wanted) {
  const std::vector<std::string> processes = system.names("/proc");
  return std::any_of(processes.begin(), processes.end(), [&](const std::string& process) {
    return process.find_first_not_of("0123456789") == std::string::npos &&
           system.text("/proc/" + process + "/comm") == wanted;
  });
}

/// udev's record of the device whose folder in /sys this is.
std::string udev_record(const System& system, const std::string& sys, char kind) {
  const auto number = system.text(sys + "/dev");
  return number ? system.text("/run/udev/data/" + (kind + *number)).value_or("") : "";
}

bool ignored(const std::string& record) {
  return record.find("E:ID_MM_DEVICE_IGNORE=1") != std::string::npos ||
         record.find("E:ID_MM_PORT_IGNORE=1") != std::string::npos;
}

/// The rule stands with the port or with the USB device that it belongs to.
bool left_alone(const System& system, const std::string& device) {
  fs::path at = system.real("/sys/class/tty/" + fs::path(device).filename().string());
  while (at.has_relative_path()) {
    if (ignored(udev_record(system, at, 'c'))) return true;
    at = at.parent_path();
  }
  return false;
}

std::string rule_for(const link::PortInfo& info) {
  char ids[80];
  std::snprintf(ids, sizeof ids, "ATTRS{idVendor}==\"%04x\", ATTRS{idProduct}==\"%04x\", ",
                static_cast<unsigned>(info.vendor_id), static_cast<unsigned>(info.product_id));
  return std::string("SUBSYSTEM==\"tty\", ") + ids + "ENV{ID_MM_PORT_IGNORE}=\"1\"";
}

}  // namespace

Findings modem_manager_findings(const System& system, const std::string& device,
                                const link::PortInfo& info) {
  if (!runs(system, "ModemManager")) return {ok("modem-manager", "does not run")};
  if (left_alone(system, device)) return {ok("modem-manager", "runs, but leaves the port alone")};
  if (info.vendor_id < 0 || info.product_id < 0)
    return {{Severity::kWarning, "modem-manager", "runs and may write to " + device,
             "without a modem in this machine: sudo systemctl disable --now ModemManager"}};
  return {{Severity::kWarning, "modem-manager",
           "runs and may write to " + device + " whenever it is plugged in",
           "echo '" + rule_for(info) +
               "' | sudo tee /etc/udev/rules.d/70-tp100.rules && sudo udevadm control --reload, "
               "then plug the robot in again"}};
}

}  // namespace tp100::doctor
