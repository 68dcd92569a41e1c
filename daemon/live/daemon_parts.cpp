#include "live/daemon_parts.h"

#include <cmath>
#include <filesystem>
#include <thread>

#include "bridge/cycle.h"
#include "config/setup_files.h"
#include "core/clock.h"
#include "core/error.h"
#include "live/service_notice.h"
#include "live/services.h"
#include "server/local_daemons.h"
#include "text/temporary.h"
#include "web/bundle.h"

namespace tp100::live {
namespace {

HostNs ns_of_ms(double ms) { return from_s(ms * 1e-3); }

link::SessionSettings session_settings(const config::RunSetup& run) {
  const auto& link = run.configuration.link;
  link::SessionSettings out = bridge::session_settings(run.parameters, run.course.get());
  out.baud = static_cast<std::uint32_t>(link.baud);
  out.timeout_ns = ns_of_ms(link.timeout_ms);
  out.first_frame_timeout_ns = ns_of_ms(link.first_frame_timeout_ms);
  out.clock_answer_ns = ns_of_ms(link.clock_answer_ms);
  return out;
}

loop::LoopSettings loop_settings(const config::LoopConfiguration& settings) {
  loop::LoopSettings out;
  out.period_ns = static_cast<HostNs>(std::llround(1e9 / settings.rate_hz));
  out.robot_paced = settings.pacing == config::Pacing::kRobot;
  // On a single processor, other threads that the loop waits for need it.
  const bool alone = std::thread::hardware_concurrency() == 1;
  out.spin_ns = alone ? 0 : settings.spin_us * kNsPerUs;
  out.thread = {.priority = settings.priority, .cpu = settings.cpu};
  return out;
}

runs::ArchiveSettings archive_settings(const config::RecordSettings& settings,
                                       const LiveRecording& recording) {
  std::error_code unknown;
  const auto programs = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
  return {.folder = settings.directory,
          .quota_bytes = static_cast<std::uint64_t>(settings.quota_mb) * 1'000'000,
          .program = programs / "tp100d",
          .active = [&recording] {
            const messages::RecordingFigures figures = recording.figures();
            return figures.active ? figures.run : std::string();
          }};
}

/// Connects the page and the viewers' requests to the other parts.
server::ServerSettings server_settings(const config::LoadedRun& run, DaemonParts& parts) {
  const config::ServerConfiguration& settings = parts.configuration.server;
  // Tells several robots apart: each has a configuration file of its own.
  const std::string stem = std::filesystem::path(run.files.configuration.path).stem().string();
  server::ServerSettings out;
  out.listen = settings.listen;
  out.access = {server::words(settings.hosts), server::words(settings.origins)};
  out.commands = settings.commands;
  out.max_clients = static_cast<std::size_t>(settings.max_clients);
  out.name = one_line(stem.empty() ? run.setup.robot.name : stem);
  out.robots = server::robot_pages(settings.robots);
  out.content.runs_folder = parts.configuration.record.directory;
  out.content.runs = [&parts] { return parts.runs.json(); };
  out.content.page = web::find;
  out.content.setup = [&parts](std::string_view path) { return setup_content(parts.setup, path); };
  out.services = parts.controls.services();
  out.real_time = parts.configuration.loop.priority > 0;
  out.listener = [&parts](messages::Channel channel, std::uint64_t unix_ns, std::string_view json) {
    parts.recording.on_message(channel, unix_ns, json);
  };
  return out;
}

/// Removes what a killed program has left where this one will write.
void sweep(const config::LoadedRun& run, const std::string& stats_path) {
  const config::Configuration& configuration = run.setup.configuration;
  for (const std::string& file : {run.files.configuration.path, stats_path})
    if (!file.empty()) text::sweep_temporary(std::filesystem::path(file).parent_path());
  const std::string library = config::library_folder(configuration.library);
  for (const char* folder : {"/courses", "/robots"})
    if (!library.empty()) text::sweep_temporary(library + folder);
  const std::string black_boxes = black_box_directory(configuration.record);
  runs::sweep_runs(configuration.record.directory);
  if (black_boxes != configuration.record.directory) runs::sweep_runs(black_boxes);
}

}  // namespace

DaemonParts::DaemonParts(const config::LoadedRun& run, const DaemonOptions& options)
    : first_run(std::make_shared<const ActiveRun>(run)),
      cycle(session_settings(run.setup), run.setup.parameters, run.setup.course,
            !options.wait || configuration.link.port == "auto"),
      clock{.start_ns = monotonic_now(), .start_unix_ns = unix_now_ns()},
      participant(ros2_participant(configuration)),
      process({.lock_memory = configuration.loop.lock_memory,
               .hold_cpu_latency = configuration.loop.hold_cpu_latency,
               .raise_kernel_workers = configuration.loop.priority > 0}),
      loop(loop_settings(configuration.loop), cycle),
      recording(first_run, clock, events),
      black_box(configuration.record, recording, events),
      setup(first_run, cycle, disk, clock, participant != nullptr),
      runs(archive_settings(configuration.record, recording), disk),
      self_test(configuration, run.setup.robot, disk, events),
      controls(cycle, loop, recording, setup, runs, self_test, events),
      server(server_settings(run, *this), {first_run->context, clock}, first_run->parameters,
             controls) {
  controls.set_start({.go = options.go,
                      .service = !service_settings().socket.empty(),
                      .ran_before = options.ran_before});
  disk.post([run, stats = options.stats_path] { sweep(run, stats); }, [](const std::string&) {});
  if (participant != nullptr)
    ros2.emplace(
        *participant, first_run->context, clock, cycle,
        Ros2Requests(controls, events, [this] { server.stop_pressed("ROS 2 /tp100/stop"); }),
        why_no_ros2_requests(configuration));
}

std::vector<ExchangeListener> DaemonParts::listeners(bool continues) {
  return {
      [this, continues](const Exchange& each) { recording.exchange(each, continues); },
      [this](const Exchange&) { black_box.finish(); },
      [this](const Exchange& each) { self_test.choose(each.run->loaded.setup.robot); },
      [this](const Exchange& each) {
        server.exchange(each.run->context, each.for_viewers, each.run->parameters);
      },
      [this](const Exchange& each) {
        if (ros2) ros2->exchange(each);
      },
  };
}

}  // namespace tp100::live
