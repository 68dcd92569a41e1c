#pragma once
// One accepted TCP connection: HTTP requests until it becomes a viewer or ends.

#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "record/worker.h"
#include "server/access.h"
#include "server/desk.h"
#include "server/http_content.h"
#include "server/server.h"

namespace tp100::server {

class ViewerSocket;

/// What connections share. One thread.
struct ServerRoom {
  ServerSettings settings;
  Hub& hub;
  Feed& feed;
  Desk& desk;
  record::Worker& disk;  ///< for answers that need it; the thread of the room waits for none
  HttpSources sources{};
  std::map<std::uint32_t, std::weak_ptr<ViewerSocket>> viewers{};  // by id
  std::uint32_t last_id = 0;
  std::size_t sockets = 0;      // viewers, those included that come or go
  std::size_t connections = 0;  // HTTP ones
  std::uint64_t refused = 0, closed = 0, dropped_by_closed = 0;
};

/// HTTP connections at once, besides the viewers; more are closed as they come.
inline constexpr std::size_t kMaxConnections = 64;
/// Of these, and of the viewers, so many are kept for programs of this machine: idle strangers must
/// not keep the operator's page away.
inline constexpr std::size_t kKeptForLocal = 4;

/// `address`, as IPv4 if it is one in IPv6's clothes.
boost::asio::ip::address plain(const boost::asio::ip::address& address);
/// Whether the peer is a program of this machine.
bool is_local(const boost::asio::ip::tcp::socket& socket);

/// Serves `socket` until it ends.
void serve_connection(boost::asio::ip::tcp::socket socket, ServerRoom& room);

}  // namespace tp100::server
