#include "server/sockets.h"

#include <pthread.h>

#include <algorithm>
#include <boost/asio/post.hpp>
#include <chrono>
#include <utility>

#include "core/clock.h"
#include "core/error.h"
#include "loop/real_time.h"
#include "server/publisher.h"
#include "server/viewer_socket.h"
#include "text/format.h"

namespace tp100::server {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

constexpr auto kSecond = std::chrono::seconds(1);
constexpr auto kAcceptPause = std::chrono::milliseconds(200);
constexpr auto kGoodbyeTick = std::chrono::milliseconds(10);
constexpr HostNs kGoodbyeNs = 500 * kNsPerMs;
// Of a processor, and how long the thread may compute without a rest.
constexpr int kShareDivisor = 2;
constexpr HostNs kMostCreditNs = 10 * kNsPerMs;
constexpr std::uint16_t kUsualPort = 8765;

tcp::endpoint parse_address(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon != std::string::npos) {
    std::string host = text.substr(0, colon);
    if (host.size() > 1 && host.front() == '[' && host.back() == ']')
      host = host.substr(1, host.size() - 2);
    if (host == "localhost") host = "127.0.0.1";
    boost::system::error_code error;
    const asio::ip::address ip = asio::ip::make_address(host, error);
    const auto port = text::number_in<std::uint16_t>(std::string_view(text).substr(colon + 1));
    if (!error && port) return {ip, *port};
  }
  throw UserError("--listen " + text +
                  ": not an address; use ADDRESS:PORT like 127.0.0.1:8765, auto or off");
}

}  // namespace

void run_handlers(asio::io_context& context, const Worker::Failed& failed,
                  const std::function<void()>& after) {
  const auto run = [&] {
    while (context.run_one() > 0) after();
  };
  while (!context.stopped()) Worker::run_here(run, failed);
}

Sockets::Sockets(ServerSettings settings, Controls& controls, asio::io_context& server_context,
                 Broker& broker, Publisher& publisher, RequestHandler& handler,
                 HttpSources& sources, std::string session)
    : shared_{.settings = std::move(settings),
              .controls = controls,
              .context = context_,
              .server_context = server_context,
              .broker = broker,
              .handler = handler,
              .sources = sources,
              .page_files = page_files_},
      publisher_(publisher),
      own_{.session = std::move(session)} {
  listen();
}

bool Sockets::try_listen(const tcp::endpoint& end, boost::system::error_code& error) {
  acceptor_.open(end.protocol(), error);
  if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor_.bind(end, error);
  if (!error) acceptor_.listen(64, error);
  if (!error) return true;
  boost::system::error_code ignored;
  acceptor_.close(ignored);
  return false;
}

void Sockets::listen() {
  const std::string& where = shared_.settings.listen;
  if (where == "off") return;
  const bool automatic = where == "auto";
  const tcp::endpoint asked = automatic
                                  ? tcp::endpoint(asio::ip::address_v4::loopback(), kUsualPort)
                                  : parse_address(where);
  boost::system::error_code error;
  bool listening = try_listen(asked, error);
  if (!listening && automatic) {
    note_ = "127.0.0.1:" + std::to_string(kUsualPort) +
            " is taken, another tp100d perhaps; --listen names a port";
    listening = try_listen({asked.address(), 0}, error);
  }
  if (!listening)
    throw UserError("--listen " + where + ": " + error.message() +
                    "; choose another address, port 0 or auto");
  const tcp::endpoint end = acceptor_.local_endpoint();
  own_.address = end.address().to_string();
  own_.port = end.port();
  const bool any = end.address().is_unspecified();
  const std::string host = any                     ? std::string("localhost")
                           : end.address().is_v6() ? "[" + own_.address + "]"
                                                   : own_.address;
  url_ = "http://" + host + ":" + std::to_string(end.port()) + "/";
}

void Sockets::start() {
  if (!url_.empty()) announcement_ = announce(own_);
  thread_ = std::thread([this] {
    // Before the other programs of a busy machine, if that is permitted.
    loop::apply_to_this_thread({.priority = shared_.settings.real_time ? loop::kBelowTheLoop : 0});
    if (acceptor_.is_open()) accept();
    asio::post(context_, [this] { tick(); });
    const auto failed = [this](const std::string& why) {
      asio::post(shared_.server_context,
                 [&publisher = publisher_, why] { publisher.failed(why, monotonic_now()); });
    };
    run_handlers(context_, failed, [this] { rest(); });
  });
  ::pthread_setname_np(thread_.native_handle(), "sockets");
}

void Sockets::accept() {
  acceptor_.async_accept([this](boost::system::error_code error, tcp::socket socket) {
    if (stopping_ || error == asio::error::operation_aborted) return;
    if (!error) {
      accept();
      return serve_connection(std::move(socket), shared_);
    }
    // Probably out of descriptors.
    pause_.expires_after(kAcceptPause);
    pause_.async_wait([this](boost::system::error_code cancelled) {
      if (!cancelled) accept();
    });
  });
}

// With its priority it would otherwise take a processor from the server thread and the main thread,
// whatever makes it compute.
void Sockets::rest() {
  const HostNs used_ns = thread_cpu_ns(), now = monotonic_now();
  const HostNs earned_ns = (now - std::exchange(at_ns_, now)) / kShareDivisor;
  const HostNs spent_ns = used_ns - std::exchange(used_ns_, used_ns);
  credit_ns_ = std::min(kMostCreditNs, credit_ns_ + earned_ns - spent_ns);
  if (credit_ns_ < 0)
    std::this_thread::sleep_for(std::chrono::nanoseconds(-credit_ns_ * kShareDivisor));
}

void Sockets::tick() {
  timer_.expires_after(kSecond);
  timer_.async_wait([this](boost::system::error_code error) {
    if (!error) tick();
  });
  const HostNs now = monotonic_now();
  shared_.viewer_budgets.tick(now);
  shared_.http_budgets.tick(now);
  messages::ClientsFigures figures = shared_.figures;
  figures.queue_limit = Outbox::kMaxData;
  const auto viewers = shared_.viewers;
  for (const auto& [id, weak] : viewers) {
    const auto viewer = weak.lock();
    if (viewer == nullptr) continue;
    figures.clients.push_back(viewer->figures(now));
    figures.dropped_total += figures.clients.back().dropped;
    viewer->tick(now);
  }
  asio::post(shared_.server_context,
             [&publisher = publisher_, figures = std::move(figures)]() mutable {
               publisher.take(std::move(figures), monotonic_now());
             });
}

void Sockets::stop() {
  if (!thread_.joinable()) return;
  asio::post(context_, [this] { begin_goodbyes(); });
  thread_.join();
}

void Sockets::begin_goodbyes() {
  stopping_ = true;
  boost::system::error_code ignored;
  acceptor_.close(ignored);
  timer_.cancel();
  pause_.cancel();
  const auto viewers = shared_.viewers;
  for (const auto& [id, weak] : viewers)
    if (const auto viewer = weak.lock()) viewer->go_away();
  stop_by_ns_ = monotonic_now() + kGoodbyeNs;
  await_goodbyes();
}

// Clients that do not answer in time are dropped.
void Sockets::await_goodbyes() {
  if (shared_.sockets == 0 || monotonic_now() > stop_by_ns_) return context_.stop();
  timer_.expires_after(kGoodbyeTick);
  timer_.async_wait([this](boost::system::error_code) { await_goodbyes(); });
}

}  // namespace tp100::server
