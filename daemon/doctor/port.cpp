#include "doctor/port.h"

#include <algorithm>

#include "link/port_holder.h"
#include "link/transport.h"

namespace tp100::doctor {
namespace {

constexpr const char* kById = "/dev/serial/by-id";

ChosenPort missing(std::string seen, std::string fix) {
  ChosenPort none;
  none.findings = {{Severity::kError, "device", std::move(seen), std::move(fix)}};
  return none;
}

void add_stable_name(const System& system, ChosenPort& port, std::size_t candidates) {
  const std::string stable = stable_name(system, port.device);
  if (stable.empty()) {
    port.findings.push_back(
        {Severity::kNote, "by-id", port.device + ": no name in " + kById + " leads to it",
         "with several boards, name it in link.port after each plugging in: see tp100d ports"});
  } else if (candidates > 1 && port.path != stable) {
    port.findings.push_back({Severity::kWarning, "by-id",
                             std::to_string(candidates) + " boards may be the robot, " +
                                 port.device + " is only the likeliest",
                             "set link.port = \"" + stable + "\" in the configuration"});
  } else {
    port.findings.push_back(ok("by-id", stable));
  }
}

}  // namespace

ChosenPort choose_port(const System& system, const std::string& port,
                       const std::vector<link::PortInfo>& ports) {
  const std::vector<link::PortInfo> likely = link::candidates(ports);
  ChosenPort chosen;
  chosen.path = port;
  if (port == "auto") {
    const link::AutoChoice choice = link::choose_for_auto(
        ports, true,
        [&](const std::string& path) { return link::port_holder(path, system.file("/proc")); });
    if (choice.open.empty()) {
      const std::string why = link::why_none(choice);
      const std::size_t end = why.rfind("; ");
      return missing(why.substr(0, end), why.substr(end + 2));
    }
    chosen.path = choice.open.front().path;
  }
  chosen.device = system.real(chosen.path);
  if (chosen.device.empty())
    return missing(chosen.path + ": no such port",
                   "plug the robot in, or name another port with --port (see tp100d ports)");
  if (const auto file = system.device(chosen.device))
    chosen.pseudo_terminal = link::is_pseudo_terminal(file->mode, file->number);
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
    return {
        {Severity::kError, "holder", device + ": held open by " + holder.name,
         "end that program (a service: `sudo systemctl stop 'tp100d@*'`), or choose another port "
         "with --port"}};
  return {ok("holder", device + ": no other program " +
                           (holder.others_hidden ? "of this account " : "") + "has it open")};
}

}  // namespace tp100::doctor
