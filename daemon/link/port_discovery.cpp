#include "link/port_discovery.h"

#include <libserialport.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "core/error.h"

namespace tp100::link {
namespace {

// The same ids as in the rules of config/udev.
constexpr auto kKnown = std::to_array<KnownPort>({
    {0x2341, 0x0042, PortKind::kMega, "Arduino Mega 2560"},
    {0x2341, 0x0010, PortKind::kMega, "Arduino Mega 2560"},
    {0x2341, 0x0210, PortKind::kMega, "Arduino Mega 2560"},
    {0x2341, 0x0242, PortKind::kMega, "Arduino Mega 2560"},
    {0x2a03, 0x0010, PortKind::kMega, "Arduino Mega 2560"},
    {0x2a03, 0x0042, PortKind::kMega, "Arduino Mega 2560"},
    {0x1a86, 0x7523, PortKind::kBridge, "CH340 bridge"},
    {0x1a86, 0x5523, PortKind::kBridge, "CH341 bridge"},
    {0x1a86, 0x55d4, PortKind::kBridge, "CH9102 bridge"},
    {0x0403, 0x6001, PortKind::kBridge, "FTDI bridge"},
    {0x0403, 0x6015, PortKind::kBridge, "FTDI bridge"},
    {0x10c4, 0xea60, PortKind::kBridge, "CP210x bridge"},
    {0x067b, 0x2303, PortKind::kBridge, "PL2303 bridge"},
});

std::size_t rank(const PortInfo& port) {
  const auto at = std::find_if(kKnown.begin(), kKnown.end(), [&](const KnownPort& known) {
    return known.vendor_id == port.vendor_id && known.product_id == port.product_id;
  });
  return static_cast<std::size_t>(at - kKnown.begin());
}

std::string text(const char* value) { return value == nullptr ? "" : value; }

}  // namespace

PortKind classify(const PortInfo& port) {
  const std::size_t at = rank(port);
  return at < kKnown.size() ? kKnown[at].kind : PortKind::kOther;
}

std::string describe(const PortInfo& port) {
  const std::size_t at = rank(port);
  if (at < kKnown.size()) return kKnown[at].name;
  return port.product.empty() ? "serial port" : port.product;
}

std::span<const KnownPort> known_ports() { return kKnown; }

std::vector<PortInfo> candidates(std::vector<PortInfo> ports) {
  std::erase_if(ports, [](const PortInfo& port) { return classify(port) == PortKind::kOther; });
  std::sort(ports.begin(), ports.end(), [](const PortInfo& a, const PortInfo& b) {
    return rank(a) != rank(b) ? rank(a) < rank(b) : a.path < b.path;
  });
  return ports;
}

AutoChoice choose_for_auto(const std::vector<PortInfo>& ports, const HolderOf& holder_of) {
  const std::vector<PortInfo> likely = candidates(ports);
  const auto why_not = [&](const PortInfo& port) -> std::string {
    const PortHolder holder = holder_of(port.path);
    if (!holder.name.empty()) return "held open by " + holder.name;
    if (likely.size() > 1) return "not the only candidate (" + describe(port) + ")";
    if (classify(port) != PortKind::kMega && holder.others_hidden)
      return "this account cannot see whether another program has it open (" + describe(port) + ")";
    return {};
  };
  AutoChoice choice;
  for (const PortInfo& port : likely) {
    if (std::string why = why_not(port); why.empty()) {
      choice.open = port;
    } else {
      choice.passed_over.push_back({port, std::move(why)});
    }
  }
  return choice;
}

std::string why_none(const AutoChoice& choice) {
  if (choice.passed_over.empty())
    return "no USB port that may be a TP100; plug the robot in, or name its port with --port (see "
           "`tp100d ports`)";
  std::string line = "auto skips ";
  for (const PassedOver& each : choice.passed_over) {
    if (&each != &choice.passed_over.front()) line += "; ";
    line += each.port.path + ": " + each.why;
  }
  return line + "; if it is the robot, name it with --port or link.port (see `tp100d ports`)";
}

std::vector<PortInfo> list_ports() {
  sp_port** raw = nullptr;
  if (sp_list_ports(&raw) != SP_OK) {
    throw UserError("the serial ports cannot be listed; check that /sys is mounted");
  }
  const std::unique_ptr<sp_port*, decltype(&sp_free_port_list)> list(raw, &sp_free_port_list);
  std::vector<PortInfo> ports;
  for (sp_port** at = raw; *at != nullptr; ++at) {
    PortInfo info;
    info.path = text(sp_get_port_name(*at));
    if (sp_get_port_usb_vid_pid(*at, &info.vendor_id, &info.product_id) != SP_OK) {
      info.vendor_id = info.product_id = -1;
    }
    info.serial = text(sp_get_port_usb_serial(*at));
    info.product = text(sp_get_port_usb_product(*at));
    ports.push_back(info);
  }
  return ports;
}

}  // namespace tp100::link
