#pragma once
// The thread that owns the sockets: it accepts, reads requests and frames, writes answers and
// frames, and carries out STOP. It does nothing whose time grows with a request or an answer: that
// is the server thread's. So nothing that a viewer asks for delays another one's STOP.

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>

#include "core/descriptor.h"
#include "core/worker.h"
#include "messages/figures.h"
#include "server/access.h"
#include "server/broker.h"
#include "server/controls.h"
#include "server/http_content.h"
#include "server/local_daemons.h"
#include "server/server.h"

namespace tp100::server {

class Publisher;
class RequestHandler;
class ViewerSocket;

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
  boost::asio::io_context&
      server_context;  ///< the server thread, whose are broker, handler and most sources
  Broker& broker;
  RequestHandler& handler;
  HttpSources& sources;
  Worker& page_files;  ///< makes the answers that need it; no other thread waits for a disk
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

/// Runs the handlers of `context` until it is stopped, and `after` after each. Nothing that one
/// throws ends the program: `failed` gets it, as of a job of Worker.
void run_handlers(boost::asio::io_context& context, const Worker::Failed& failed,
                  const std::function<void()>& after);

class Sockets {
 public:
  /// Listens; serves nothing before start(). Throws UserError if the address is not available.
  /// `server_context` is the server thread's, in which `publisher` gets the clients' figures once a
  /// second, and what handlers throw; it and all others must outlive this object.
  Sockets(ServerSettings settings, Controls& controls, boost::asio::io_context& server_context,
          Broker& broker, Publisher& publisher, RequestHandler& handler, HttpSources& sources,
          std::string session);

  /// As in Server.
  const std::string& url() const { return url_; }
  const std::string& note() const { return note_; }
  /// How other daemons of this machine find this one.
  const LocalDaemon& own() const { return own_; }

  void start();
  /// Closes every connection, waiting half a second at most, and ends the thread.
  void stop();
  bool waits_for_disk() { return !page_files_.idle_by(std::chrono::steady_clock::now()); }

 private:
  void listen();
  bool try_listen(const boost::asio::ip::tcp::endpoint& end, boost::system::error_code& error);
  void accept();
  void rest();
  void tick();
  void begin_goodbyes();
  void await_goodbyes();

  SharedState shared_;
  Publisher& publisher_;  // the server thread's
  LocalDaemon own_;
  std::string url_, note_;
  Descriptor announcement_;
  HostNs stop_by_ns_ = 0;
  bool stopping_ = false;
  HostNs at_ns_ = 0, used_ns_ = 0, credit_ns_ = 0;  // of the thread's use of a processor
  // Declared after what its handlers refer to.
  boost::asio::io_context context_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> guard_{
      context_.get_executor()};
  boost::asio::ip::tcp::acceptor acceptor_{context_};
  boost::asio::steady_timer timer_{context_};
  boost::asio::steady_timer pause_{context_};
  Worker page_files_{"page files", SharedState::kMaxConnections};  // its jobs post to the context
  std::thread thread_;
};

}  // namespace tp100::server
