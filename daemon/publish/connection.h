#pragma once
// One accepted TCP connection: HTTP requests until it becomes a viewer or ends.

#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "publish/access.h"
#include "publish/desk.h"
#include "publish/http_content.h"
#include "publish/server.h"

namespace tp100::publish {

class ViewerSocket;

/// What connections share. One thread.
struct ServerRoom {
  ServerSettings settings;
  Hub& hub;
  Feed& feed;
  Desk& desk;
  HttpSources sources{};
  std::map<std::uint32_t, std::weak_ptr<ViewerSocket>> viewers{};  // by id
  std::uint32_t last_id = 0;
  std::size_t sockets = 0;      // viewers, those included that come or go
  std::size_t connections = 0;  // HTTP ones
  std::uint64_t refused = 0, closed = 0, dropped_by_closed = 0;
};

/// HTTP connections at once, besides the viewers; more are closed as they come.
inline constexpr std::size_t kMaxConnections = 64;

/// Serves `socket` until it ends.
void serve_connection(boost::asio::ip::tcp::socket socket, ServerRoom& room);

}  // namespace tp100::publish
