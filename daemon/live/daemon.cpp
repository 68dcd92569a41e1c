#include "live/daemon.h"

#include <cstdlib>
// Asio 1.74 uses std::exchange without including it.
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <csignal>
#include <memory>
#include <utility>

#include "core/board.h"
#include "core/clock.h"
#include "core/error.h"
#include "live/connector.h"
#include "live/daemon_parts.h"
#include "live/event_log.h"
#include "live/external_inputs.h"
#include "live/link_monitor.h"
#include "live/live_events.h"
#include "live/outcome.h"
#include "live/service_notice.h"
#include "live/stats_file.h"
#include "live/terminal.h"

namespace tp100::live {
namespace {
namespace asio = boost::asio;

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kTick{10}, kWorldTick{2};  // poses go to a world at a tick
// For disks, after the loop's end; the unit's TimeoutStopSec is longer.
constexpr std::chrono::seconds kLastWait{5};
constexpr std::chrono::milliseconds kLastLook{100};
constexpr HostNs kStatsPeriodNs = kNsPerS;

class Daemon {
 public:
  Daemon(const config::LoadedRun& run, const DaemonOptions& options);
  /// See run_daemon().
  int run();
  /// The run never began: its recording contains nothing useful.
  void discard() { parts_.recording.discard(); }

 private:
  void tick();
  void take_events();
  void take_status(HostNs now);
  void take_records();
  void change_setup(const SetupChanger::MadeChange& made);
  void drain_events();
  void on_session_state(SessionState state);
  void on_session(const SessionReport& report);
  void on_run_state(const RunChange& change);
  void notify_manager();
  void end();
  void take_figures();
  void await_signals();
  std::string course() const { return parts_.setup.in_force()->course(); }
  void finish_files();

  DaemonParts parts_;
  const DaemonOptions options_;
  EventLog log_;
  const ServiceSettings service_ = service_settings();
  ServiceNotice notice_{service_};
  asio::io_context context_;
  Connector connector_;
  RunRecordings run_recordings_;
  StatsFile stats_;
  LinkMonitor link_monitor_;
  std::optional<CameraPort> camera_;
  const config::WorldRun world_run_;
  std::unique_ptr<WorldLink> world_;  // null: internal
  std::vector<messages::Sink*> sinks_;
  const std::vector<ExchangeListener> exchange_listeners_{parts_.listeners(!options_.stay)};
  asio::steady_timer timer_{context_};
  asio::signal_set signals_{context_};
  DaemonFigures figures_;
  std::optional<Terminal> terminal_;  // from the loop's start on
  Outcome outcome_{options_.go, options_.stay};
  SessionState session_ = SessionState::kClosed;
  HostNs began_ns_ = 0;
  HostNs next_stats_ns_ = 0;
};

Daemon::Daemon(const config::LoadedRun& run, const DaemonOptions& options)
    : parts_(run, options),
      options_(options),
      connector_({.port = parts_.configuration.link.port,
                  .options = {.baud = parts_.configuration.link.baud,
                              .hang_up = parts_.configuration.link.hang_up},
                  .wait = options.wait,
                  .handover = parts_.self_test.wheels_up().handover()},
                 parts_.loop,
                 [this](const std::string& line) {
                   log_.info(line);
                   parts_.controls.note_port(line);
                 }),
      run_recordings_(parts_.recording, parts_.events,
                      options.stay && parts_.recording.figures().available),
      stats_(options.stats_path, parts_.disk, parts_.events),
      world_run_(config::world_run(run.setup)) {
  const config::Configuration& configuration = parts_.configuration;
  if (!configuration.camera.listen.empty())
    camera_.emplace(
        context_, configuration.camera,
        [this](const CameraSample& seen) { return parts_.cycle.camera(seen); },
        [this](HostNs at, std::string jpeg) { parts_.server.take_image(at, std::move(jpeg)); });
  world_ = open_world(
      context_, world_run_,
      [this](const WorldSample& received) { return parts_.cycle.world(received); }, parts_.events);
  sinks_ = {&parts_.self_test};
  sinks_.insert(sinks_.end(), options.sinks.begin(), options.sinks.end());
  sinks_.insert(sinks_.end(),
                {&link_monitor_, &parts_.recording, &parts_.black_box, &parts_.server});
  if (world_ != nullptr) sinks_.push_back(world_.get());
  figures_.page = parts_.server.url();
  // With --stay each run gets a recording of its own.
  if (!configuration.record.directory.empty() && !options.stay) parts_.recording.begin();
}

int Daemon::run() {
  std::vector<loop::Privilege> privileges = parts_.process.privileges();
  began_ns_ = monotonic_now();
  await_signals();
  take_figures();  // the first file of --stats waits for the disk, which nothing may do later
  parts_.loop.start();
  privileges.insert(privileges.end(), parts_.loop.privileges().begin(),
                    parts_.loop.privileges().end());
  const auto say = [this](const std::string& line, bool warning) { log_.say(line, warning); };
  const auto pressed = [this] { parts_.server.stop_pressed("keyboard"); };
  terminal_.emplace(&context_,
                    Terminal::Reach{parts_.controls, say, pressed, [this] { return course(); }});
  try {
    tick();
    log_.privileges(privileges);
    parts_.controls.set_privileges(privileges);
    parts_.server.start();
    if (!parts_.server.note().empty()) log_.warn(parts_.server.note());
    if (!figures_.page.empty()) log_.info("page: " + figures_.page);
    if (const std::string why = notice_.ready(); !why.empty()) log_.warn(why);
    notify_manager();
    context_.run();
  } catch (...) {
    // The port must outlive the loop that uses it.
    parts_.loop.request_stop();
    parts_.loop.join();
    throw;
  }
  parts_.loop.join();
  take_records();
  take_events();
  take_status(monotonic_now());
  finish_files();
  return outcome_.status();
}

void Daemon::await_signals() {
  // A log reader that goes away must not end a run without a disarm.
  std::signal(SIGPIPE, SIG_IGN);
  // Reaching the file size limit is an error like any other.
  std::signal(SIGXFSZ, SIG_IGN);
  signals_.add(SIGINT);
  signals_.add(SIGTERM);
  // The terminal was closed; under nohup the signal is already ignored.
  struct sigaction hang_up {};
  if (::sigaction(SIGHUP, nullptr, &hang_up) == 0 && hang_up.sa_handler == SIG_DFL)
    signals_.add(SIGHUP);
  signals_.async_wait([this](const boost::system::error_code& error, int signal) {
    if (error) return;
    log_.info(signal == SIGINT ? "SIGINT" : signal == SIGHUP ? "SIGHUP" : "SIGTERM");
    if (outcome_.interrupt()) end();
  });
}

// The robot is disarmed: now waiting for disks is allowed, for a limited time.
void Daemon::finish_files() {
  // Each look is short, so that the watchdog is fed between them.
  std::uint64_t cycles = parts_.loop.statistics().cycles.load();
  const auto deadline = Clock::now() + kLastWait;
  const auto wait = [&](const auto& done_by) {
    for (auto now = Clock::now(); !done_by(now + kLastLook); now = Clock::now()) {
      if (now >= deadline) return false;
      notice_.alive(++cycles, monotonic_now());
    }
    return true;
  };
  // The recording must include the last messages.
  parts_.server.flush();
  parts_.black_box.finish();
  const bool recorded = wait([&](auto by) { return parts_.recording.finish(by); });
  figures_.duration_s = to_s(monotonic_now() - began_ns_);
  take_figures();
  const bool idle = wait([&](auto by) { return parts_.disk.idle_by(by); });
  const bool answered = wait([&](auto by) { return world_ == nullptr || world_->ended_by(by); });
  drain_events();
  std::string lost;
  if (!recorded)
    lost += figures_.recording.active ? ", the end of " + figures_.recording.file : ", a black box";
  // What else the disk's thread does was asked for by viewers, who are not answered.
  if (!idle && stats_.waits()) lost += ", the last figures of --stats";
  if (!answered) lost += ", the last text of world.encoder_file";
  if (!lost.empty()) {
    outcome_.fail();
    log_.warn("a disk has not responded for 5 s; lost: " + lost.substr(2) +
              "; check the disks; tp100d recover repairs recordings");
  }
  log_.summary(summary_text(figures_));
  const bool all = recorded && idle && answered;
  const bool read = log_.flush();
  if (all && read && !parts_.server.waits_for_disk()) return;
  // The threads that wait for the disk, or for a reader of the log, cannot be joined.
  std::_Exit(outcome_.status());
}

void Daemon::notify_manager() {
  notice_.status(state_line(session_, outcome_.run(), course(), figures_.page));
}

void Daemon::on_session(const SessionReport& report) {
  if (acknowledges_stop(report.event)) parts_.server.stop_answered(report.event.at_ns);
  const bool identified = report.hello.boot_nonce != 0;
  const bool emulator = identified && is_emulator(connector_.pseudo_terminal(), report.hello.board);
  parts_.controls.set_session(report, connector_.path(), connector_.pseudo_terminal());
  parts_.controls.set_start({.emulator = emulator,
                             .go = options_.go,
                             .service = !service_.socket.empty(),
                             .ran_before = options_.ran_before});
  if (const auto* changed = link::as<link::StateChanged>(report.event))
    on_session_state(changed->to);
}

void Daemon::tick() {
  const HostNs now = monotonic_now();
  take_records();
  parts_.setup.tick();
  take_events();
  drain_events();
  connector_.tick(now);
  take_status(now);
  log_.tick(now);
  notice_.alive(parts_.loop.statistics().cycles.load(), now);
  run_recordings_.tick(now);
  const bool too_long = options_.duration_s && to_s(now - began_ns_) >= *options_.duration_s;
  if (too_long && outcome_.end(1, "duration")) end();
  if (outcome_.ending() && parts_.loop.ended()) {
    if (camera_) camera_->stop();
    if (world_ != nullptr) world_->stop();
    signals_.cancel();
    return;
  }
  if (now >= next_stats_ns_) {
    next_stats_ns_ = now + kStatsPeriodNs;
    parts_.process.keep();
    figures_.duration_s = to_s(now - began_ns_);
    take_figures();
  }
  const bool udp_world = world_run_.parameters.kind == bridge::WorldKind::kUdp;
  timer_.expires_after(udp_world ? kWorldTick : kTick);
  timer_.async_wait([this](const boost::system::error_code& error) {
    if (!error) tick();
  });
}

void Daemon::take_events() {
  LiveEvent event;
  while (parts_.cycle.take_event(event)) {
    const SessionReport* report = std::get_if<SessionReport>(&event);
    const RunChange* change = std::get_if<RunChange>(&event);
    // An event that ends the program is reported once, as the error.
    if (report != nullptr)
      connector_.on_event(*report, parts_.setup.in_force()->loaded.setup.robot.name,
                          monotonic_now());
    // Before the event is published, so that the recording includes it.
    if (change != nullptr) run_recordings_.on_run_state(change->to, change->at_ns);
    const std::vector<messages::Event> events = describe_event(event);
    log_.event(event, events);
    for (const messages::Event& one : events) parts_.server.take(one);
    if (report != nullptr) on_session(*report);
    if (change != nullptr) on_run_state(*change);
    if (std::holds_alternative<RequestDropped>(event)) terminal_->ask(monotonic_now());
  }
}

void Daemon::take_status(HostNs now) {
  if (!parts_.cycle.take_status(figures_.status)) return;
  log_.status(figures_.status, parts_.loop.statistics().overruns.load(), now);
}

void Daemon::take_records() {
  while (const StepRecord* record = parts_.cycle.front_record()) {
    if (const auto made = parts_.setup.take(*record)) change_setup(*made);
    for (messages::Sink* sink : sinks_) sink->take(*record);
    parts_.cycle.release_record();
  }
}

// Runs before anything else receives the first step with the change.
void Daemon::change_setup(const SetupChanger::MadeChange& made) {
  const messages::Event event{.at_ns = monotonic_now(), .kind = "setup", .text = made.text};
  if (made.exchange) {
    for (const ExchangeListener& listener : exchange_listeners_) listener(*made.exchange);
    terminal_->ask(event.at_ns);
    notify_manager();
  }
  log_.write({event});
  parts_.server.take(event);
  parts_.setup.finish();
}

void Daemon::on_session_state(SessionState next) {
  session_ = next;
  terminal_->follow(next);
  notify_manager();
  figures_.port = connector_.path();
  if (next != SessionState::kReady) return;
  if (course().empty() || outcome_.ending()) return;
  if (parts_.controls.start_consent() != StartConsent::kNone ||
      !parts_.controls.start_by_itself(connector_.came_later(), began_ns_, monotonic_now()))
    terminal_->ask(monotonic_now());
}

void Daemon::on_run_state(const RunChange& change) {
  const Outcome::Next next = outcome_.take(change);
  terminal_->follow(change.to);
  notify_manager();
  if (next == Outcome::Next::kEnd) return end();
  if (next == Outcome::Next::kSayAndAsk) log_.info(outcome_.result());
  if (next != Outcome::Next::kNothing) terminal_->ask(monotonic_now());
}

void Daemon::end() {
  parts_.controls.end();
  terminal_->stop();
  notice_.stopping();
  connector_.stop();
  parts_.loop.request_stop();
}

void Daemon::take_figures() {
  figures_.run = parts_.setup.in_force();
  figures_.result = outcome_.result();
  figures_.faults = outcome_.faults();
  if (camera_) figures_.camera = camera_->figures();
  if (world_ != nullptr) figures_.world = world_->figures();
  const auto was = std::exchange(figures_.recording, parts_.recording.figures());
  figures_.recording_cpu_s = parts_.recording.cpu_s();
  log_.recording(was, figures_.recording);
  figures_.loop = parts_.controls.loop();
  stats_.write(figures_);
}

void Daemon::drain_events() {
  if (camera_) link_monitor_.take(camera_->figures().detections);
  for (messages::Event& event : link_monitor_.drain_events()) parts_.events.post(std::move(event));
  for (const auto& [event, log_only] : parts_.events.drain()) {
    log_.write({event});
    if (!log_only) parts_.server.take(event);
  }
}

}  // namespace

int run_daemon(const config::LoadedRun& run, const DaemonOptions& options) {
  Daemon daemon(run, options);
  try {
    return daemon.run();
  } catch (const UserError&) {
    daemon.discard();
    throw;
  }
}

}  // namespace tp100::live
