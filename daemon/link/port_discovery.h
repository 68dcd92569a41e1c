#pragma once
// Which serial ports there are, and which of them may be a TP100. Set-up only.

#include <compare>
#include <string>
#include <vector>

namespace tp100::link {

/// One serial port of the system.
struct PortInfo {
  std::string path;    ///< e.g. /dev/ttyACM0
  int vendor_id = -1;  ///< USB ids; -1 unknown
  int product_id = -1;
  std::string serial;  ///< empty if unknown
  std::string manufacturer;
  std::string product;
};

/// What the USB ids say about a port.
enum class PortKind {
  kMega,    ///< an Arduino Mega 2560
  kBridge,  ///< some USB serial bridge, as on Mega clones
  kOther,   ///< anything else
};

/// What a USB device says it is.
struct UsbId {
  int vendor_id;
  int product_id;

  auto operator<=>(const UsbId&) const = default;
};
/// All that are not kOther, most likely first.
std::vector<UsbId> known_ids();

PortKind classify(const PortInfo& port);
/// One word or two for people: "Arduino Mega 2560", "CH340 bridge", ...
std::string describe(const PortInfo& port);

/// Ports that may be a TP100, most likely first, stable by path; others are left out. The handshake
/// decides.
std::vector<PortInfo> candidates(std::vector<PortInfo> ports);

/// All serial ports, as libserialport lists them; ptys are never among them. Throws SetupError.
std::vector<PortInfo> list_ports();

}  // namespace tp100::link
