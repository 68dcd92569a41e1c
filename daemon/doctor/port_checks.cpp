#include "doctor/port_checks.h"

#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

#include "link/port_holder.h"
#include "link/transport.h"
#include "text/format.h"

namespace tp100::doctor {

namespace {

constexpr const char* kById = "/dev/serial/by-id";

ChosenPort missing(std::string seen, std::string fix) {
  ChosenPort none;
  none.findings = {error("device", std::move(seen), std::move(fix))};
  return none;
}

void add_stable_name(const System& system, ChosenPort& port, std::size_t candidates) {
  const std::string stable = stable_name(system, port.device);
  if (stable.empty()) {
    port.findings.push_back(
        {Severity::kNote, "by-id", port.device + ": no name in " + kById + " leads to it",
         "with several boards, set link.port again each time it is plugged in (see tp100d ports)"});
  } else if (candidates > 1 && port.path != stable) {
    port.findings.push_back(warning(
        "by-id",
        std::to_string(candidates) + " boards may be the robot, and auto opens none of several",
        "set link.port = \"" + stable + "\" in the configuration"));
  } else {
    port.findings.push_back(ok("by-id", stable));
  }
}

}  // namespace

ChosenPort choose_port(const System& system, const std::string& port,
                       const std::vector<link::PortInfo>& ports, const std::string& open) {
  const std::vector<link::PortInfo> likely = link::candidates(ports);
  ChosenPort chosen;
  chosen.path = open.empty() ? port : open;
  if (chosen.path == "auto") {
    const link::AutoChoice choice = link::choose_for_auto(ports, [&](const std::string& path) {
      return link::port_holder(path, system.file("/proc"));
    });
    if (!choice.open) {
      const std::string why = link::why_none(choice);
      const std::size_t end = why.rfind("; ");
      return missing(why.substr(0, end), why.substr(end + 2));
    }
    chosen.path = choice.open->path;
  }
  chosen.device = system.real(chosen.path);
  if (chosen.device.empty())
    return missing(chosen.path + ": no such port",
                   "plug the robot in, or name another port with --port (see tp100d ports)");
  if (const auto file = system.device(chosen.device)) {
    if (S_ISDIR(file->mode))
      return missing(chosen.path + ": no port, but a folder",
                     "name the robot's port with --port (see tp100d ports)");
    chosen.pseudo_terminal = link::is_pseudo_terminal(file->mode, file->number);
  }
  const auto known = std::find_if(ports.begin(), ports.end(), [&](const link::PortInfo& info) {
    return info.path == chosen.device;
  });
  if (known != ports.end()) chosen.info = *known;
  chosen.findings.push_back(ok(
      "device", chosen.device + ": " +
                    (chosen.pseudo_terminal ? "a pseudo-terminal" : link::describe(chosen.info)) +
                    (chosen.info.serial.empty() ? "" : ", serial " + chosen.info.serial)));
  if (!chosen.pseudo_terminal) add_stable_name(system, chosen, port == "auto" ? likely.size() : 1);
  return chosen;
}

std::string stable_name(const System& system, const std::string& device) {
  const std::string wanted = system.real(device);
  if (wanted.empty()) return {};
  for (const std::string& name : system.names(kById)) {
    std::string path = std::string(kById) + "/" + name;
    if (system.real(path) == wanted) return path;
  }
  return {};
}

Findings holder_findings(const System& system, const std::string& device) {
  const link::PortHolder holder = link::port_holder(device, system.file("/proc"));
  if (!holder.name.empty())
    return {error(
        "holder", device + ": held open by " + holder.name,
        "end that program (a service: `sudo systemctl stop 'tp100d@*'`), or choose another port "
        "with --port")};
  return {ok("holder", device + ": no other program " +
                           (holder.others_hidden ? "of this account " : "") + "has it open")};
}

namespace {

/// A line of /etc/group.
struct Group {
  std::string name;
  std::vector<std::string> members;
};

std::optional<Group> group_of(const System& system, gid_t gid) {
  for (const std::string& line : lines(system.text("/etc/group").value_or(""))) {
    const std::vector<std::string> fields = split(line, ':');
    if (fields.size() < 3 || fields[2] != std::to_string(gid)) continue;
    return Group{fields[0], fields.size() > 3 ? split(fields[3], ',') : std::vector<std::string>()};
  }
  return std::nullopt;
}

bool granted(mode_t mode, mode_t both) { return (mode & both) == both; }

std::string mode_text(mode_t mode) {
  return text::format("%04o", static_cast<unsigned>(mode & 07777U));
}

}  // namespace

Account this_account() {
  Account account;
  const uid_t uid = ::geteuid();
  const passwd* entry = ::getpwuid(uid);
  account.name = entry == nullptr ? std::to_string(uid) : entry->pw_name;
  account.groups.resize(static_cast<std::size_t>(std::max(0, ::getgroups(0, nullptr))));
  const int count = ::getgroups(static_cast<int>(account.groups.size()), account.groups.data());
  account.groups.resize(static_cast<std::size_t>(std::max(0, count)));
  account.groups.push_back(::getegid());
  return account;
}

Findings permission_findings(const System& system, const std::string& device,
                             const Account& account, bool usable) {
  const std::optional<DeviceFile> file = system.device(device);
  if (!file) return {};
  if (usable) return {ok("permission", device + ": " + account.name + " may read and write it")};
  const std::optional<Group> group = group_of(system, file->gid);
  const std::string name = group ? group->name : std::to_string(file->gid);
  if (!granted(file->mode, S_IRGRP | S_IWGRP))
    return {error(
        "permission",
        device + ": mode " + mode_text(file->mode) + " allows only its owner to use it",
        "unplug the robot and plug it in again; if that does not help: sudo chmod 660 " + device)};
  if (name == "root")
    return {
        error("permission", device + ": belongs to group " + name + ", which is not for users",
              "unplug the robot and plug it in again; if that does not help: sudo chgrp dialout " +
                  device)};
  const bool in_group =
      std::find(account.groups.begin(), account.groups.end(), file->gid) != account.groups.end();
  // With an access list, the mode's group bits are the list's mask, not the group's permissions.
  if (in_group)
    return {error(
        "permission",
        device + ": the kernel denies access to " + account.name + ", who is in group " + name,
        "look at its access list with getfacl " + device + "; sudo setfacl -b " + device +
            " removes it")};
  const bool member = group && std::find(group->members.begin(), group->members.end(),
                                         account.name) != group->members.end();
  if (member)
    return {error("group", account.name + " is in group " + name + ", but not in this session",
                  "log out and in again, or only here: newgrp " + name)};
  return {error("permission",
                device + ": " + account.name + " is not in group " + name + ", which may use it",
                "sudo adduser " + account.name + " " + name + ", then log out and in again")};
}

namespace {

namespace fs = std::filesystem;

bool runs(const System& system, const std::string& wanted) {
  const std::vector<std::string> processes = system.names("/proc");
  return std::any_of(processes.begin(), processes.end(), [&](const std::string& process) {
    return process.find_first_not_of("0123456789") == std::string::npos &&
           system.text("/proc/" + process + "/comm") == wanted;
  });
}

/// udev's record of the device with this folder in /sys.
std::string udev_record(const System& system, const std::string& sys, char kind) {
  const auto number = system.text(sys + "/dev");
  return number ? system.text("/run/udev/data/" + (kind + *number)).value_or("") : "";
}

bool ignored(const std::string& record) {
  return record.find("E:ID_MM_DEVICE_IGNORE=1") != std::string::npos ||
         record.find("E:ID_MM_PORT_IGNORE=1") != std::string::npos;
}

/// Whether a udev rule makes ModemManager ignore the port; it may be for the port or its USB
/// device.
bool left_alone(const System& system, const std::string& device) {
  fs::path at = system.real("/sys/class/tty/" + fs::path(device).filename().string());
  while (at.has_relative_path()) {
    if (ignored(udev_record(system, at, 'c'))) return true;
    at = at.parent_path();
  }
  return false;
}

std::string rule_for(const link::PortInfo& info) {
  return text::format(
      "SUBSYSTEM==\"tty\", ATTRS{idVendor}==\"%04x\", ATTRS{idProduct}==\"%04x\", "
      "ENV{ID_MM_PORT_IGNORE}=\"1\"",
      static_cast<unsigned>(info.vendor_id), static_cast<unsigned>(info.product_id));
}

}  // namespace

Findings modem_manager_findings(const System& system, const std::string& device,
                                const link::PortInfo& info) {
  if (!runs(system, "ModemManager")) return {ok("modem-manager", "does not run")};
  if (left_alone(system, device)) return {ok("modem-manager", "runs, but leaves the port alone")};
  if (info.vendor_id < 0 || info.product_id < 0)
    return {warning("modem-manager", "runs and may write to " + device,
                    "without a modem in this machine: sudo systemctl disable --now ModemManager")};
  return {
      warning("modem-manager", "runs and may write to " + device + " whenever it is plugged in",
              "echo '" + rule_for(info) +
                  "' | sudo tee /etc/udev/rules.d/70-tp100.rules && sudo udevadm control --reload, "
                  "then plug the robot in again")};
}

namespace {

namespace fs = std::filesystem;

// Vendor of the CH340 and CH341; its CH9102 is another design.
constexpr int kCh340Vendor = 0x1a86;
constexpr int kCh9102 = 0x55d4;

/// The folder in /sys of the USB device that the port belongs to.
std::optional<std::string> usb_device(const System& system, const std::string& tty) {
  fs::path at = system.real(tty);
  while (at.has_relative_path()) {
    if (system.exists(at.string() + "/idVendor")) return at.string();
    at = at.parent_path();
  }
  return std::nullopt;
}

std::string write_command(const std::string& value, const std::string& file) {
  return "echo " + value + " | sudo tee " + file;
}

void add_autosuspend(const System& system, const std::string& usb, Findings& findings) {
  const std::string file = usb + "/power/control";
  const auto control = system.text(file);
  if (!control) return;
  if (*control == "auto") {
    findings.push_back(warning("autosuspend",
                               "the robot's USB device may be put to sleep (" + file + " is auto)",
                               write_command("on", file)));
  } else {
    findings.push_back(ok("autosuspend", "off for the robot's USB device"));
  }
}

void add_latency_timer(const System& system, const std::string& tty, Findings& findings) {
  const std::string file = tty + "/device/latency_timer";
  const auto text = system.text(file);
  if (!text) return;
  int ms = 0;
  std::from_chars(text->data(), text->data() + text->size(), ms);
  if (ms > 1) {
    findings.push_back(warning("latency-timer", "the bridge delays bytes by up to " + *text + " ms",
                               write_command("1", file)));
  } else {
    findings.push_back(ok("latency-timer", *text + " ms"));
  }
}

}  // namespace

Findings port_findings(const System& system, const ChosenPort& port, bool open) {
  Findings findings = port.findings;
  if (port.device.empty()) return findings;
  append(findings,
         permission_findings(system, port.device, this_account(), system.usable(port.device)));
  if (open) {
    findings.push_back(ok("holder", port.device + ": this daemon has it open"));
  } else if (!port.pseudo_terminal) {
    append(findings, holder_findings(system, port.device));
  }
  if (!port.pseudo_terminal)
    append(findings, modem_manager_findings(system, port.device, port.info));
  return findings;
}

Findings usb_findings(const System& system, const std::string& device, const link::PortInfo& info) {
  Findings findings;
  const std::string tty = "/sys/class/tty/" + fs::path(device).filename().string();
  const auto usb = usb_device(system, tty);
  if (!usb) return findings;
  add_autosuspend(system, *usb, findings);
  add_latency_timer(system, tty, findings);
  if (info.vendor_id == kCh340Vendor && info.product_id != kCh9102)
    findings.push_back({Severity::kNote, "bridge",
                        link::describe(info) + ": some of them lose bytes at 500000 baud",
                        "if the link test counts corrupted frames, use a short cable without a hub "
                        "or another Mega"});
  return findings;
}

}  // namespace tp100::doctor
