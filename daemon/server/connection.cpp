#include "server/connection.h"

#include <sys/socket.h>

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
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "server/local_daemons.h"
#include "server/viewer_socket.h"

namespace tp100::server {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;

constexpr auto kRequestTime = std::chrono::seconds(5);
constexpr auto kWriteTime = std::chrono::seconds(10);
constexpr auto kDiskTime = std::chrono::seconds(2);
constexpr std::uint32_t kMaxHeader = 8 * 1024;
constexpr std::size_t kPart = 65'536;

beast::string_view view(std::string_view text) { return {text.data(), text.size()}; }
std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(boost::asio::ip::tcp::socket socket, SharedState& shared)
      : stream_(std::move(socket)), shared_(shared) {
    ++shared_.connections;
  }
  ~Connection() { leave(); }

  void read();

 private:
  using Request = http::request<http::empty_body>;
  using Head = http::response<http::empty_body>;

  void on_request();
  bool may_ask() const;
  void ask_disk();
  void on_disk(std::uint64_t question, const std::function<void()>& then);
  void await_disk(std::function<void()> late);
  void leave();
  void answer(HttpAnswer answer);
  void write_body();
  void write_part();
  void on_part(std::optional<std::size_t> got);
  void end();
  bool upgrade(bool may_command);
  std::string_view header(http::field name) const { return view(parser_->get()[name]); }

  beast::tcp_stream stream_;
  SharedState& shared_;
  beast::flat_buffer buffer_{kMaxHeader};
  std::optional<http::request_parser<http::empty_body>> parser_;
  Head head_;
  std::optional<http::response_serializer<http::empty_body>> serializer_;
  HttpAnswer answer_;
  std::array<char, kPart> part_{};
  bool last_ = false;
  bool counted_ = true;  // counted among the server's connections
  boost::asio::steady_timer timeout_{stream_.get_executor()};
  std::uint64_t question_ = 0;  // number of the newest job for the disk
};

/// A request that outlives its connection's buffer.
struct KeptRequest {
  std::string method, target, range, none_match;
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
  if (!host_allowed(host, access)) {
    ++shared_.refused;
    return answer(http_text(403,
                            "this Host is not served; use an address, or add the name to "
                            "server.hosts"));
  }
  const bool upgrades = beast::websocket::is_upgrade(request);
  const std::string_view origin = header(http::field::origin);
  const bool permitted = origin_allowed(origin, host, access);
  if (!permitted && !(upgrades && is_page_of(local_daemons(), origin, host))) {
    ++shared_.refused;
    return answer(http_text(403, "this Origin is not permitted; add it to server.origins"));
  }
  if (!may_ask()) {
    ++shared_.refused;
    return answer(http_text(403,
                            "another site's page asks for this; open the address in the browser "
                            "itself, or add that site to server.origins"));
  }
  if (upgrades) {
    if (!upgrade(permitted)) ++shared_.refused;
    return;
  }
  if (needs_disk(view(request.target()))) return ask_disk();
  answer(http_answer({.method = view(request.method_string()),
                      .target = view(request.target()),
                      .range = header(http::field::range),
                      .none_match = header(http::field::if_none_match),
                      .host = host},
                     shared_.sources));
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

void Connection::ask_disk() {
  const Request& request = parser_->get();
  KeptRequest kept{std::string(view(request.method_string())), std::string(view(request.target())),
                   std::string(header(http::field::range)),
                   std::string(header(http::field::if_none_match))};
  HttpSources sources{.page = {},
                      .runs_folder = shared_.sources.runs_folder,
                      .runs = shared_.sources.runs,
                      .setup = shared_.sources.setup,
                      .health = {},
                      .metrics = {},
                      .robots = {},
                      .history = {}};
  const auto found = std::make_shared<HttpAnswer>();
  // The job holds the only reference to the connection, so that it ends on the server's thread.
  const auto back = [held = std::make_shared<std::shared_ptr<Connection>>(shared_from_this()),
                     question = ++question_, found] {
    auto* connection = held->get();
    boost::asio::post(connection->stream_.get_executor(),
                      [self = std::move(*held), question, found] {
                        self->on_disk(question, [&] { self->answer(std::move(*found)); });
                      });
  };
  const bool asked = shared_.disk.post(
      [back, found, kept = std::move(kept), sources = std::move(sources)] {
        *found = http_answer({kept.method, kept.target, kept.range, kept.none_match}, sources);
        back();
      },
      [back, found](const std::string& why) {
        *found = http_text(500, why);
        back();
      });
  const auto busy = [this] { answer(http_text(503, "the disk does not answer; try again later")); };
  if (!asked) return busy();
  await_disk(busy);
}

// Ignores answers of the disk that come too late.
void Connection::on_disk(std::uint64_t question, const std::function<void()>& then) {
  if (question != question_) return;
  ++question_;
  timeout_.cancel();
  then();
}

void Connection::await_disk(std::function<void()> late) {
  stream_.expires_never();
  timeout_.expires_after(kDiskTime);
  timeout_.async_wait([self = shared_from_this(), question = question_,
                       late = std::move(late)](boost::system::error_code cancelled) {
    if (cancelled || question != self->question_) return;
    ++self->question_;
    late();
  });
}

void Connection::leave() {
  if (std::exchange(counted_, false)) --shared_.connections;
}

bool Connection::upgrade(bool may_command) {
  last_ = true;
  const std::string_view chosen = choose_sub_protocol(header(http::field::sec_websocket_protocol));
  if (chosen.empty()) {
    answer(http_text(400, "offer the sub-protocol " + std::string(kNewSubProtocol) + " or " +
                              std::string(kOldSubProtocol)));
    return false;
  }
  const std::size_t most = shared_.settings.max_clients;
  const std::size_t kept = is_local(stream_.socket()) ? 0 : std::min(kKeptForLocal, most / 2);
  if (shared_.sockets >= most - kept) {
    answer(http_text(503, "too many viewers (server.max_clients)"));
    return false;
  }
  stream_.expires_never();
  std::make_shared<ViewerSocket>(stream_.release_socket(), shared_)
      ->accept(parser_->get(), chosen, may_command);
  return true;
}

void Connection::answer(HttpAnswer answer) {
  answer_ = std::move(answer);
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
  http::async_write_header(stream_, *serializer_,
                           [self = shared_from_this()](beast::error_code error, std::size_t) {
                             if (!error) self->write_body();
                           });
}

void Connection::write_body() {
  const bool head_only = parser_->is_header_done() && parser_->get().method() == http::verb::head;
  if (head_only || answer_.length == 0) return end();
  if (answer_.on_disk()) return write_part();
  const boost::asio::const_buffer bytes =
      answer_.bytes.empty() ? boost::asio::const_buffer(answer_.body.data(), answer_.body.size())
                            : boost::asio::const_buffer(answer_.bytes.data(), answer_.bytes.size());
  boost::asio::async_write(stream_, bytes,
                           [self = shared_from_this()](beast::error_code error, std::size_t) {
                             if (!error) self->end();
                           });
}

void Connection::write_part() {
  if (answer_.length == 0) return end();
  const auto back = [held = std::make_shared<std::shared_ptr<Connection>>(shared_from_this()),
                     question = ++question_](std::optional<std::size_t> got) {
    auto* connection = held->get();
    boost::asio::post(connection->stream_.get_executor(), [self = std::move(*held), question, got] {
      self->on_disk(question, [&] { self->on_part(got); });
    });
  };
  const bool asked = shared_.disk.post([this, back] { back(answer_.read(part_)); },
                                       [back](const std::string&) { back(std::nullopt); });
  // The body cannot be completed: closing the connection tells the reader so.
  if (asked)
    await_disk([this] {
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
  boost::asio::async_write(stream_, boost::asio::buffer(part_.data(), *got),
                           [self = shared_from_this()](beast::error_code error, std::size_t) {
                             if (!error) self->write_part();
                           });
}

void Connection::end() {
  answer_ = {};
  if (last_) {
    beast::error_code ignored;
    stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
    return;
  }
  read();
}

}  // namespace

boost::asio::ip::address plain(const boost::asio::ip::address& address) {
  if (!address.is_v6() || !address.to_v6().is_v4_mapped()) return address;
  return boost::asio::ip::make_address_v4(boost::asio::ip::v4_mapped, address.to_v6());
}

bool is_local(const boost::asio::ip::tcp::socket& socket) {
  boost::system::error_code error;
  const auto end = socket.remote_endpoint(error);
  return !error && plain(end.address()).is_loopback();
}

void serve_connection(boost::asio::ip::tcp::socket socket, SharedState& shared) {
  if (shared.connections >= kMaxConnections - (is_local(socket) ? 0 : kKeptForLocal)) {
    ++shared.refused;
    return;
  }
  std::make_shared<Connection>(std::move(socket), shared)->read();
}

}  // namespace tp100::server
