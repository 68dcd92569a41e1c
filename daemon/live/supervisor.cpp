#include "live/supervisor.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
// Asio 1.74 uses std::exchange without including it.
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <utility>

#include "core/angle.h"
#include "core/clock.h"
#include "core/error.h"
#include "core/start_rule.h"
#include "live/camera_port.h"
#include "live/event_log.h"
#include "live/link_watch.h"
#include "live/live_events.h"
#include "live/live_world.h"
#include "live/run_recorder.h"
#include "live/service_notice.h"
#include "live/stats_file.h"
#include "live/terminal.h"

namespace tp100::live {
namespace {

namespace asio = boost::asio;
using Kind = link::SessionEvent::Kind;

constexpr auto kTick = std::chrono::milliseconds(10);
constexpr HostNs kStatsPeriodNs = kNsPerS;
// A board needs 2 s after its reset, and a handshake less; a silent port is given up sooner.
constexpr HostNs kFirstSessionNs = 6 * kNsPerS;
// How long the end of the program waits for disks; the unit's TimeoutStopSec is longer.
constexpr auto kDiskPatience = std::chrono::seconds(5);
constexpr auto kDiskLook = std::chrono::milliseconds(100);
// Causes after which the robot may come back: without --go the daemon waits for a new start.
constexpr FaultMask kRecoverable = fault_bit(Fault::link_lost) | fault_bit(Fault::robot_rebooted) |
                                   fault_bit(Fault::stop_requested) | fault_bit(Fault::world_lost);

}  // namespace

struct Supervisor::State {
  State(const SupervisorSettings& s, LiveCycle& c, loop::FixedRateLoop& l)
      : settings(s),
        cycle(c),
        loop(l),
        connector(s.connector, l, [this](const std::string& line) { log.info(line); }),
        run_recorder(*s.recording, s.stay && s.recording->figures().available),
        stats(s.stats_path, *s.disk),
        signals(context),
        timer(context) {}

  int run();
  void tick();
  void schedule_tick();
  void take_events();
  void take_status(HostNs now);
  void take_records();
  void note_link();
  void fail_early(const LiveEvent& event) const;
  void fail_without_session(HostNs now) const;
  void on_session(const LiveEvent& event);
  void on_session_state(SessionState state);
  void on_run_state(const LiveEvent& event);
  void run_ended(int exit_status, const std::string& result);
  void begin_serving();
  void tell_manager();
  void serve(const LiveEvent& event, const std::vector<messages::Event>& words);
  void take_signals();
  void end(int exit_status, const std::string& result);
  void take_figures();
  void take_recording();
  void take_notes();
  void finish_files();
  void summarize() const;

  SupervisorSettings settings;
  LiveCycle& cycle;
  loop::FixedRateLoop& loop;
  EventLog log;
  const ServiceSettings service = service_settings();
  ServiceNotice notice{service};
  asio::io_context context;
  Connector connector;
  RunRecorder run_recorder;
  StatsFile stats;
  asio::signal_set signals;
  asio::steady_timer timer;
  std::unique_ptr<Terminal> terminal;
  std::vector<messages::Sink*> sinks;
  LinkWatch link_watch;
  std::unique_ptr<CameraPort> camera;
  std::unique_ptr<LiveWorld> world;
  std::vector<loop::Grant> grants;
  RunFigures figures;
  RunState run_state = RunState::kIdle;
  SessionState session = SessionState::kClosed;
  HostNs began_ns = 0;
  HostNs next_stats_ns = 0;
  HostNs first_tried_ns = 0;  // since when a port that is the robot's, as far as known, is open
  std::string refusal;
  bool had_session = false;
  bool ending = false;
  int status = 1;
  int stay_status = 0;  // of the last run, for who stays
};

Supervisor::Supervisor(const SupervisorSettings& settings, LiveCycle& cycle,
                       loop::FixedRateLoop& loop)
    : state_(std::make_unique<State>(settings, cycle, loop)) {}
Supervisor::~Supervisor() = default;
void Supervisor::add_sink(messages::Sink& sink) { state_->sinks.push_back(&sink); }
int Supervisor::run() { return state_->run(); }

int Supervisor::State::run() {
  figures.result = "running";
  figures.course = settings.course;
  figures.robot = settings.robot;
  figures.setup = settings.setup;
  grants = settings.process_grants;
  began_ns = monotonic_now();
  sinks.push_back(&link_watch);
  sinks.push_back(settings.recording);
  sinks.push_back(settings.black_box);
  sinks.push_back(settings.server);
  figures.page = settings.server->url();
  take_signals();
  if (!settings.camera.listen.empty()) {
    camera = std::make_unique<CameraPort>(
        context, settings.camera, [this](const CameraSample& seen) { return cycle.camera(seen); });
  }
  world = std::make_unique<LiveWorld>(
      context, settings.world, [this](const WorldSample& said) { return cycle.world(said); });
  sinks.push_back(world.get());
  loop.start();
  grants.insert(grants.end(), loop.grants().begin(), loop.grants().end());
  terminal = std::make_unique<Terminal>(
      context, Terminal::Reach{cycle, *settings.controls, *settings.server, log, settings.course});
  try {
    tick();
    log.grants(grants);
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

// The robot is disarmed: now disks may be waited for, but not for ever.
void Supervisor::State::finish_files() {
  const auto deadline = std::chrono::steady_clock::now() + kDiskPatience;
  // Each look is short, so that the watchdog is fed between them.
  const auto wait = [&](const auto& done_by) {
    for (std::uint64_t turns = loop.statistics().turns.load() + 1;; ++turns) {
      const auto now = std::chrono::steady_clock::now();
      if (done_by(now + kDiskLook)) return true;
      if (now >= deadline) return false;
      notice.alive(turns, monotonic_now());
    }
  };
  // What happened last is to be in the recording.
  settings.server->flush();
  settings.black_box->finish();
  const bool recorded = wait([&](auto by) { return settings.recording->finish(by); });
  figures.duration_s = to_s(monotonic_now() - began_ns);
  take_figures();
  const bool written = wait([&](auto by) { return settings.disk->idle_by(by); });
  const bool answered = wait([&](auto by) { return world->ended_by(by); });
  take_notes();
  std::string lost;
  if (!recorded && figures.recording.active) lost += ", the end of " + figures.recording.file;
  if (!written) lost += ", the last figures of --stats or a black box";
  if (!answered) lost += ", the last text of world.encoder_file";
  if (!lost.empty()) {
    status = std::max(status, 1);
    log.warn("a disk has stood still for 5 s, lost: " + lost.substr(2) +
             "; check the disks, tp100d recover makes recordings whole");
  }
  summarize();
  if (recorded && written && answered && !settings.server->waits_for_disk()) return;
  // The threads that wait for it cannot be joined.
  log.flush();
  std::_Exit(status);
}

void Supervisor::State::begin_serving() {
  settings.controls->set_grants(grants);
  settings.server->start();
  if (!settings.server->note().empty()) log.warn(settings.server->note());
  if (!figures.page.empty()) log.info("page: " + figures.page);
  if (const std::string why = notice.ready(); !why.empty()) log.warn(why);
  tell_manager();
}

void Supervisor::State::tell_manager() {
  std::string line = "link " + std::string(to_string(session)) + ", run ";
  line += to_string(run_state);
  if (!settings.course.empty()) line += ", course " + settings.course;
  if (!figures.page.empty()) line += "; page " + figures.page;
  notice.status(line);
}

void Supervisor::State::serve(const LiveEvent& event, const std::vector<messages::Event>& words) {
  if (acknowledges_stop(event)) settings.server->stop_answered(event.at_ns);
  for (const messages::Event& word : words) settings.server->take(word);
  if (event.kind != LiveEvent::Kind::kSession) return;
  const bool greeted = event.hello.boot_nonce != 0;
  const bool emulator = greeted && is_emulator(connector.pseudo_terminal(), event.hello.board);
  settings.controls->set_port({.path = connector.path(),
                               .physical = !emulator,
                               .firmware = greeted ? firmware_text(event.hello) : std::string()});
  settings.controls->set_start({.emulator = emulator,
                                .go = settings.go,
                                .service = !service.socket.empty(),
                                .ran_before = settings.ran_before});
}

void Supervisor::State::take_signals() {
  // Who closes the log must not end a run without a disarm.
  std::signal(SIGPIPE, SIG_IGN);
  // A file that may not grow any more is an error like any other.
  std::signal(SIGXFSZ, SIG_IGN);
  signals.add(SIGINT);
  signals.add(SIGTERM);
  // The terminal is closed; nohup ignores that before the start.
  struct sigaction hang_up {};
  if (::sigaction(SIGHUP, nullptr, &hang_up) == 0 && hang_up.sa_handler == SIG_DFL) {
    signals.add(SIGHUP);
  }
  signals.async_wait([this](const boost::system::error_code& error, int signal) {
    if (error) return;
    log.info(signal == SIGINT ? "SIGINT" : signal == SIGHUP ? "SIGHUP" : "SIGTERM");
    const bool under_way = run_state == RunState::kArming || run_state == RunState::kRunning;
    end(settings.stay && !under_way ? stay_status : 1, "interrupted");
  });
}

void Supervisor::State::schedule_tick() {
  timer.expires_after(kTick);
  timer.async_wait([this](const boost::system::error_code& error) {
    if (!error) tick();
  });
}

void Supervisor::State::tick() {
  const HostNs now = monotonic_now();
  take_records();
  take_events();
  note_link();
  fail_without_session(now);
  connector.tick(now);
  take_status(now);
  log.tick(now);
  notice.alive(loop.statistics().turns.load(), now);
  if (const std::string note = world->take_note(); !note.empty()) log.info(note);
  take_notes();
  run_recorder.tick(now);
  if (settings.duration_s && to_s(now - began_ns) >= *settings.duration_s) end(1, "duration");
  if (ending && loop.ended()) {
    if (camera != nullptr) camera->stop();
    world->stop();
    signals.cancel();
    return;
  }
  if (now >= next_stats_ns) {
    next_stats_ns = now + kStatsPeriodNs;
    figures.duration_s = to_s(now - began_ns);
    take_figures();
    if (settings.verbose) log.times(settings.controls->loop());
  }
  schedule_tick();
}

void Supervisor::State::take_events() {
  LiveEvent event;
  while (cycle.take_event(event)) {
    // What ends the program is said once, by the error.
    if (event.kind == LiveEvent::Kind::kSession) fail_early(event);
    // Before anybody is told, so that the recording has it.
    if (event.kind == LiveEvent::Kind::kRunState) run_recorder.on_run_state(event.to, event.at_ns);
    const std::vector<messages::Event> words = words_for(event);
    log.event(event, words);
    serve(event, words);
    if (event.kind == LiveEvent::Kind::kRunState) {
      on_run_state(event);
    } else {
      on_session(event);
    }
  }
}

void Supervisor::State::take_status(HostNs now) {
  if (!cycle.take_status(figures.status)) return;
  log.status(figures.status, loop.statistics().overruns.load(), now);
}

void Supervisor::State::take_records() {
  while (const StepRecord* record = cycle.front_record()) {
    for (messages::Sink* sink : sinks) sink->take(*record);
    cycle.release_record();
  }
}

// Before the first session a robot that does not fit is an error, unless someone asked to wait.
void Supervisor::State::fail_early(const LiveEvent& event) const {
  if (settings.connector.wait || had_session || ending) return;
  if (event.session.kind == Kind::kVersionMismatch) {
    throw SetupError(connector.path() + ": " + version_mismatch(event.hello));
  }
  if (event.session.kind == Kind::kUnanswered || event.session.kind == Kind::kBadHello) {
    const messages::Event words = words_for(event).front();
    throw SetupError(connector.path() + ": " + words.cause + "; " + words.remedy);
  }
  const bool refused = event.session.kind == Kind::kAcknowledged &&
                       event.session.a == static_cast<std::int32_t>(wire::Type::kParameters) &&
                       event.session.b == static_cast<std::int32_t>(wire::Result::kOutOfRange);
  if (refused) {
    throw SetupError("robot " + settings.robot + ": the firmware refuses " +
                     bridge::parameter_name(event.session.detail) +
                     " as out of range; correct it in the robot file");
  }
}

void Supervisor::State::fail_without_session(HostNs now) const {
  if (settings.connector.wait || had_session || ending || first_tried_ns == 0) return;
  if (now - first_tried_ns < kFirstSessionNs) return;
  throw SetupError(connector.path() + ": no session with the robot came about in " +
                   std::to_string(kFirstSessionNs / kNsPerS) + " s, last state " +
                   std::string(to_string(session)) +
                   ": its hello or its answers are none of this version's; flash this version's "
                   "firmware (scripts/flash, installed: tp100-flash)");
}

void Supervisor::State::on_session(const LiveEvent& event) {
  if (event.session.kind == Kind::kHello) connector.robot_found();
  if (event.session.kind == Kind::kState) {
    on_session_state(static_cast<SessionState>(event.session.b));
  }
}

void Supervisor::State::on_session_state(SessionState next) {
  session = next;
  const bool meant = next != SessionState::kListening || settings.connector.port != "auto";
  if (first_tried_ns == 0 && next != SessionState::kClosed && meant)
    first_tried_ns = monotonic_now();
  terminal->follow(next);
  tell_manager();
  figures.port = connector.path();
  if (next != SessionState::kReady) return;
  connector.session_ready();
  had_session = true;
  if (settings.course.empty() || ending) return;
  if (settings.controls->start_consent() == StartConsent::kNone) {
    cycle.request_first_start();
  } else {
    terminal->ask();
  }
}

void Supervisor::State::on_run_state(const LiveEvent& event) {
  run_state = event.to;
  terminal->follow(event.to);
  tell_manager();
  if (event.to == RunState::kFinished) return run_ended(0, "completed");
  // Whoever asked for a run by an option does not wait for another start.
  if (event.refused != StartRefusal::kNone && settings.go) return run_ended(1, "refused");
  // A STOP after the end of a run does not change what the run was.
  const bool late_stop = event.from == RunState::kFinished &&
                         (event.faults & ~kRobotFaults) == fault_bit(Fault::stop_requested);
  if (event.to == RunState::kAborted && !late_stop) {
    figures.faults = event.faults | (event.from == event.to ? figures.faults : 0);
    if (ending && status == 0) {
      // What was completed is not, after all.
      status = 1;
      figures.result = "aborted";
    }
    const bool waits = (figures.faults & kRecoverable) != 0 && !settings.go &&
                       (figures.faults & fault_bit(Fault::moves_unasked)) == 0;
    stay_status = 1;
    if (!waits) return run_ended(1, "aborted");
  }
  if (!ending) terminal->ask();
}

void Supervisor::State::run_ended(int exit_status, const std::string& result) {
  if (!settings.stay) return end(exit_status, result);
  stay_status = exit_status;
  figures.result = result;
  log.info(result);
  terminal->ask();
}

void Supervisor::State::end(int exit_status, const std::string& result) {
  if (std::exchange(ending, true)) return;
  settings.controls->end();
  terminal->stop();
  notice.stopping();
  status = exit_status;
  figures.result = result;
  connector.stop();
  loop.request_stop();
}

void Supervisor::State::take_figures() {
  if (camera != nullptr) figures.camera = camera->counters();
  figures.world = world->figures();
  take_recording();
  figures.loop = settings.controls->loop();
  stats.write(figures);
}

void Supervisor::State::take_recording() {
  const messages::RecordingFigures was = std::move(figures.recording);
  figures.recording = settings.recording->figures();
  figures.recording_cpu_s = settings.recording->cpu_s();
  const messages::RecordingFigures& is = figures.recording;
  if (is.file != was.file) log.info("recording to " + is.file);
  if (!is.warning.empty() && is.warning != was.warning) log.warn(is.warning);
  if (is.dropped > 0 && was.dropped == 0)
    log.warn(is.file + ": the disk is too slow, steps are missing in the recording");
}

void Supervisor::State::note_link() {
  const std::vector<messages::Event> words = link_watch.take_words();
  log.words(words);
  for (const messages::Event& word : words) settings.server->take(word);
}

void Supervisor::State::take_notes() {
  for (const std::string& note :
       {settings.black_box->take_note(), run_recorder.take_note(), stats.take_note()})
    if (!note.empty()) log.warn(note);
}

void Supervisor::State::summarize() const {
  const Snapshot& snapshot = figures.status.snapshot;
  const LinkCounters& link = figures.status.counters;
  std::printf("%s: %s after %.1f s at x %.3f m, y %.3f m, yaw %.1f deg; %llu samples, %llu lost\n",
              settings.course.empty() ? "no course" : settings.course.c_str(),
              figures.result.c_str(), figures.duration_s, snapshot.odometry.x_m,
              snapshot.odometry.y_m, snapshot.odometry.yaw_rad * kDegPerRad,
              static_cast<unsigned long long>(link.samples),
              static_cast<unsigned long long>(link.lost));
  if (!figures.recording.file.empty()) {
    std::printf("recording: %s, %.1f MB\n", figures.recording.file.c_str(),
                static_cast<double>(figures.recording.bytes) * 1e-6);
  }
  if (figures.faults != 0) std::printf("faults: %s\n", fault_names(figures.faults).c_str());
  std::fflush(stdout);
}

}  // namespace tp100::live
