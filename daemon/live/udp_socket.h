#pragma once
// What the ports that listen for datagrams share. Brings Asio in: for source files.

// Asio 1.74 uses std::exchange without including it.
#include <utility>
// clang-format off
#include <boost/asio/ip/udp.hpp>
// clang-format on

#include "link/udp.h"

namespace tp100::live {

/// Throws SetupError: no such host.
inline boost::asio::ip::udp::endpoint endpoint_of(const link::UdpAddress& address) {
  const sockaddr_in resolved = link::resolve(address);
  return {boost::asio::ip::address_v4(ntohl(resolved.sin_addr.s_addr)), address.port};
}

/// Opens `socket` to hear what comes to `local`, without waiting for it.
inline boost::system::error_code listen_at(boost::asio::ip::udp::socket& socket,
                                           const boost::asio::ip::udp::endpoint& local) {
  boost::system::error_code error;
  socket.open(boost::asio::ip::udp::v4(), error);
  if (!error) socket.bind(local, error);
  if (!error) socket.non_blocking(true, error);
  return error;
}

}  // namespace tp100::live
