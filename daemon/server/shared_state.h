#pragma once
// What the parts of the server are told and have in common: its settings, and the state that its
// connections share.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "server/access.h"
#include "server/broker.h"
#include "server/controls.h"
#include "server/http_content.h"

namespace boost::asio {
class io_context;
}
namespace tp100 {
class Worker;
}

namespace tp100::server {

class RequestHandler;
class ViewerSocket;

struct ServerSettings {
  /// HOST:PORT, with port 0 for any free one; "auto": 127.0.0.1:8765, or any free port of that
  /// address if that one is in use; "off": serves only `listener`.
  std::string listen = "auto";
  AccessRules access{};
  config::CommandsFrom commands = config::CommandsFrom::kLocal;
  std::size_t max_clients = 64;
  double units_per_s = Budgets::kUnitsPerS;  ///< of viewers, and of HTTP requests of an address
  std::string name{};                        ///< of the robot, for people
  /// Pages of other robots, besides those found on this machine.
  std::vector<std::string> robots{};
  HttpSources content{};             ///< the server itself adds health, robots and history
  std::vector<ServiceRow> services;  ///< besides those of motion
  bool real_time = false;            ///< the sockets' thread has loop::kBelowTheLoop, if permitted
  Listener listener;  ///< called from the constructor and the worker's thread; must not block
};

/// What connections share: the sockets' thread's, except for what is marked.
struct SharedState {
  /// Limit of body_bytes.
  static constexpr std::size_t kMaxBodyBytes = 48 << 20;
  /// Most HTTP connections at once, besides the viewers; further ones are closed on accept.
  static constexpr std::size_t kMaxConnections = 64;
  /// Share of these, and of the viewers, reserved for programs of this machine: idle remote clients
  /// must not lock out the operator's page.
  static constexpr std::size_t kKeptForLocal = 4;

  ServerSettings settings;
  Controls& controls;                ///< only STOP
  boost::asio::io_context& context;  ///< the sockets' thread
  boost::asio::io_context& work;     ///< the worker, whose are broker, handler and most sources
  Broker& broker;
  RequestHandler& handler;
  HttpSources& sources;
  Worker& disk;  ///< makes the answers that need it; no other thread waits for a disk
  // A flood of one kind leaves the other alone.
  Budgets viewer_budgets{settings.units_per_s}, http_budgets{settings.units_per_s};
  std::map<std::uint32_t, std::weak_ptr<ViewerSocket>> viewers{};  // by id
  std::uint32_t last_id = 0;
  std::size_t sockets = 0;             // viewers, including those connecting or leaving
  std::size_t connections = 0;         // HTTP connections
  std::size_t body_bytes = 0;          // of answers in memory that are being written
  messages::ClientsFigures figures{};  // totals, of clients that are gone
};

/// The other end of a connection.
struct Peer {
  std::string address;  ///< with its port
  std::string network;  ///< whose budget it has, see Budgets
  bool local = false;   ///< a program of this machine
};

}  // namespace tp100::server
