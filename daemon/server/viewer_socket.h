#pragma once
// One WebSocket client, in the sockets' thread: carries out its STOP, passes its other messages on
// to the server thread, writes the frames of its outbox, and disconnects it when it misbehaves.

#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/basic_stream.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/rate_policy.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <memory>
#include <string>

#include "server/access.h"
#include "server/link_window.h"
#include "server/sockets.h"

namespace tp100::server {

class ViewerSocket : public std::enable_shared_from_this<ViewerSocket> {
 public:
  /// Limits a client's receive rate, whatever its frames contain.
  using Stream = boost::beast::basic_stream<boost::asio::ip::tcp, boost::asio::any_io_executor,
                                            boost::beast::simple_rate_policy>;
  using Request = boost::beast::http::request<boost::beast::http::empty_body>;

  ViewerSocket(Stream::socket_type socket, const Peer& peer, SharedState& shared,
               Permission permission);
  ~ViewerSocket() { --shared_.sockets; }
  /// Accepts the upgrade with this sub-protocol and lives until the client is gone.
  void accept(const Request& request, std::string_view sub_protocol);

  /// Call it once a second: sends the status that is due, and disconnects clients that do not read.
  void tick(HostNs now);
  /// Without its subscriptions, which are the server thread's.
  messages::ClientFigures figures(HostNs now) const;
  /// The server is ending.
  void go_away();

 private:
  using Code = boost::beast::websocket::close_code;

  void opened();
  void read();
  void take();
  void read_later();
  void stop(std::uint32_t call, HostNs now);
  void pass_on(std::string message, bool text, HostNs now);
  bool within_budget(std::size_t bytes, HostNs now);
  void malformed();
  void flush();
  void ping();
  /// Disconnects without a closing handshake. Only touches the socket: the rest follows in gone().
  void fail();
  void close(Code code, const char* reason);
  void gone();

  boost::beast::websocket::stream<Stream> socket_;
  SharedState& shared_;
  const Permission permission_;
  messages::ClientFigures figures_{};
  boost::beast::flat_buffer buffer_;
  std::shared_ptr<Viewer> viewer_;
  WebSocketFrame writing_{};
  LinkWindow window_;
  bool busy_ = false;  // a write is under way
  bool open_ = false;
  bool closing_ = false;
  bool failed_ = false;
  int seconds_not_open_ = 0;
  HostNs connected_ns_ = 0;
  HostNs write_began_ns_ = 0;
  std::uint64_t reported_dropped_ = 0;
  int malformed_ = 0;
  std::shared_ptr<Budget> budget_;  // of its address
  Budget own_{Budgets::kOwnPerS};
  Budget stops_left_;
  boost::asio::steady_timer pause_;
  // Reports of STOP that are on their way to the server thread, which may be gone after this.
  std::shared_ptr<std::atomic<int>> stops_ = std::make_shared<std::atomic<int>>(0);
};

/// Serves an accepted connection until it ends: HTTP requests, which others answer, until it
/// becomes a viewer.
void serve_connection(boost::asio::ip::tcp::socket socket, SharedState& shared);

}  // namespace tp100::server
