#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/commands.h"
#include "doctor/hello.h"
#include "doctor/port_checks.h"
#include "doctor/system.h"
#include "text/command_line.h"
#include "text/format.h"

namespace tp100::app {
namespace {

std::string usb_id(const link::PortInfo& port) {
  if (port.vendor_id < 0 || port.product_id < 0) return "-";
  return text::format("%04x:%04x", static_cast<unsigned>(port.vendor_id),
                      static_cast<unsigned>(port.product_id));
}

}  // namespace

std::string ports_text(const std::vector<link::PortInfo>& ports,
                       const std::vector<std::string>& stable_names,
                       const std::vector<link::PassedOver>& passed_over) {
  if (ports.empty()) {
    return "no serial ports; plug the robot in (an emulated robot's port is the path that its "
           "--link names)\n";
  }
  std::string text;
  for (std::size_t i = 0; i < ports.size(); ++i) {
    const link::PortInfo& port = ports[i];
    text += port.path + "  " + usb_id(port) + "  " + link::describe(port);
    if (!port.serial.empty()) text += ", serial " + port.serial;
    if (link::classify(port) != link::PortKind::kOther) {
      text += "\n    port = \"" + (stable_names[i].empty() ? port.path : stable_names[i]) + "\"";
    }
    text += "\n";
    for (const link::PassedOver& each : passed_over) {
      if (each.port.path == port.path)
        text += "    auto skips it: " + each.why +
                "; if it is the robot, name it with --port or link.port\n";
    }
  }
  return text;
}

namespace {

int run_ports() {
  const std::vector<link::PortInfo> all = link::list_ports();
  std::vector<link::PortInfo> ports = link::candidates(all);
  for (const link::PortInfo& port : all) {
    if (link::classify(port) == link::PortKind::kOther) ports.push_back(port);
  }
  std::vector<std::string> names;
  names.reserve(ports.size());
  for (const link::PortInfo& port : ports)
    names.push_back(doctor::stable_name(doctor::System{}, port.path));
  const link::AutoChoice choice =
      link::choose_for_auto(all, [](const std::string& path) { return link::port_holder(path); });
  std::fputs(ports_text(ports, names, choice.passed_over).c_str(), stdout);
  return 0;
}

}  // namespace

void add_ports(CLI::App& app, Action& action) {
  static doctor::HelloOptions hello;
  CLI::App* command = app.add_subcommand("ports", "List serial ports, likely robots first");
  text::option(command, "--hello", hello.port, "DEVICE",
               "Wait for the firmware on this port and print its version");
  command->add_option("--timeout", hello.timeout_s, "How long to wait for it [s]")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  command->footer("Example: tp100d ports --hello /dev/ttyACM0");
  command->callback([&action] {
    action = [] { return hello.port.empty() ? run_ports() : doctor::run_hello(hello); };
  });
}

}  // namespace tp100::app
