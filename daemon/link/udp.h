#pragma once
// UDP addresses as written in options and files, and the sending end of a one-way stream.

#include <netinet/in.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "core/descriptor.h"

namespace tp100::link {

/// Address that datagrams are sent to or received on. IPv4.
struct UdpAddress {
  std::string host = "127.0.0.1";  ///< a number or a name
  std::uint16_t port = 0;
};

/// Reads "udp:[HOST:]PORT"; without a host: loopback. `where` begins the message of a UserError.
UdpAddress parse_udp(std::string_view text, const std::string& where);
/// Formats an address: "127.0.0.1:47100".
std::string to_string(const UdpAddress& address);
/// Looks the host up. Throws UserError; may block.
sockaddr_in resolve(const UdpAddress& address);

/// Sends datagrams and never waits: there may be no receiver.
class UdpSender {
 public:
  /// Throws UserError.
  explicit UdpSender(const UdpAddress& to);

  /// False: the system did not accept the datagram.
  bool send(std::string_view datagram);

 private:
  Descriptor socket_;
};

/// Name of this machine's monotonic clock (camera_message.h): its boot id. If that is unknown:
/// "unknown-clock" and the process id.
std::string monotonic_clock_name();

}  // namespace tp100::link
