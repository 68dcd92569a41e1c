#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <cerrno>
#include <chrono>
#include <functional>
#include <optional>
#include <utility>

#include "core/clock.h"
#include "core/worker.h"
#include "server/local_daemons.h"
#include "server/viewer_socket.h"

namespace tp100::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;

constexpr auto kRequestTime = std::chrono::seconds(5);
constexpr auto kWriteTime = std::chrono::seconds(10);
constexpr auto kAnswerTime = std::chrono::seconds(2);
constexpr std::uint32_t kMaxHeader = 8 * 1024;
constexpr std::size_t kPart = 65'536;
constexpr double kBodyBytesPerUnit = 16'384.0;  // most of them are copied only

constexpr const char* kBusy = "the daemon is busy; try again later";
constexpr const char* kForeign = "this Origin is not permitted; add it to server.origins";

beast::string_view view(std::string_view text) { return {text.data(), text.size()}; }
std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(asio::ip::tcp::socket socket, Peer peer, SharedState& shared)
      : stream_(std::move(socket)),
        peer_(std::move(peer)),
        shared_(shared),
        budget_(shared.http_budgets.of(peer_.network)) {
    ++shared_.connections;
  }
  ~Connection() {
    leave();
    release_answer();
  }

  void read();

 private:
  using Request = http::request<http::empty_body>;
  using Head = http::response<http::empty_body>;

  void on_request();
  void refuse(unsigned status, std::string why);
  void serve(bool may_command);
  bool may_ask() const;
  template <class Result>
  void ask(bool disk, std::function<Result()> job,
           std::function<Result(const std::string& why)> failed, std::function<void(Result&)> then,
           std::function<void()> late);
  void ask_for_page(const std::string& origin);
  void ask_for_content();
  void leave() {
    if (std::exchange(counted_, false)) --shared_.connections;
  }
  void release_answer() {
    shared_.body_bytes -= answer_.body.size();
    answer_ = {};
  }
  void answer(HttpAnswer answer);
  /// Receives the end of a write, and calls `next` unless it failed.
  auto then(void (Connection::*next)()) {
    return [self = shared_from_this(), next](beast::error_code error, std::size_t) {
      if (!error) (self.get()->*next)();
    };
  }
  void write_body();
  void write_part();
  void on_part(std::optional<std::size_t> got);
  void end();
  void upgrade(bool may_command);
  std::string_view header(http::field name) const { return view(parser_->get()[name]); }

  beast::tcp_stream stream_;
  const Peer peer_;
  SharedState& shared_;
  beast::flat_buffer buffer_{kMaxHeader};
  std::optional<http::request_parser<http::empty_body>> parser_;
  Head head_;
  std::optional<http::response_serializer<http::empty_body>> serializer_;
  HttpAnswer answer_;
  std::array<char, kPart> part_{};
  std::shared_ptr<Budget> budget_;  // of its address
  bool last_ = false;
  bool counted_ = true;  // counted among the server's connections
  asio::steady_timer timeout_{stream_.get_executor()};
  std::uint64_t question_ = 0;  // number of the newest job for another thread
};

void Connection::read() {
  parser_.emplace();
  parser_->header_limit(kMaxHeader);
  parser_->body_limit(0);
  stream_.expires_after(kRequestTime);
  http::async_read(
      stream_, buffer_, *parser_,
      [self = shared_from_this()](beast::error_code error, std::size_t) {
        if (!error) return self->on_request();
        // A request with a body or invalid HTTP ends the connection.
        if (error != http::error::end_of_stream &&
            error.category() == http::make_error_code(http::error::end_of_stream).category()) {
          self->last_ = true;
          self->answer(http_text(400, "not a request that this server accepts"));
        }
      });
}

void Connection::on_request() {
  const Request& request = parser_->get();
  last_ = !request.keep_alive();
  const std::string_view host = header(http::field::host);
  const AccessRules& access = shared_.settings.access;
  if (!host_allowed(host, access))
    return refuse(403,
                  "this Host is not served; use an address, or add the name to "
                  "server.hosts");
  const bool upgrades = beast::websocket::is_upgrade(request);
  // A viewer is let in to press STOP, however much its address has asked for.
  if (!budget_->charge(1.0, monotonic_now()) && !upgrades)
    return refuse(429, "too many requests from this address; wait a second");
  const std::string_view origin = header(http::field::origin);
  if (origin_allowed(origin, host, access)) return serve(true);
  if (!upgrades) return refuse(403, kForeign);
  ask_for_page(std::string(origin));
}

void Connection::serve(bool may_command) {
  const Request& request = parser_->get();
  if (!may_ask())
    return refuse(403,
                  "another site's page asks for this; open the address in the browser "
                  "itself, or add that site to server.origins");
  if (!beast::websocket::is_upgrade(request)) return ask_for_content();
  upgrade(may_command);
}

void Connection::refuse(unsigned status, std::string why) {
  ++shared_.figures.refused_total;
  answer(http_text(status, std::move(why)));
}

// Browsers send no Origin where a page only displays a resource, as with <img>. Following a link to
// the page is harmless; its frame-ancestors keep it out of frames.
bool Connection::may_ask() const {
  if (!header(http::field::origin).empty()) return true;  // which was checked already
  const Request& request = parser_->get();
  const bool followed_link = view(request["Sec-Fetch-Mode"]) == "navigate" &&
                             view(request["Sec-Fetch-Dest"]) == "document" &&
                             !needs_disk(view(request.target()));
  return followed_link || fetch_site_allowed(view(request["Sec-Fetch-Site"]));
}

/// Does `job` on the disk's thread or the server thread's, and `then` here with its result, or with
/// that of `failed` if it throws; `late` if that takes too long.
template <class Result>
void Connection::ask(bool disk, std::function<Result()> job,
                     std::function<Result(const std::string& why)> failed,
                     std::function<void(Result&)> then, std::function<void()> late) {
  // The other thread does not keep the connection: it would be closed there.
  const auto back = [held = std::make_shared<std::shared_ptr<Connection>>(shared_from_this()),
                     question = ++question_, then = std::move(then)](Result result) {
    if (*held == nullptr) return;  // there was no memory to post the first result
    asio::io_context& context = (*held)->shared_.context;
    asio::post(context, [self = std::move(*held), question, then,
                         found = std::make_shared<Result>(std::move(result))] {
      if (question != self->question_) return;  // too late
      ++self->question_;
      self->timeout_.cancel();
      then(*found);
    });
  };
  const auto done = [back, job = std::move(job)] { back(job()); };
  const auto broken = [back, failed = std::move(failed)](const std::string& why) {
    back(failed(why));
  };
  if (!disk) {
    asio::post(shared_.server_context, [done, broken] { Worker::run_here(done, broken); });
  } else if (!shared_.page_files.post(done, broken)) {
    return late();
  }
  stream_.expires_never();
  timeout_.expires_after(kAnswerTime);
  timeout_.async_wait([self = shared_from_this(), question = question_,
                       late = std::move(late)](boost::system::error_code cancelled) {
    if (cancelled || question != self->question_) return;
    ++self->question_;
    late();
  });
}

// The kernel's table of sockets, which may be long, shows whose page this is.
void Connection::ask_for_page(const std::string& origin) {
  const std::string host(header(http::field::host));
  ask<bool>(
      false, [origin, host] { return is_page_of(local_daemons(), origin, host); },
      [](const std::string&) { return false; },
      [this](const bool& known) { known ? serve(false) : refuse(403, kForeign); },
      [this] { answer(http_text(503, kBusy)); });
}

void Connection::ask_for_content() {
  const Request& request = parser_->get();
  const bool disk = needs_disk(view(request.target()));
  const auto text = [](beast::string_view part) { return std::string(view(part)); };
  ask<HttpAnswer>(
      disk,
      [kept =
           HttpRequest{
               text(request.method_string()), text(request.target()),
               text(request[http::field::range]), text(request[http::field::if_none_match]),
               text(request[http::field::host]),
               request[http::field::accept_encoding].find("gzip") != beast::string_view::npos},
       &sources = shared_.sources] { return http_answer(kept, sources); },
      [](const std::string& why) { return http_text(500, why); },
      [this](HttpAnswer& found) { answer(std::move(found)); },
      [this, disk] { answer(http_text(503, disk ? Worker::kBusy : kBusy)); });
}

void Connection::upgrade(bool may_command) {
  last_ = true;
  const std::string_view chosen = choose_sub_protocol(header(http::field::sec_websocket_protocol));
  if (chosen.empty())
    return refuse(400, "offer the sub-protocol " + std::string(kNewSubProtocol) + " or " +
                           std::string(kOldSubProtocol));
  const std::size_t most = shared_.settings.max_clients;
  const std::size_t kept = peer_.local ? 0 : std::min(SharedState::kKeptForLocal, most / 2);
  if (shared_.sockets >= most - kept) return refuse(503, "too many viewers (server.max_clients)");
  const config::CommandsFrom from = shared_.settings.commands;
  const bool accepted =
      from == config::CommandsFrom::kAll || (from == config::CommandsFrom::kLocal && peer_.local);
  stream_.expires_never();
  std::make_shared<ViewerSocket>(
      stream_.release_socket(), peer_, shared_,
      may_command && accepted ? Permission::kCommand : Permission::kStopOnly)
      ->accept(parser_->get(), chosen);
}

void Connection::answer(HttpAnswer answer) {
  if (shared_.body_bytes + answer.body.size() > SharedState::kMaxBodyBytes)
    answer = http_text(503, kBusy);
  release_answer();
  answer_ = std::move(answer);
  shared_.body_bytes += answer_.body.size();
  budget_->charge(static_cast<double>(answer_.body.size()) / kBodyBytesPerUnit, monotonic_now());
  head_ = Head(static_cast<http::status>(answer_.status), 11);
  head_.keep_alive(!last_);
  head_.set(http::field::server, "tp100d");
  head_.set(http::field::content_type, answer_.type);
  head_.set("X-Content-Type-Options", "nosniff");
  head_.set("Referrer-Policy", "no-referrer");
  for (const auto& [name, content] : answer_.headers)
    head_.set(view(std::string_view(name)), content);
  if (answer_.status != 304) head_.content_length(answer_.length);
  serializer_.emplace(head_);
  stream_.expires_after(kWriteTime);
  http::async_write_header(stream_, *serializer_, then(&Connection::write_body));
}

void Connection::write_body() {
  const bool head_only = parser_->is_header_done() && parser_->get().method() == http::verb::head;
  if (head_only || answer_.length == 0) return end();
  if (answer_.on_disk()) return write_part();
  const asio::const_buffer bytes =
      answer_.bytes.empty() ? asio::const_buffer(answer_.body.data(), answer_.body.size())
                            : asio::const_buffer(answer_.bytes.data(), answer_.bytes.size());
  // In parts, each with its time: a slow link carries a page, a reader that stopped is closed.
  const asio::const_buffer part = asio::buffer(bytes + answer_.offset, kPart);
  answer_.offset += part.size();
  answer_.length -= part.size();
  stream_.expires_after(kWriteTime);
  asio::async_write(stream_, part, then(&Connection::write_body));
}

void Connection::write_part() {
  if (answer_.length == 0) return end();
  // The body cannot be completed: closing the connection tells the reader so.
  ask<std::optional<std::size_t>>(
      true, [this] { return answer_.read(part_); },
      [](const std::string&) { return std::optional<std::size_t>{}; },
      [this](const std::optional<std::size_t>& got) { on_part(got); },
      [this] {
        beast::error_code ignored;
        stream_.socket().close(ignored);
        leave();
      });
}

void Connection::on_part(std::optional<std::size_t> got) {
  if (!got) return;  // as above
  if (*got == 0) {
    // Nothing is written meanwhile, so only this read detects a disconnect.
    char byte = 0;
    const ssize_t n = ::recv(stream_.socket().native_handle(), &byte, 1, MSG_PEEK | MSG_DONTWAIT);
    if (n > 0 || (n < 0 && errno == EAGAIN)) write_part();
    return;
  }
  stream_.expires_after(kWriteTime);
  asio::async_write(stream_, asio::buffer(part_.data(), *got), then(&Connection::write_part));
}

void Connection::end() {
  release_answer();
  if (last_) {
    beast::error_code ignored;
    stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
    return;
  }
  read();
}

/// Who is at the other end of `socket`; nobody if it has ended already.
Peer peer_of(const asio::ip::tcp::socket& socket) {
  namespace ip = boost::asio::ip;
  boost::system::error_code error;
  const ip::tcp::endpoint end = socket.remote_endpoint(error);
  ip::address address = end.address();
  if (address.is_v6() && address.to_v6().is_v4_mapped())
    address = ip::make_address_v4(ip::v4_mapped, address.to_v6());
  const std::string name = address.to_string();
  Peer peer{error ? "" : name + ":" + std::to_string(end.port()), name,
            !error && address.is_loopback()};
  if (!address.is_v6()) return peer;
  // A machine of IPv6 has any number of addresses that begin alike.
  auto bytes = address.to_v6().to_bytes();
  std::fill(bytes.begin() + 8, bytes.end(), std::uint8_t{0});
  peer.network = ip::make_address_v6(bytes).to_string();
  return peer;
}

}  // namespace

void serve_connection(boost::asio::ip::tcp::socket socket, SharedState& shared) {
  Peer peer = peer_of(socket);
  const std::size_t kept = peer.local ? 0 : SharedState::kKeptForLocal;
  if (shared.connections >= SharedState::kMaxConnections - kept) {
    ++shared.figures.refused_total;
    return;
  }
  std::make_shared<Connection>(std::move(socket), std::move(peer), shared)->read();
}

}  // namespace tp100::server
