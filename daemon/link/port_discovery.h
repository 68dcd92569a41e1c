#pragma once
// Which serial ports there are, and which of them may be a TP100. Set-up only.

#include <compare>
#include <functional>
#include <string>
#include <vector>

#include "link/port_holder.h"

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

/// A port that `auto` does not open.
struct PassedOver {
  PortInfo port;
  std::string why;  ///< without the port's name
};

/// What `auto` may open: whatever else is there may be somebody else's machine, which an opening
/// would reset and set to our speed.
struct AutoChoice {
  std::vector<PortInfo> open;  ///< in turn
  std::vector<PassedOver> passed_over;
};

using HolderOf = std::function<PortHolder(const std::string& path)>;

/// A Mega that nobody is seen to have open; or a bridge, if it is the only candidate and surely
/// nobody has it open. `attended`: somebody is there who sees which one is taken of several.
AutoChoice choose_for_auto(const std::vector<PortInfo>& ports, bool attended,
                           const HolderOf& holder_of);
/// Why nothing was chosen and what to do, in one line.
std::string why_none(const AutoChoice& choice);

/// All serial ports, as libserialport lists them; ptys are never among them. Throws SetupError.
std::vector<PortInfo> list_ports();

}  // namespace tp100::link
