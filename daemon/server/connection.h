#pragma once
// One accepted TCP connection, in the sockets' thread: HTTP requests, which others answer, until it
// becomes a viewer or ends.

#include <boost/asio/io_context.hpp>
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

/// What connections share: the sockets' thread's, except for what is marked.
struct SharedState {
  ServerSettings settings;
  Controls& controls;                ///< only STOP
  boost::asio::io_context& context;  ///< the sockets' thread
  boost::asio::io_context& work;     ///< the worker, whose are broker, handler and most sources
  Broker& broker;
  RequestHandler& handler;
  HttpSources& sources;
  record::Worker& disk;  ///< makes the answers that need it; no other thread waits for a disk
  // A flood of one kind leaves the other alone.
  Budgets viewer_budgets{settings.units_per_s}, http_budgets{settings.units_per_s};
  std::map<std::uint32_t, std::weak_ptr<ViewerSocket>> viewers{};  // by id
  std::uint32_t last_id = 0;
  std::size_t sockets = 0;      // viewers, including those connecting or leaving
  std::size_t connections = 0;  // HTTP connections
  std::size_t body_bytes = 0;   // of answers in memory that are being written
  std::uint64_t refused = 0, closed = 0, dropped_by_closed = 0;
};

/// Limit of SharedState::body_bytes.
inline constexpr std::size_t kMaxBodyBytes = 48 << 20;
/// Most HTTP connections at once, besides the viewers; further ones are closed on accept.
inline constexpr std::size_t kMaxConnections = 64;
/// Share of these, and of the viewers, reserved for programs of this machine: idle remote clients
/// must not lock out the operator's page.
inline constexpr std::size_t kKeptForLocal = 4;

/// `address`, with an IPv4-mapped IPv6 address converted to IPv4.
boost::asio::ip::address plain(const boost::asio::ip::address& address);
/// Whose budget the peer's is, see Budgets.
std::string budget_name(const boost::asio::ip::tcp::socket& socket);
/// Whether the peer is a program of this machine.
bool is_local(const boost::asio::ip::tcp::socket& socket);

/// Serves `socket` until it ends.
void serve_connection(boost::asio::ip::tcp::socket socket, SharedState& shared);

}  // namespace tp100::server
