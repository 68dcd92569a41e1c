#include "server/viewer_socket.h"

#include <boost/asio/post.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <utility>

#include "core/clock.h"
#include "server/request_handler.h"

namespace tp100::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;

constexpr std::size_t kMaxMessage = 65'536;
constexpr int kMaxStops = 16;  // waiting to be reported
// Of one client; it is never refused, but its next one is then read a little later.
constexpr double kStopsPerS = 100.0;
constexpr auto kStopPause = std::chrono::milliseconds(10);
constexpr std::size_t kReadLimit = 524'288;  // bytes per second
constexpr int kMaxMalformed = 20;
constexpr int kMaxSecondsNotOpen = 2;
constexpr HostNs kWriteLimitNs = 10 * kNsPerS;
constexpr int kSendBuffer = 256 * 1024;  // the kernel's send buffer: data waiting there goes stale
constexpr std::size_t kMaxAgent = 120;
constexpr beast::string_view kMark = "received so far";  // of pings that measure the link

}  // namespace

ViewerSocket::ViewerSocket(Stream::socket_type socket, const Peer& peer, SharedState& shared,
                           Permission permission)
    : socket_(std::move(socket)),
      shared_(shared),
      permission_(permission),
      buffer_(kMaxMessage),
      budget_(shared.viewer_budgets.of(peer.network)),
      stops_left_(kStopsPerS),
      pause_(shared.context) {
  figures_.address = peer.address;
  ++shared_.sockets;
}

void ViewerSocket::accept(const Request& request, std::string_view sub_protocol) {
  figures_.agent = std::string(request[beast::http::field::user_agent]).substr(0, kMaxAgent);
  boost::system::error_code ignored;
  auto& tcp = socket_.next_layer().socket();
  tcp.set_option(asio::socket_base::send_buffer_size(kSendBuffer), ignored);
  tcp.set_option(asio::ip::tcp::no_delay(true), ignored);
  socket_.next_layer().rate_policy().read_limit(kReadLimit);
  socket_.set_option(
      websocket::stream_base::timeout{std::chrono::seconds(5), std::chrono::seconds(20), true});
  socket_.set_option(
      websocket::stream_base::decorator([sub_protocol](websocket::response_type& response) {
        response.set(beast::http::field::sec_websocket_protocol,
                     beast::string_view(sub_protocol.data(), sub_protocol.size()));
      }));
  // Fast: a message is like the one before it.
  websocket::permessage_deflate deflate;
  deflate.server_enable = true;
  deflate.compLevel = 1;
  socket_.set_option(deflate);
  socket_.control_callback([this](websocket::frame_type kind, beast::string_view content) {
    if (kind != websocket::frame_type::pong || content != kMark) return;
    window_.pong(monotonic_now());
    flush();
  });
  socket_.read_message_max(kMaxMessage);
  socket_.auto_fragment(false);
  socket_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
    if (error) return self->gone();
    self->opened();
  });
}

void ViewerSocket::opened() {
  connected_ns_ = monotonic_now();
  open_ = true;
  // The server thread never holds a socket: it would be closed in the wrong thread.
  const auto later = [this](void (ViewerSocket::*what)()) {
    return [&context = shared_.context, weak = weak_from_this(), what] {
      asio::post(context, [weak, what] {
        if (const auto self = weak.lock()) (self.get()->*what)();
      });
    };
  };
  viewer_ = std::make_shared<Viewer>(++shared_.last_id, later(&ViewerSocket::flush),
                                     later(&ViewerSocket::fail));
  figures_.id = viewer_->id();
  shared_.viewers.emplace(viewer_->id(), weak_from_this());
  asio::post(shared_.server_context, [&shared = shared_, viewer = viewer_, may = permission_] {
    shared.broker.add(viewer);
    shared.handler.send_server_info(*viewer, may);
  });
  ping();
  read();
}

void ViewerSocket::read() {
  socket_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
    error ? self->gone() : self->take();
  });
}

// A client that takes little is served whatever others of its address do.
bool ViewerSocket::within_budget(std::size_t bytes, HostNs now) {
  const double units =
      1.0 + static_cast<double>(bytes + viewer_->take_owed()) / Budget::kBytesPerUnit;
  const bool own = own_.charge(units, now);
  return budget_->charge(units, now) || own;
}

void ViewerSocket::take() {
  const HostNs now = monotonic_now();
  const auto data = buffer_.cdata();
  const auto* begin = static_cast<const std::uint8_t*>(data.data());
  const bool text = socket_.got_text();
  const auto call = text
                        ? std::nullopt
                        : call_of(static_cast<std::uint32_t>(Service::kStop), {begin, data.size()});
  if (call) {
    stop(*call, now);
    if (!stops_left_.charge(1.0, now)) {
      buffer_.consume(buffer_.size());
      return read_later();
    }
  } else if (!within_budget(data.size(), now) || !viewer_->admit(data.size())) {
    return close(Code::policy_error, "too many requests");
  } else {
    pass_on({static_cast<const char*>(data.data()), data.size()}, text, now);
  }
  buffer_.consume(buffer_.size());
  if (!closing_) read();
}

void ViewerSocket::read_later() {
  pause_.expires_after(kStopPause);
  pause_.async_wait([self = shared_from_this()](beast::error_code) {
    if (self->failed_) return self->gone();
    if (!self->closing_) self->read();
  });
}

// Before anything else, whatever the server thread does and whatever is in the rest of the message.
void ViewerSocket::stop(std::uint32_t call, HostNs now) {
  shared_.controls.stop();
  if (*stops_ >= kMaxStops) return;
  ++*stops_;
  asio::post(shared_.server_context,
             [&shared = shared_, viewer = viewer_, stops = stops_, call, now] {
               shared.handler.stop_pressed(viewer, call, now);
               --*stops;
             });
}

void ViewerSocket::pass_on(std::string message, bool text, HostNs now) {
  asio::post(shared_.server_context, [&shared = shared_, viewer = viewer_, weak = weak_from_this(),
                                      may = permission_, message = std::move(message), text, now] {
    const auto* begin = reinterpret_cast<const std::uint8_t*>(message.data());
    const bool known = shared.handler.handle(
        viewer, text ? parse_text(message) : parse_binary({begin, message.size()}), may, now);
    viewer->answered(message.size());
    if (known) return;
    asio::post(shared.context, [weak] {
      if (const auto self = weak.lock()) self->malformed();
    });
  });
}

void ViewerSocket::malformed() {
  if (++malformed_ >= kMaxMalformed) close(Code::policy_error, "not the Foxglove protocol");
}

void ViewerSocket::flush() {
  if (busy_ || closing_ || !open_) return;
  viewer_->awake();
  std::optional<WebSocketFrame> next = viewer_->outbox().pop(window_.open());
  if (!next) return;
  busy_ = true;
  window_.sent(next->size());
  write_began_ns_ = monotonic_now();
  writing_ = std::move(*next);
  socket_.binary(writing_.binary);
  const std::array<asio::const_buffer, 2> parts = {
      asio::buffer(writing_.head.data(), writing_.head_size), asio::buffer(*writing_.body)};
  socket_.async_write(parts, [self = shared_from_this()](beast::error_code error, std::size_t) {
    self->busy_ = false;
    if (error) return self->fail();
    ++self->figures_.sent;
    self->ping();
    self->flush();
  });
}

void ViewerSocket::ping() {
  if (closing_ || !window_.ping(monotonic_now())) return;
  socket_.async_ping(websocket::ping_data(kMark),
                     [self = shared_from_this()](beast::error_code) {});
}

void ViewerSocket::tick(HostNs now) {
  if (!open_) return;
  // Beast waits for the peer of a broken connection, and a hostile peer keeps sending.
  if (!socket_.is_open() && ++seconds_not_open_ >= kMaxSecondsNotOpen) return fail();
  if (closing_) return;
  if (busy_ && now - write_began_ns_ > kWriteLimitNs) return fail();
  const std::uint64_t dropped = viewer_->outbox().dropped();
  if (dropped == reported_dropped_) return;
  const std::uint64_t fresh = dropped - std::exchange(reported_dropped_, dropped);
  viewer_->say(StatusLevel::kInfo,
               std::to_string(fresh) + " messages dropped: this viewer is too slow");
}

messages::ClientFigures ViewerSocket::figures(HostNs now) const {
  messages::ClientFigures out = figures_;
  out.connected_s = to_s(now - connected_ns_);
  out.queued = viewer_->outbox().size();
  out.dropped = viewer_->outbox().dropped();
  return out;
}

void ViewerSocket::close(Code code, const char* reason) {
  if (std::exchange(closing_, true)) return;
  // The closing handshake ends in gone(), at the latest by the stream's timeout.
  socket_.async_close({code, reason},
                      [self = shared_from_this()](beast::error_code) { self->gone(); });
}

void ViewerSocket::go_away() { close(Code::going_away, "the daemon is shutting down"); }

void ViewerSocket::fail() {
  closing_ = failed_ = true;
  boost::system::error_code ignored;
  socket_.next_layer().socket().close(ignored);
}

void ViewerSocket::gone() {
  closing_ = true;
  if (!std::exchange(open_, false)) return;
  boost::system::error_code ignored;
  socket_.next_layer().socket().close(ignored);
  ++shared_.figures.closed_total;
  shared_.figures.dropped_total += viewer_->outbox().dropped();
  shared_.viewers.erase(viewer_->id());
  asio::post(shared_.server_context, [&shared = shared_, viewer = viewer_, now = monotonic_now()] {
    shared.broker.remove(viewer);
    shared.handler.leave(*viewer, now);
  });
}

}  // namespace tp100::server
