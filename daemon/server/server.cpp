#include "server/server.h"

#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <charconv>
#include <chrono>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/clock.h"
#include "core/error.h"
#include "messages/prometheus.h"
#include "messages/status_messages.h"
#include "server/access.h"
#include "server/connection.h"
#include "server/local_daemons.h"
#include "server/viewer_socket.h"
#include "text/json_writer.h"

namespace tp100::server {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

constexpr auto kTick = std::chrono::milliseconds(50);
constexpr auto kAcceptPause = std::chrono::milliseconds(200);
constexpr auto kGoodbyeTick = std::chrono::milliseconds(10);
constexpr auto kFlush = std::chrono::seconds(1);
constexpr HostNs kGoodbyeNs = 500 * kNsPerMs;
constexpr HostNs kStandsStillNs = kNsPerS;
constexpr std::uint16_t kUsualPort = 8765;

struct Address {
  asio::ip::address ip;
  std::uint16_t port = 0;
};

Address parse_address(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  Address out;
  if (colon != std::string::npos) {
    std::string host = text.substr(0, colon);
    if (host.size() > 1 && host.front() == '[' && host.back() == ']')
      host = host.substr(1, host.size() - 2);
    if (host == "localhost") host = "127.0.0.1";
    boost::system::error_code error;
    out.ip = asio::ip::make_address(host, error);
    const char* end = text.data() + text.size();
    const auto [at, wrong] = std::from_chars(text.data() + colon + 1, end, out.port);
    if (!error && wrong == std::errc() && at == end) return out;
  }
  throw SetupError("--listen " + text +
                   ": not an address; use ADDRESS:PORT like 127.0.0.1:8765, auto or off");
}

/// Steps on their way to the server's thread: a ring of whole records that drops the oldest.
class Inbox {
 public:
  static constexpr std::size_t kCapacity = 64;

  void push(const StepRecord& record) {
    const std::lock_guard lock(mutex_);
    ring_[(first_ + count_) % kCapacity] = record;
    if (count_ < kCapacity) {
      ++count_;
    } else {
      first_ = (first_ + 1) % kCapacity;
      ++lost_;
    }
  }
  bool pop(StepRecord& record) {
    const std::lock_guard lock(mutex_);
    if (count_ == 0) return false;
    record = ring_[first_];
    first_ = (first_ + 1) % kCapacity;
    --count_;
    return true;
  }
  std::uint64_t lost() const {
    const std::lock_guard lock(mutex_);
    return lost_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<StepRecord> ring_{kCapacity};
  std::size_t first_ = 0, count_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace

struct Server::State {
  State(ServerSettings s, const messages::Messages& messages,
        std::vector<messages::ParameterText> parameters, Controls& c)
      : controls(c),
        broker(messages::channel_texts(), std::move(s.listener)),
        publisher(broker, messages, c),
        own{.session = random_name()},
        handler(broker, publisher, c, std::move(parameters), own.session, s.name),
        shared{.settings = std::move(s),
               .broker = broker,
               .publisher = publisher,
               .handler = handler,
               .disk = disk} {
    shared.sources.page = shared.settings.page;
    shared.sources.runs_folder = shared.settings.runs_folder;
    shared.sources.runs = shared.settings.runs;
    shared.sources.setup = shared.settings.setup;
    shared.sources.health = [this] { return health(); };
    shared.sources.metrics = [this] { return metrics(); };
    shared.sources.robots = [this](std::string_view host) {
      return robots_json(own, local_daemons(), shared.settings.robots, host);
    };
    shared.sources.history = [this](std::string_view topic) {
      return publisher.history().json(topic);
    };
    listen();
  }

  void listen();
  bool try_listen(const Address& address, boost::system::error_code& error);
  void accept();
  void tick();
  void every_second(HostNs now);
  void take_records();
  void run();
  void stop();
  void await_goodbyes();
  std::string health() const;
  std::string metrics() const;
  messages::ClientsFigures clients(HostNs now) const;

  Controls& controls;
  Broker broker;
  Publisher publisher;
  LocalDaemon own;
  RequestHandler handler;
  SharedState shared;
  Inbox inbox;
  StepRecord record{};
  std::atomic<bool> woken{false};
  std::string url, note;
  std::optional<Announcement> announcement;
  std::thread thread;
  HostNs next_second_ns = 0;
  HostNs stop_by_ns = 0;
  bool stopping = false;
  // Declared after the objects that its handlers' sockets refer to.
  asio::io_context context{1};
  tcp::acceptor acceptor{context};
  asio::steady_timer timer{context};
  asio::steady_timer pause{context};
  // Its jobs post to the context.
  record::Worker disk{kMaxConnections};
};

bool Server::State::try_listen(const Address& address, boost::system::error_code& error) {
  const tcp::endpoint end(address.ip, address.port);
  acceptor.open(end.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(end, error);
  if (!error) acceptor.listen(64, error);
  if (!error) return true;
  boost::system::error_code ignored;
  acceptor.close(ignored);
  return false;
}

void Server::State::listen() {
  if (shared.settings.listen == "off") return;
  const bool automatic = shared.settings.listen == "auto";
  const Address address = automatic ? Address{asio::ip::address_v4::loopback(), kUsualPort}
                                    : parse_address(shared.settings.listen);
  boost::system::error_code error;
  bool listening = try_listen(address, error);
  if (!listening && automatic) {
    note = "127.0.0.1:" + std::to_string(kUsualPort) +
           " is taken, another tp100d perhaps; --listen names a port";
    listening = try_listen({address.ip, 0}, error);
  }
  if (!listening) {
    throw SetupError("--listen " + shared.settings.listen + ": " + error.message() +
                     "; choose another address, port 0 or auto");
  }
  const tcp::endpoint end = acceptor.local_endpoint();
  own.address = end.address().to_string();
  own.port = end.port();
  const bool any = end.address().is_unspecified();
  const std::string host = any                     ? std::string("localhost")
                           : end.address().is_v6() ? "[" + end.address().to_string() + "]"
                                                   : end.address().to_string();
  url = "http://" + host + ":" + std::to_string(end.port()) + "/";
}

void Server::State::accept() {
  acceptor.async_accept([this](boost::system::error_code error, tcp::socket socket) {
    if (stopping || error == asio::error::operation_aborted) return;
    if (!error) {
      serve_connection(std::move(socket), shared);
      return accept();
    }
    // Probably out of descriptors: do not retry at once.
    pause.expires_after(kAcceptPause);
    pause.async_wait([this](boost::system::error_code cancelled) {
      if (!cancelled) accept();
    });
  });
}

void Server::State::take_records() {
  woken = false;
  while (inbox.pop(record)) publisher.take(record);
  handler.tick(monotonic_now());
}

messages::ClientsFigures Server::State::clients(HostNs now) const {
  messages::ClientsFigures out;
  out.queue_limit = Outbox::kMaxData;
  out.refused_total = shared.refused;
  out.closed_total = shared.closed;
  out.dropped_total = shared.dropped_by_closed;
  for (const auto& [id, weak] : shared.viewers) {
    const auto viewer = weak.lock();
    if (viewer == nullptr) continue;
    out.clients.push_back(viewer->figures(now));
    out.dropped_total += out.clients.back().dropped;
  }
  return out;
}

void Server::State::every_second(HostNs now) {
  broker.publish(messages::Channel::kClient, publisher.clock().unix_ns(now),
                 messages::clients_message(clients(now)));
  const auto viewers = shared.viewers;
  for (const auto& [id, weak] : viewers)
    if (const auto viewer = weak.lock()) viewer->tick(now);
}

void Server::State::tick() {
  const HostNs now = monotonic_now();
  publisher.tick(now);
  handler.tick(now);
  if (now >= next_second_ns) {
    next_second_ns = now + kNsPerS;
    every_second(now);
  }
  timer.expires_after(kTick);
  timer.async_wait([this](boost::system::error_code error) {
    if (!error) tick();
  });
}

std::string Server::State::health() const {
  const HostNs now = monotonic_now();
  std::string text;
  text::JsonWriter(text)
      .begin_object()
      .field("ok", now - publisher.last_step_ns() < kStandsStillNs)
      .field("version", publisher.run_context().version)
      .field("uptime_s", publisher.clock().t_s(now))
      .field("run", to_string(publisher.state().run))
      .field("session", to_string(publisher.state().session))
      .field("clients", shared.viewers.size())
      .end_object();
  return text;
}

std::string Server::State::metrics() const {
  const messages::LoopFigures loop = controls.loop();
  return messages::prometheus_text({.state = publisher.state(),
                                    .loop = loop,
                                    .link = publisher.link(loop),
                                    .recording = controls.recording(),
                                    .clients = clients(monotonic_now())},
                                   publisher.run_context());
}

void Server::State::run() {
  if (acceptor.is_open()) accept();
  tick();
  context.run();
}

void Server::State::stop() {
  stopping = true;
  boost::system::error_code ignored;
  acceptor.close(ignored);
  timer.cancel();
  pause.cancel();
  const auto viewers = shared.viewers;
  for (const auto& [id, weak] : viewers)
    if (const auto viewer = weak.lock()) viewer->go_away();
  stop_by_ns = monotonic_now() + kGoodbyeNs;
  await_goodbyes();
}

// Clients that do not answer in time are dropped.
void Server::State::await_goodbyes() {
  if (shared.sockets == 0 || monotonic_now() > stop_by_ns) return context.stop();
  timer.expires_after(kGoodbyeTick);
  timer.async_wait([this](boost::system::error_code) { await_goodbyes(); });
}

Server::Server(ServerSettings settings, const messages::Messages& messages,
               std::vector<messages::ParameterText> parameters, Controls& controls)
    : state_(std::make_unique<State>(std::move(settings), messages, std::move(parameters),
                                     controls)) {}

Server::~Server() {
  if (!state_->thread.joinable()) return;
  asio::post(state_->context, [this] { state_->stop(); });
  state_->thread.join();
}

const std::string& Server::url() const { return state_->url; }
const std::string& Server::note() const { return state_->note; }

void Server::start() {
  if (!state_->url.empty()) state_->announcement.emplace(state_->own);
  state_->thread = std::thread([this] { state_->run(); });
}

void Server::change_setup(messages::RunContext run_context, messages::SharedMessages setup,
                          std::vector<messages::ParameterText> parameters) {
  asio::post(state_->context, [this, m = std::move(run_context), s = std::move(setup),
                               p = std::move(parameters)]() mutable {
    const HostNs now = monotonic_now();
    state_->publisher.change_setup(std::move(m), s, now);
    state_->handler.change_setup(std::move(p), now);
  });
}

void Server::take(const StepRecord& record) {
  state_->inbox.push(record);
  if (!state_->woken.exchange(true))
    asio::post(state_->context, [this] { state_->take_records(); });
}

void Server::take_truth(HostNs at, const Pose& truth) {
  asio::post(state_->context, [this, at, truth] { state_->publisher.take_truth({at, truth}); });
}

void Server::take(const messages::Event& event) {
  asio::post(state_->context, [this, event] { state_->publisher.take(event); });
}

void Server::take_image(HostNs at, std::string jpeg) {
  asio::post(state_->context,
             [this, at, jpeg = std::move(jpeg)] { state_->publisher.take_image(at, jpeg); });
}

void Server::stop_pressed(const std::string& by) {
  const HostNs now = monotonic_now();
  asio::post(state_->context, [this, by, now] { state_->publisher.stop_pressed(by, now); });
}

void Server::stop_answered(HostNs at) {
  asio::post(state_->context, [this, at] {
    const HostNs now = monotonic_now();
    state_->publisher.stop_answered(at, now);
    state_->handler.tick(now);
  });
}

void Server::flush() {
  if (!state_->thread.joinable()) return;
  const auto flushed = std::make_shared<std::promise<void>>();
  asio::post(state_->context, [flushed] { flushed->set_value(); });
  flushed->get_future().wait_for(kFlush);
}

bool Server::waits_for_disk() { return !state_->disk.idle_by(std::chrono::steady_clock::now()); }

std::uint64_t Server::lost_records() const { return state_->inbox.lost(); }

}  // namespace tp100::server
