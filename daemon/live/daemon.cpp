#include "live/daemon.h"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdlib>
#include <utility>

#include "core/clock.h"
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

constexpr std::chrono::milliseconds kTick{10}, kWorldTick{2};  // poses go to a world at a tick
// For disks, after the loop's end; the unit's TimeoutStopSec is longer.
constexpr std::chrono::seconds kLastWait{5};

class Daemon {
 public:
  Daemon(const config::LoadedRun& run, const DaemonOptions& options)
      : parts_(run, options), options_(options) {
    sinks_.insert(sinks_.end(), {&parts_.self_test, &link_monitor_, &run_recordings_,
                                 &parts_.recording, &parts_.black_box, &parts_.server, &inputs_});
  }
  int run();

 private:
  void tick();
  void take_records();
  void take_events();
  void on(const SessionReport& report);
  void on(const RunChange& change);
  void on(const RequestDropped&) { terminal_.ask(monotonic_now()); }
  void drain_events();
  void take_figures();
  void end();
  void finish_files();
  std::string course() const { return parts_.setup.in_force()->course(); }

  DaemonParts parts_;
  const DaemonOptions options_;
  EventLog log_;
  ServiceNotice notice_{service_settings()};
  boost::asio::io_context context_;
  Connector connector_{parts_.configuration.link,
                       options_.wait,
                       parts_.self_test.wheels_up().handover(),
                       parts_.loop,
                       log_,
                       parts_.controls};
  LinkMonitor link_monitor_;
  ExternalInputs inputs_{context_, parts_.first_run->loaded.setup, parts_.cycle, parts_.server,
                         parts_.events};
  RunRecordings run_recordings_{parts_.recording, parts_.events, options_.stay};
  std::vector<messages::Sink*> sinks_{options_.sinks};
  StatsFile stats_{options_.stats_path, parts_.disk, parts_.events};
  DaemonFigures figures_{.page = parts_.server.url()};
  Outcome outcome_{options_.go, options_.stay};
  Terminal terminal_{
      &context_,
      {.controls = parts_.controls,
       .say = [this](const std::string& line, bool warning) { log_.say(line, warning); },
       .stop_pressed = [this] { parts_.server.stop_pressed("keyboard"); },
       .course = [this] { return course(); }},
      [this](const char* signal) {
        log_.info(signal);
        if (outcome_.interrupt()) end();
      }};
  const HostNs began_ns_ = monotonic_now();
  HostNs next_stats_ns_ = 0;
};

int Daemon::run() {
  try {
    take_figures();  // the first file of --stats waits for the disk, which nothing may do later
    parts_.loop.start();
    tick();
    log_.privileges(parts_.controls.set_privileges(parts_.process.privileges()));
    parts_.server.start();
    if (!parts_.server.note().empty()) log_.warn(parts_.server.note());
    if (!figures_.page.empty()) log_.info("page: " + figures_.page);
    if (const std::string why = notice_.ready(); !why.empty()) log_.warn(why);
    const auto work = boost::asio::make_work_guard(context_);
    while (!outcome_.ending() || !parts_.loop.ended()) {
      context_.run_for(inputs_.figures().world.udp ? kWorldTick : kTick);
      tick();
    }
  } catch (...) {
    // The port must outlive the loop that uses it.
    parts_.loop.request_stop();
    parts_.loop.join();
    // The recording of a run that never began contains nothing useful.
    if (!connector_.had_session()) parts_.recording.discard();
    throw;
  }
  parts_.loop.join();
  inputs_.stop();
  tick();
  finish_files();
  return outcome_.status();
}

void Daemon::tick() {
  const HostNs now = monotonic_now();
  take_records();
  parts_.setup.tick();
  take_events();
  drain_events();
  connector_.tick(now);
  if (parts_.cycle.take_status(figures_.status))
    log_.status(figures_.status, parts_.loop.statistics().overruns.load(), now);
  log_.tick(now);
  notice_.status(state_line(connector_.session(), outcome_.run(), course(), figures_.page));
  notice_.alive(parts_.loop.statistics().cycles.load(), now);
  const bool too_long = options_.duration_s && to_s(now - began_ns_) >= *options_.duration_s;
  if (too_long && outcome_.end(1, "duration")) end();
  if (now < next_stats_ns_) return;
  next_stats_ns_ = now + kNsPerS;
  parts_.process.keep();
  take_figures();
}

void Daemon::take_records() {
  while (const StepRecord* record = parts_.cycle.front_record()) {
    // A change comes before anything else receives the first step with it.
    if (const auto made = parts_.setup.take(*record)) {
      if (made->exchange) {
        for (const auto& hears : parts_.listeners(!options_.stay)) hears(*made->exchange);
        terminal_.ask(monotonic_now());
      }
      parts_.events.post({.at_ns = monotonic_now(), .kind = "setup", .text = made->text});
      drain_events();
      parts_.setup.finish();
    }
    for (messages::Sink* sink : sinks_) sink->take(*record);
    parts_.cycle.release_record();
  }
}

void Daemon::take_events() {
  LiveEvent event;
  while (parts_.cycle.take_event(event)) {
    // The recording of a run begins with its first step, and has the event.
    if (std::holds_alternative<RunChange>(event)) take_records();
    // An event that ends the program is reported once, as the error.
    if (const auto* report = std::get_if<SessionReport>(&event))
      connector_.on_event(*report, parts_.setup.in_force()->loaded.setup.robot.name);
    const std::vector<messages::Event> events = describe_event(event);
    log_.event(event, events);
    for (const messages::Event& one : events) parts_.server.take(one);
    std::visit([this](const auto& what) { on(what); }, event);
  }
}

void Daemon::on(const SessionReport& report) {
  if (acknowledges_stop(report.event)) parts_.server.stop_answered(report.event.at_ns);
  parts_.controls.set_session(report, connector_.path(), connector_.pseudo_terminal());
  link_monitor_.set_pseudo_terminal(connector_.pseudo_terminal());
  const auto* changed = link::as<link::StateChanged>(report.event);
  if (changed == nullptr) return;
  terminal_.follow(changed->to);
  figures_.port = connector_.path();
  if (changed->to != SessionState::kReady || outcome_.ending()) return;
  const HostNs now = monotonic_now();
  if (!parts_.controls.start_by_itself(connector_.came_later(), began_ns_, now)) terminal_.ask(now);
}

void Daemon::on(const RunChange& change) {
  const Outcome::Next next = outcome_.take(change);
  terminal_.follow(change.to);
  if (next == Outcome::Next::kEnd) return end();
  if (next == Outcome::Next::kSayAndAsk) log_.info(outcome_.result());
  if (next != Outcome::Next::kNothing) terminal_.ask(monotonic_now());
}

void Daemon::drain_events() {
  if (const auto camera = inputs_.figures().camera) link_monitor_.take(camera->detections);
  for (messages::Event& event : link_monitor_.drain_events()) parts_.events.post(std::move(event));
  for (const auto& [event, log_only] : parts_.events.drain()) {
    log_.write({event});
    if (!log_only) parts_.server.take(event);
  }
}

void Daemon::take_figures() {
  figures_.run = parts_.setup.in_force();
  figures_.duration_s = to_s(monotonic_now() - began_ns_);
  figures_.result = outcome_.result();
  figures_.faults = outcome_.faults();
  figures_.inputs = inputs_.figures();
  figures_.recording = parts_.recording.figures();
  figures_.recording_cpu_s = parts_.recording.cpu_s();
  log_.recording(figures_.recording);
  figures_.loop = parts_.controls.loop();
  stats_.write(figures_);
}

void Daemon::end() {
  parts_.controls.end();
  terminal_.stop();
  notice_.stopping();
  connector_.stop();
  parts_.loop.request_stop();
}

// The robot is disarmed: now waiting for disks is allowed, for a limited time.
void Daemon::finish_files() {
  const auto deadline = std::chrono::steady_clock::now() + kLastWait;
  // The recording must include the last messages.
  parts_.server.flush();
  parts_.black_box.finish();
  const bool recorded =
      notice_.wait(deadline, [this](auto by) { return parts_.recording.finish(by); });
  take_figures();
  const bool idle = notice_.wait(deadline, [this](auto by) { return parts_.disk.idle_by(by); });
  const bool answered = notice_.wait(deadline, [this](auto by) { return inputs_.ended_by(by); });
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
  if (log_.flush() && recorded && idle && answered && !parts_.server.waits_for_disk()) return;
  // The threads that wait for the disk, or for a reader of the log, cannot be joined.
  std::_Exit(outcome_.status());
}

}  // namespace

int run_daemon(const config::LoadedRun& run, const DaemonOptions& options) {
  return Daemon(run, options).run();
}

}  // namespace tp100::live
