#include "live/supervisor.h"

#include <algorithm>
#include <cstdlib>
// Asio 1.74 uses std::exchange without including it.
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <csignal>
#include <utility>

#include "core/board.h"
#include "core/clock.h"
#include "live/event_log.h"
#include "live/first_session.h"
#include "live/link_monitor.h"
#include "live/live_events.h"
#include "live/service_notice.h"
#include "live/stats_file.h"
#include "live/terminal.h"
#include "live/udp_ports.h"
#include "live/world_link.h"

namespace tp100::live {
namespace {
namespace asio = boost::asio;

constexpr std::chrono::milliseconds kTick{10}, kWorldTick{2};  // poses go to a world at a tick
constexpr HostNs kStatsPeriodNs = kNsPerS;
// Faults after which the robot may recover: without --go the daemon waits for a new start.
constexpr FaultMask kRecoverable = fault_bit(Fault::link_lost) | fault_bit(Fault::robot_rebooted) |
                                   fault_bit(Fault::stop_requested) | fault_bit(Fault::world_lost);

struct Supervisor {
  Supervisor(const SupervisorSettings& s, LiveCycle& c, loop::FixedRateLoop& l)
      : settings(s),
        cycle(c),
        loop(l),
        connector(s.connector, l,
                  [this](const std::string& line) {
                    log.info(line);
                    settings.controls.note_port(line);
                  }),
        first_session(connector, s.connector, s.setup_changer.run()->setup.robot.name),
        run_recordings(s.recording, s.events, s.stay && s.recording.figures().available),
        stats(s.stats_path, s.disk, s.events),
        timer(context),
        sinks(s.sinks) {}

  int run();
  void tick();
  void schedule_tick();
  void take_events();
  void take_status(HostNs now);
  void take_records();
  void change_setup(SetupChanger::Made made);
  void drain_events();
  void on_session_state(SessionState state);
  void on_session(const SessionReport& report);
  void on_run_state(const RunChange& change);
  void run_ended(int exit_status, const std::string& result);
  void begin_serving();
  void notify_manager();
  void serve(const SessionReport& report);
  void end(int exit_status, const std::string& result);
  void take_figures();
  void await_signals();
  void name(const config::RunSetup& run);
  void finish_files();

  SupervisorSettings settings;
  LiveCycle& cycle;
  loop::FixedRateLoop& loop;
  EventLog log;
  const ServiceSettings service = service_settings();
  ServiceNotice notice{service};
  asio::io_context context;
  Connector connector;
  FirstSession first_session;
  RunRecordings run_recordings;
  StatsFile stats;
  asio::steady_timer timer;
  asio::signal_set signals{context};
  std::unique_ptr<Terminal> terminal;
  std::vector<messages::Sink*> sinks;
  LinkMonitor link_monitor;
  std::unique_ptr<CameraPort> camera;
  std::unique_ptr<WorldLink> world;  // null: internal
  std::vector<loop::Privilege> privileges;
  DaemonFigures figures;
  RunState run_state = RunState::kIdle;
  SessionState session = SessionState::kClosed;
  HostNs began_ns = 0;
  HostNs next_stats_ns = 0;
  bool ending = false;
  int status = 1;
  int stay_status = 0;  // exit status of the last run, with --stay
};

int Supervisor::run() {
  figures.result = "running";
  name(settings.setup_changer.run()->setup);
  privileges = settings.process.privileges();
  began_ns = monotonic_now();
  sinks.insert(sinks.end(),
               {&link_monitor, &settings.recording, &settings.black_box, &settings.server});
  figures.page = settings.server.url();
  await_signals();
  if (!settings.camera.listen.empty())
    camera = std::make_unique<CameraPort>(
        context, settings.camera, [this](const CameraSample& seen) { return cycle.camera(seen); },
        [this](HostNs at, std::string jpeg) { settings.server.take_image(at, std::move(jpeg)); });
  world = open_world(
      context, settings.world,
      [this](const WorldSample& received) { return cycle.world(received); }, settings.events);
  if (world != nullptr) sinks.push_back(world.get());
  loop.start();
  privileges.insert(privileges.end(), loop.privileges().begin(), loop.privileges().end());
  const auto say = [this](const std::string& line, bool warning) { log.say(line, warning); };
  const auto pressed = [this] { settings.server.stop_pressed("keyboard"); };
  terminal = std::make_unique<Terminal>(
      &context, Terminal::Reach{settings.controls, say, pressed, figures.course});
  try {
    tick();
    log.privileges(privileges);
    begin_serving();
    context.run();
  } catch (...) {
    // The port must outlive the loop that uses it.
    loop.request_stop();
    loop.join();
    throw;
  }
  loop.join();
  take_records();
  take_events();
  take_status(monotonic_now());
  finish_files();
  return status;
}

void Supervisor::await_signals() {
  // A log reader that goes away must not end a run without a disarm.
  std::signal(SIGPIPE, SIG_IGN);
  // Reaching the file size limit is an error like any other.
  std::signal(SIGXFSZ, SIG_IGN);
  signals.add(SIGINT);
  signals.add(SIGTERM);
  // The terminal was closed; under nohup the signal is already ignored.
  struct sigaction hang_up {};
  if (::sigaction(SIGHUP, nullptr, &hang_up) == 0 && hang_up.sa_handler == SIG_DFL)
    signals.add(SIGHUP);
  signals.async_wait([this](const boost::system::error_code& error, int signal) {
    if (error) return;
    log.info(signal == SIGINT ? "SIGINT" : signal == SIGHUP ? "SIGHUP" : "SIGTERM");
    end(settings.stay && !under_way(run_state) ? stay_status : 1, "interrupted");
  });
}

void Supervisor::name(const config::RunSetup& run) {
  figures.course = run.course == nullptr ? "" : run.course->name;
  figures.robot = run.robot.name;
  figures.setup = bridge::to_string(run.parameters.setup);
}

// The robot is disarmed: now waiting for disks is allowed, for a limited time.
void Supervisor::finish_files() {
  LastWait wait(notice, loop.statistics().cycles.load());
  // The recording must include the last messages.
  settings.server.flush();
  settings.black_box.finish();
  const bool recorded = wait([&](auto by) { return settings.recording.finish(by); });
  figures.duration_s = to_s(monotonic_now() - began_ns);
  take_figures();
  const bool written = wait([&](auto by) { return settings.disk.idle_by(by); });
  const bool answered = wait([&](auto by) { return world == nullptr || world->ended_by(by); });
  drain_events();
  std::string lost;
  if (!recorded)
    lost += figures.recording.active ? ", the end of " + figures.recording.file : ", a black box";
  if (!written) lost += ", the last figures of --stats";
  if (!answered) lost += ", the last text of world.encoder_file";
  if (!lost.empty()) {
    status = std::max(status, 1);
    log.warn("a disk has not responded for 5 s; lost: " + lost.substr(2) +
             "; check the disks; tp100d recover repairs recordings");
  }
  log.summary(summary_text(figures));
  const bool examined = wait([&](auto by) { return settings.controls.examined_by(by); });
  const bool all = recorded && written && answered && examined;
  const bool read = log.flush();
  if (all && read && !settings.server.waits_for_disk()) return;
  // The threads that wait for the disk, or for a reader of the log, cannot be joined.
  std::_Exit(status);
}

void Supervisor::begin_serving() {
  settings.controls.set_privileges(privileges);
  settings.server.start();
  if (!settings.server.note().empty()) log.warn(settings.server.note());
  if (!figures.page.empty()) log.info("page: " + figures.page);
  if (const std::string why = notice.ready(); !why.empty()) log.warn(why);
  notify_manager();
}

void Supervisor::notify_manager() {
  notice.status(state_line(session, run_state, figures.course, figures.page));
}

void Supervisor::serve(const SessionReport& report) {
  if (acknowledges_stop(report.event)) settings.server.stop_answered(report.event.at_ns);
  const bool identified = report.hello.boot_nonce != 0;
  const bool emulator = identified && is_emulator(connector.pseudo_terminal(), report.hello.board);
  settings.controls.set_session(report, connector.path(), connector.pseudo_terminal());
  settings.controls.set_start({.emulator = emulator,
                               .go = settings.go,
                               .service = !service.socket.empty(),
                               .ran_before = settings.ran_before});
}

void Supervisor::schedule_tick() {
  const bool udp_world = settings.world.parameters.kind == bridge::WorldKind::kUdp;
  timer.expires_after(udp_world ? kWorldTick : kTick);
  timer.async_wait([this](const boost::system::error_code& error) {
    if (!error) tick();
  });
}

void Supervisor::tick() {
  const HostNs now = monotonic_now();
  take_records();
  settings.setup_changer.tick();
  take_events();
  drain_events();
  first_session.check(now);
  connector.tick(now);
  take_status(now);
  log.tick(now);
  notice.alive(loop.statistics().cycles.load(), now);
  run_recordings.tick(now);
  if (settings.duration_s && to_s(now - began_ns) >= *settings.duration_s) end(1, "duration");
  if (ending && loop.ended()) {
    if (camera != nullptr) camera->stop();
    if (world != nullptr) world->stop();
    signals.cancel();
    return;
  }
  if (now >= next_stats_ns) {
    next_stats_ns = now + kStatsPeriodNs;
    settings.process.keep();
    figures.duration_s = to_s(now - began_ns);
    take_figures();
  }
  schedule_tick();
}

void Supervisor::take_events() {
  LiveEvent event;
  while (cycle.take_event(event)) {
    const SessionReport* report = std::get_if<SessionReport>(&event);
    const RunChange* change = std::get_if<RunChange>(&event);
    // An event that ends the program is reported once, as the error.
    if (report != nullptr) first_session.on_event(*report);
    // Before the event is published, so that the recording includes it.
    if (change != nullptr) run_recordings.on_run_state(change->to, change->at_ns);
    const std::vector<messages::Event> events = describe_event(event);
    log.event(event, events);
    for (const messages::Event& one : events) settings.server.take(one);
    if (report != nullptr) on_session(*report);
    if (change != nullptr) on_run_state(*change);
    if (std::holds_alternative<RequestDropped>(event)) terminal->ask(monotonic_now());
  }
}

void Supervisor::on_session(const SessionReport& report) {
  serve(report);
  if (link::as<link::HelloReceived>(report.event) != nullptr) {
    connector.robot_found();
  } else if (const auto* changed = link::as<link::StateChanged>(report.event)) {
    on_session_state(changed->to);
  }
}

void Supervisor::take_status(HostNs now) {
  if (!cycle.take_status(figures.status)) return;
  log.status(figures.status, loop.statistics().overruns.load(), now);
}

void Supervisor::take_records() {
  while (const StepRecord* record = cycle.front_record()) {
    if (auto made = settings.setup_changer.take(*record)) change_setup(std::move(*made));
    for (messages::Sink* sink : sinks) sink->take(*record);
    cycle.release_record();
  }
}

// Runs before anything else receives the first step with the change.
void Supervisor::change_setup(SetupChanger::Made made) {
  const messages::Event event{.at_ns = monotonic_now(), .kind = "setup", .text = made.text};
  if (made.run != nullptr) {
    const config::RunSetup& run = made.run->setup;
    name(run);
    const bool goes_on = settings.recording.number() != 0 && !settings.stay;
    settings.black_box.finish();
    settings.recording.change_setup(made.run, made.step);
    settings.server.change_setup(made.run_context, std::move(made.for_viewers),
                                 parameter_list(run.configuration, run.robot));
    for (messages::Sink* sink : sinks) sink->take_setup(made.run_context, event.at_ns);
    if (settings.ros2 != nullptr)
      settings.ros2->change_setup(made.run_context, std::move(made.for_nodes));
    if (goes_on) settings.recording.start({}, [](const std::string&) {});
    first_session.expect(figures.robot);
    terminal->follow(figures.course);
    terminal->ask(event.at_ns);
    notify_manager();
  }
  log.write({event});
  settings.server.take(event);
  settings.setup_changer.finish();
}

void Supervisor::on_session_state(SessionState next) {
  session = next;
  first_session.on_state(next, monotonic_now());
  terminal->follow(next);
  notify_manager();
  figures.port = connector.path();
  if (next != SessionState::kReady) return;
  connector.session_ready();
  if (figures.course.empty() || ending) return;
  if (settings.controls.start_consent() != StartConsent::kNone ||
      !settings.controls.start_by_itself(connector.came_later(), began_ns, monotonic_now()))
    terminal->ask(monotonic_now());
}

void Supervisor::on_run_state(const RunChange& change) {
  const bool by_hand = change.from == RunState::kDriving;
  run_state = change.to;
  terminal->follow(change.to);
  notify_manager();
  if (change.to == RunState::kFinished) return run_ended(0, "completed");
  // A run requested by an option does not wait for another start.
  if (change.refused != StartRefusal::kNone && settings.go) return run_ended(1, "refused");
  if (change.to == RunState::kAborted) {
    figures.faults = change.faults | (change.from == change.to ? figures.faults : 0);
    if (ending && status == 0) {
      // The completed run has failed after all.
      status = 1;
      figures.result = "aborted";
    }
    // After driving by hand, keep the daemon running.
    const bool recoverable = by_hand || (figures.faults & kRecoverable) != 0;
    const bool waits =
        recoverable && !settings.go && (figures.faults & fault_bit(Fault::moves_unasked)) == 0;
    if (!by_hand) stay_status = 1;
    if (!waits) return run_ended(1, "aborted");
  }
  if (!ending) terminal->ask(monotonic_now());
}

void Supervisor::run_ended(int exit_status, const std::string& result) {
  if (!settings.stay) return end(exit_status, result);
  stay_status = exit_status;
  figures.result = result;
  log.info(result);
  terminal->ask(monotonic_now());
}

void Supervisor::end(int exit_status, const std::string& result) {
  if (std::exchange(ending, true)) return;
  first_session.stop();
  settings.controls.end();
  terminal->stop();
  notice.stopping();
  status = exit_status;
  figures.result = result;
  connector.stop();
  loop.request_stop();
}

void Supervisor::take_figures() {
  if (camera != nullptr) figures.camera = camera->figures();
  if (world != nullptr) figures.world = world->figures();
  const auto was = std::exchange(figures.recording, settings.recording.figures());
  figures.recording_cpu_s = settings.recording.cpu_s();
  log.recording(was, figures.recording);
  figures.loop = settings.controls.loop();
  stats.write(figures);
}

void Supervisor::drain_events() {
  if (camera != nullptr) link_monitor.take(camera->figures().detections);
  for (messages::Event& event : link_monitor.drain_events()) settings.events.post(std::move(event));
  for (const auto& [event, log_only] : settings.events.drain()) {
    log.write({event});
    if (!log_only) settings.server.take(event);
  }
}

}  // namespace

int supervise(const SupervisorSettings& settings, LiveCycle& cycle, loop::FixedRateLoop& loop) {
  return Supervisor(settings, cycle, loop).run();
}

}  // namespace tp100::live
