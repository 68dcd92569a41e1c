#include "server/server.h"

#include <pthread.h>

#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/clock.h"
#include "messages/status_messages.h"
#include "server/local_daemons.h"
#include "server/sockets.h"
#include "text/json_writer.h"

namespace tp100::server {
namespace {

namespace asio = boost::asio;

constexpr auto kTick = std::chrono::milliseconds(50);
constexpr auto kFlush = std::chrono::seconds(1);
constexpr HostNs kStandsStillNs = kNsPerS;

/// Steps on their way to the worker: a ring of whole records that drops the oldest.
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

// The worker: everything that viewers ask for and get, except STOP, is made here.
struct Server::State {
  State(ServerSettings s, const messages::Messages& messages,
        std::vector<messages::ParameterText> parameters, Controls& c)
      : robots(s.robots),
        sources(std::move(s.content)),
        broker(messages::channel_texts(), std::move(s.listener)),
        publisher(broker, messages, c),
        session(random_name()),
        handler(broker, publisher, c, std::move(parameters), std::move(s.services), session,
                s.name) {
    sources.health = [this] { return health(); };
    sources.robots = [this](std::string_view host) {
      return robots_json(sockets->own(), local_daemons(), robots, host);
    };
    sources.history = [this](std::string_view topic) { return publisher.history().json(topic); };
    const auto report = [this](messages::ClientsFigures figures) {
      asio::post(context, [this, f = std::move(figures)]() mutable { take(std::move(f)); });
    };
    const auto fail = [this](const std::string& why) {
      asio::post(context, [this, why] { failed(why); });
    };
    sockets.emplace(std::move(s), c, context, broker, handler, sources, session, report, fail);
  }

  void tick();
  void failed(const std::string& why);
  void take(messages::ClientsFigures figures);
  void take_records();
  std::string health() const;

  const std::vector<std::string> robots;
  HttpSources sources;
  Broker broker;
  Publisher publisher;
  const std::string session;
  RequestHandler handler;
  Inbox inbox;
  StepRecord record{};
  std::atomic<bool> woken{false};
  // Declared after the objects that its handlers refer to.
  asio::io_context context{1};
  asio::executor_work_guard<asio::io_context::executor_type> guard{context.get_executor()};
  asio::steady_timer timer{context};
  std::optional<Sockets> sockets;  // what waits for the worker refers to them
  std::thread thread;
};

void Server::State::take_records() {
  woken = false;
  while (inbox.pop(record)) publisher.take(record);
  handler.tick(monotonic_now());
}

void Server::State::take(messages::ClientsFigures figures) {
  for (messages::ClientFigures& each : figures.clients)
    for (const auto& viewer : broker.viewers())
      if (viewer->id() == each.id) each.subscriptions = viewer->subscriptions().size();
  broker.publish(messages::Channel::kClient, publisher.clock().unix_ns(monotonic_now()),
                 messages::clients_message(figures));
}

void Server::State::tick() {
  timer.expires_after(kTick);
  timer.async_wait([this](boost::system::error_code error) {
    if (!error) tick();
  });
  const HostNs now = monotonic_now();
  publisher.tick(now);
  handler.tick(now);
}

void Server::State::failed(const std::string& why) {
  publisher.take(messages::Event{.at_ns = monotonic_now(),
                                 .level = messages::Event::Level::kError,
                                 .text = "the server could not do what a viewer asked for",
                                 .cause = why});
}

std::string Server::State::health() const {
  const HostNs now = monotonic_now();
  return text::json_object([&](text::JsonWriter& json) {
    json.field("ok", now - publisher.last_step_ns() < kStandsStillNs)
        .field("version", publisher.run_context().version)
        .field("uptime_s", publisher.clock().t_s(now))
        .field("run", to_string(publisher.state().run))
        .field("session", to_string(publisher.state().session))
        .field("clients", broker.viewers().size());
  });
}

Server::Server(ServerSettings settings, const messages::Messages& messages,
               std::vector<messages::ParameterText> parameters, Controls& controls)
    : state_(std::make_unique<State>(std::move(settings), messages, std::move(parameters),
                                     controls)) {}

Server::~Server() {
  if (!state_->thread.joinable()) return;
  state_->sockets->stop();
  // After what the sockets have left to do.
  asio::post(state_->context, [this] { state_->context.stop(); });
  state_->thread.join();
}

const std::string& Server::url() const { return state_->sockets->url(); }
const std::string& Server::note() const { return state_->sockets->note(); }

void Server::start() {
  state_->thread = std::thread([this] {
    asio::post(state_->context, [this] { state_->tick(); });
    run_handlers(
        state_->context, [this](const std::string& why) { state_->failed(why); }, [] {});
  });
  ::pthread_setname_np(state_->thread.native_handle(), "server");
  state_->sockets->start();
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

bool Server::waits_for_disk() { return state_->sockets->waits_for_disk(); }

std::uint64_t Server::lost_records() const { return state_->inbox.lost(); }

}  // namespace tp100::server
