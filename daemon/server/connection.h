#pragma once
// One accepted TCP connection: HTTP requests until it becomes a viewer or ends.

#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "record/worker.h"
#include "server/access.h"
#include "server/http_content.h"
#include "server/request_handler.h"
#include "server/server.h"

namespace tp100::server {

class ViewerSocket;

/// What connections share. One thread.
struct SharedState {
  ServerSettings settings;
  Broker& broker;
  Publisher& publisher;
  RequestHandler& handler;
  record::Worker& disk;  ///< for answers that need it; the server's thread never waits for a disk
  HttpSources sources{};
  std::map<std::uint32_t, std::weak_ptr<ViewerSocket>> viewers{};  // by id
  std::uint32_t last_id = 0;
  std::size_t sockets = 0;      // viewers, including those connecting or leaving
  std::size_t connections = 0;  // HTTP connections
  std::uint64_t refused = 0, closed = 0, dropped_by_closed = 0;
};

/// Most HTTP connections at once, besides the viewers; further ones are closed on accept.
inline constexpr std::size_t kMaxConnections = 64;
/// Share of these, and of the viewers, reserved for programs of this machine: idle remote clients
/// must not lock out the operator's page.
inline constexpr std::size_t kKeptForLocal = 4;

/// `address`, with an IPv4-mapped IPv6 address converted to IPv4.
boost::asio::ip::address plain(const boost::asio::ip::address& address);
/// Whether the peer is a program of this machine.
bool is_local(const boost::asio::ip::tcp::socket& socket);

/// Serves `socket` until it ends.
void serve_connection(boost::asio::ip::tcp::socket socket, SharedState& shared);

}  // namespace tp100::server
