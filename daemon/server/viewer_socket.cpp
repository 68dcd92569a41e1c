#include "server/viewer_socket.h"

#include <algorithm>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <utility>

#include "core/clock.h"

namespace tp100::server {
namespace {

namespace beast = boost::beast;
namespace websocket = beast::websocket;

constexpr std::size_t kMaxMessage = 65'536;
constexpr double kMessagesPerS = 500.0;
constexpr double kBytesPerToken = 1024.0;
constexpr std::size_t kReadLimit = 524'288;  // bytes per second
constexpr int kMaxMalformed = 20;
constexpr int kMaxSecondsNotOpen = 2;
constexpr HostNs kWriteLimitNs = 10 * kNsPerS;
constexpr int kSendBuffer = 256 * 1024;  // the kernel's send buffer: data waiting there goes stale
constexpr std::size_t kMaxAgent = 120;

std::string address_of(const boost::asio::ip::tcp::socket& socket) {
  boost::system::error_code error;
  const auto end = socket.remote_endpoint(error);
  return error ? std::string()
               : plain(end.address()).to_string() + ":" + std::to_string(end.port());
}

}  // namespace

ViewerSocket::ViewerSocket(Stream::socket_type socket, SharedState& shared)
    : socket_(std::move(socket)), shared_(shared), buffer_(kMaxMessage), tokens_(kMessagesPerS) {
  ++shared_.sockets;
}

ViewerSocket::~ViewerSocket() { --shared_.sockets; }

void ViewerSocket::accept(const Request& request, std::string_view sub_protocol, bool may_command) {
  address_ = address_of(socket_.next_layer().socket());
  const bool local = is_local(socket_.next_layer().socket());
  agent_ = std::string(request[beast::http::field::user_agent]).substr(0, kMaxAgent);
  const config::CommandsFrom from = shared_.settings.commands;
  const bool accepted =
      from == config::CommandsFrom::kAll || (from == config::CommandsFrom::kLocal && local);
  permission_ = may_command && accepted ? Permission::kCommand : Permission::kStopOnly;

  boost::system::error_code ignored;
  auto& tcp = socket_.next_layer().socket();
  tcp.set_option(boost::asio::socket_base::send_buffer_size(kSendBuffer), ignored);
  tcp.set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  socket_.next_layer().rate_policy().read_limit(kReadLimit);
  socket_.set_option(
      websocket::stream_base::timeout{std::chrono::seconds(5), std::chrono::seconds(20), true});
  socket_.set_option(
      websocket::stream_base::decorator([sub_protocol](websocket::response_type& response) {
        response.set(beast::http::field::sec_websocket_protocol,
                     beast::string_view(sub_protocol.data(), sub_protocol.size()));
      }));
  socket_.read_message_max(kMaxMessage);
  socket_.auto_fragment(false);
  socket_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
    if (error) {
      self->gone();
    } else {
      self->opened();
    }
  });
}

void ViewerSocket::opened() {
  connected_ns_ = tokens_ns_ = monotonic_now();
  open_ = true;
  const auto weak = weak_from_this();
  viewer_ = std::make_shared<Viewer>(
      ++shared_.last_id,
      [weak] {
        if (const auto self = weak.lock()) self->flush();
      },
      [weak] {
        if (const auto self = weak.lock()) self->fail();
      });
  shared_.viewers.emplace(viewer_->id(), weak);
  shared_.broker.add(viewer_);
  shared_.handler.send_server_info(*viewer_, permission_);
  read();
}

void ViewerSocket::read() {
  socket_.async_read(buffer_,
                     [self = shared_from_this()](beast::error_code error, std::size_t bytes) {
                       if (error) {
                         self->gone();
                       } else {
                         self->take(bytes);
                       }
                     });
}

bool ViewerSocket::within_rate(std::size_t bytes, HostNs now) {
  tokens_ = std::min(kMessagesPerS, tokens_ + to_s(now - tokens_ns_) * kMessagesPerS);
  tokens_ns_ = now;
  tokens_ -= 1.0 + static_cast<double>(bytes) / kBytesPerToken;
  return tokens_ >= 0.0;
}

void ViewerSocket::take(std::size_t bytes) {
  const HostNs now = monotonic_now();
  if (!within_rate(bytes, now)) return close(Code::policy_error, "too many messages");
  const auto data = buffer_.cdata();
  const auto* begin = static_cast<const std::uint8_t*>(data.data());
  const ClientMessage message =
      socket_.got_text() ? parse_text({static_cast<const char*>(data.data()), data.size()})
                         : parse_binary({begin, data.size()});
  buffer_.consume(buffer_.size());
  if (!shared_.handler.handle(viewer_, message, permission_, now) && ++malformed_ >= kMaxMalformed)
    return close(Code::policy_error, "not the Foxglove protocol");
  if (failed_) return gone();
  if (!closing_) read();
}

void ViewerSocket::flush() {
  if (busy_ || closing_ || !open_ || viewer_->outbox().empty()) return;
  busy_ = true;
  write_began_ns_ = monotonic_now();
  writing_ = viewer_->outbox().pop();
  socket_.binary(writing_.binary);
  const std::array<boost::asio::const_buffer, 2> parts = {
      boost::asio::buffer(writing_.head.data(), writing_.head_size),
      boost::asio::buffer(*writing_.body)};
  socket_.async_write(parts, [self = shared_from_this()](beast::error_code error, std::size_t) {
    self->busy_ = false;
    if (error) return self->fail();
    ++self->sent_;
    self->flush();
  });
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
  viewer_->say(StatusLevel::kWarning,
               std::to_string(fresh) + " messages dropped: this viewer is too slow");
}

messages::ClientFigures ViewerSocket::figures(HostNs now) const {
  messages::ClientFigures out;
  out.address = address_;
  out.agent = agent_;
  out.sent = sent_;
  out.connected_s = to_s(now - connected_ns_);
  if (viewer_ == nullptr) return out;
  out.id = viewer_->id();
  out.subscriptions = viewer_->subscriptions().size();
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
  ++shared_.closed;
  shared_.dropped_by_closed += viewer_->outbox().dropped();
  shared_.broker.remove(viewer_);
  shared_.handler.leave(*viewer_, monotonic_now());
  shared_.viewers.erase(viewer_->id());
}

}  // namespace tp100::server
