#pragma once
// The thread that owns the sockets: it accepts, reads requests and frames, writes answers and
// frames, and carries out STOP. It does nothing whose time grows with a request or an answer: that
// is the worker's. So nothing that a viewer asks for delays another one's STOP.

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "core/worker.h"
#include "messages/figures.h"
#include "server/local_daemons.h"
#include "server/shared_state.h"

namespace tp100::server {

/// Runs the handlers of `context` until it is stopped, and `after` after each. Nothing that one
/// throws ends the program: `failed` gets it, as of a job of Worker.
void run_handlers(boost::asio::io_context& context, const Worker::Failed& failed,
                  const std::function<void()>& after);

class Sockets {
 public:
  /// Called once a second by the sockets' thread, with all but the viewers' subscriptions.
  using Report = std::function<void(messages::ClientsFigures)>;

  /// Listens; serves nothing before start(). Throws UserError if the address is not available.
  /// `work` is the worker's; it and all others must outlive this object. `failed`: as of
  /// run_handlers(), called by the sockets' thread.
  Sockets(ServerSettings settings, Controls& controls, boost::asio::io_context& work,
          Broker& broker, RequestHandler& handler, HttpSources& sources, std::string session,
          Report report, Worker::Failed failed);

  /// As in Server.
  const std::string& url() const { return url_; }
  const std::string& note() const { return note_; }
  /// How other daemons of this machine find this one.
  const LocalDaemon& own() const { return own_; }

  void start();
  /// Closes every connection, waiting half a second at most, and ends the thread.
  void stop();
  /// Whether a client's request still waits for the disk.
  bool waits_for_disk() { return !disk_.idle_by(std::chrono::steady_clock::now()); }

 private:
  void listen();
  bool try_listen(const boost::asio::ip::tcp::endpoint& end, boost::system::error_code& error);
  void accept();
  void rest();
  void tick();
  void begin_goodbyes();
  void await_goodbyes();

  SharedState shared_;
  Report report_;
  Worker::Failed failed_;
  LocalDaemon own_;
  std::string url_, note_;
  std::optional<Announcement> announcement_;
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
  Worker disk_{"page files", SharedState::kMaxConnections};  // its jobs post to the context
  std::thread thread_;
};

}  // namespace tp100::server
