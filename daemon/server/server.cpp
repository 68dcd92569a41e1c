#include "server/server.h"

#include <pthread.h>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <new>
#include <thread>
#include <utility>
#include <variant>

#include "core/clock.h"
#include "server/local_daemons.h"
#include "server/publisher.h"
#include "server/request_handler.h"
#include "server/sockets.h"
#include "text/json_writer.h"

namespace tp100::server {
namespace {

namespace asio = boost::asio;

constexpr auto kTick = std::chrono::milliseconds(50);
constexpr auto kFlush = std::chrono::seconds(1);
constexpr HostNs kStandsStillNs = kNsPerS;
constexpr std::size_t kMaxSteps = 64;

/// A step, or what another set-up changes before the next one.
using StepOrChange = std::variant<StepRecord, std::function<void()>>;

}  // namespace

// The server thread: everything that viewers ask for and get, except STOP, is made here.
struct Server::State {
  State(ServerSettings settings, const messages::Messages& messages,
        std::vector<messages::ParameterText> parameters, Controls& controls)
      : sources(std::move(settings.content)),
        broker(messages::channel_texts(), std::move(settings.listener)),
        publisher(broker, messages, controls),
        session_id(random_name()),
        handler(broker, publisher, controls, std::move(parameters), std::move(settings.services),
                session_id, settings.name),
        sockets(settings, controls, context, broker, publisher, handler, sources, session_id) {
    sources.health = [this] { return health(); };
    sources.robots = [this, robots = settings.robots](std::string_view host) {
      return robots_json(sockets.own(), local_daemons(), robots, host);
    };
    sources.history = [this](std::string_view topic, double span_s) {
      return publisher.history().json(topic, span_s);
    };
  }

  void push(StepOrChange next);
  void take_all();
  void tick();
  std::string health() const;

  HttpSources sources;
  Broker broker;
  Publisher publisher;
  const std::string session_id;
  RequestHandler handler;
  std::mutex mutex;  // of the next
  // On their way to the server thread, in order; the oldest steps are dropped.
  std::deque<StepOrChange> taken;
  // Declared after the objects that its handlers refer to.
  asio::io_context context{1};
  asio::executor_work_guard<asio::io_context::executor_type> guard{context.get_executor()};
  asio::steady_timer timer{context};
  Sockets sockets;  // what waits for the server thread refers to them
  std::thread thread;
};

void Server::State::push(StepOrChange next) {
  const std::lock_guard lock(mutex);
  if (taken.empty()) asio::post(context, [this] { take_all(); });
  if (taken.size() >= kMaxSteps && std::holds_alternative<StepRecord>(taken.front()))
    taken.pop_front();
  taken.push_back(std::move(next));
}

void Server::State::take_all() {
  for (StepOrChange next;;) {
    {
      const std::lock_guard lock(mutex);
      if (taken.empty()) break;
      next = std::move(taken.front());
      taken.pop_front();
    }
    if (const StepRecord* record = std::get_if<StepRecord>(&next)) {
      publisher.take(*record);
    } else {
      std::get<1>(next)();
    }
  }
  handler.tick(monotonic_now());
}

void Server::State::tick() {
  timer.expires_after(kTick);
  timer.async_wait([this](boost::system::error_code error) {
    if (!error) tick();
  });
  publisher.tick(monotonic_now());
  // Also what an error has left.
  take_all();
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
  state_->sockets.stop();
  // After what the sockets have left to do.
  asio::post(state_->context, [this] { state_->context.stop(); });
  state_->thread.join();
}

const std::string& Server::url() const { return state_->sockets.url(); }
const std::string& Server::note() const { return state_->sockets.note(); }

void Server::start() {
  state_->thread = std::thread([this] {
    asio::post(state_->context, [this] { state_->tick(); });
    run_handlers(
        state_->context,
        [this](const std::string& why) { state_->publisher.failed(why, monotonic_now()); }, [] {});
  });
  ::pthread_setname_np(state_->thread.native_handle(), "server");
  state_->sockets.start();
}

void Server::exchange(messages::RunContext run_context, messages::SharedMessages setup,
                      std::vector<messages::ParameterText> parameters) {
  state_->push([this, m = std::move(run_context), s = std::move(setup), p = std::move(parameters)] {
    const HostNs now = monotonic_now();
    state_->publisher.exchange(m, s, now);
    state_->handler.exchange(p, now);
  });
}

void Server::take(const StepRecord& record) {
  try {
    state_->push(record);
  } catch (const std::bad_alloc&) {
    // Viewers miss a step; the robot drives on.
  }
}

void Server::take(const messages::Event& event) {
  asio::post(state_->context, [this, event] { state_->publisher.take(event); });
}

void Server::take_image(HostNs at, std::string jpeg) {
  asio::post(state_->context,
             [this, at, image = std::move(jpeg)] { state_->publisher.take_image(at, image); });
}

void Server::stop_pressed(const std::string& by) {
  asio::post(state_->context,
             [this, by, now = monotonic_now()] { state_->publisher.stop_pressed(by, now); });
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

bool Server::waits_for_disk() { return state_->sockets.waits_for_disk(); }

}  // namespace tp100::server
