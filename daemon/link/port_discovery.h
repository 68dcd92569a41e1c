#pragma once
// Lists the serial ports and finds those that may be a TP100. Set-up only.

#include <functional>
#include <optional>
#include <span>
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
  std::string product;
};

/// Kind of a port, by its USB ids.
enum class PortKind {
  kMega,    ///< an Arduino Mega 2560
  kBridge,  ///< some USB serial bridge, as on Mega clones
  kOther,   ///< anything else
};

/// A USB device that may be a TP100's board.
struct KnownPort {
  int vendor_id;
  int product_id;
  PortKind kind;
  const char* name;
};
/// All of them, most likely first.
std::span<const KnownPort> known_ports();

PortKind classify(const PortInfo& port);
/// A short description for people: "Arduino Mega 2560", "CH340 bridge", ...
std::string describe(const PortInfo& port);

/// Ports that may be a TP100, most likely first, then by path; others are left out. Only the
/// handshake tells which is one.
std::vector<PortInfo> candidates(std::vector<PortInfo> ports);

/// A port that may be a TP100 and that `auto` does not open.
struct PassedOver {
  PortInfo port;
  std::string why;  ///< without the port's name
};

/// The port that `auto` may open. Any other port may be somebody else's machine, which opening
/// would reset and set to our speed.
struct AutoChoice {
  std::optional<PortInfo> open;
  std::vector<PassedOver> passed_over;
};

using HolderOf = std::function<PortHolder(const std::string& path)>;

/// Chooses the only candidate: a Mega that no visible process has open, or a bridge that certainly
/// no process has open. Of several it chooses none: only a person knows which is the robot.
AutoChoice choose_for_auto(const std::vector<PortInfo>& ports, const HolderOf& holder_of);
/// Why nothing was chosen and what to do, in one line.
std::string why_none(const AutoChoice& choice);

/// All serial ports, as libserialport lists them; ptys are never among them. Throws UserError.
std::vector<PortInfo> list_ports();

}  // namespace tp100::link
