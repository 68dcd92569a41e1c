#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/commands.h"
#include "config/configuration.h"
#include "config/run_setup.h"
#include "config/setup_files.h"
#include "core/clock.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "course/course.h"
#include "live/file_services.h"
#include "live/live_controls.h"
#include "live/live_cycle.h"
#include "live/live_recording.h"
#include "live/recording_policies.h"
#include "live/ros2_node.h"
#include "live/service_notice.h"
#include "live/setup_changer.h"
#include "live/setup_list.h"
#include "live/supervisor.h"
#include "loop/fixed_rate_loop.h"
#include "loop/real_time.h"
#include "runs/run_archive.h"
#include "selftest/self_test.h"
#include "server/local_daemons.h"
#include "server/server.h"
#include "text/format.h"
#include "text/temporary.h"
#include "text/toml_document.h"
#include "web/bundle.h"

namespace tp100::app {
namespace {

/// The files of the run, with the command line's overrides.
config::RunFiles files_of(const RunOptions& options) {
  config::RunFiles files;
  if (!options.config.empty()) files.configuration = course::read_text_file(options.config);
  const config::Configuration configuration =
      config::parse_configuration(files.configuration.text, files.configuration.path);
  const std::string& course = options.course.empty() ? configuration.course : options.course;
  const std::string library = config::library_folder(configuration.library);
  if (!course.empty())
    files.course = config::read_setup_file(course::Bundled::kCourses, course, library);
  files.robot =
      config::read_setup_file(course::Bundled::kRobots,
                              options.robot.empty() ? configuration.robot : options.robot, library);
  files.setup = config::setup_option(options.setup, configuration.parameters.setup);
  files.world = config::world_option(options.world, configuration.parameters.world.kind);
  return files;
}

config::RunSetup setup_run(const config::RunFiles& files, const RunOptions& options) {
  config::RunSetup run = config::parse_run(files);
  if (!options.port.empty()) run.configuration.link.port = options.port;
  if (!options.camera.empty()) run.configuration.camera.listen = options.camera;
  if (options.world.starts_with("udp:")) run.configuration.world.address = options.world;
  if (!options.listen.empty()) run.configuration.server.listen = options.listen;
  if (!options.record.empty()) run.configuration.record.directory = options.record;
  live::require_fit(run);
  return run;
}

HostNs ns_of_ms(double ms) { return from_s(ms * 1e-3); }

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

messages::PublishClock read_clocks() {
  const std::int64_t start_unix_ns = unix_now_ns();
  return {.start_ns = monotonic_now(), .start_unix_ns = start_unix_ns};
}

runs::ArchiveSettings archive_settings(const config::RecordSettings& settings,
                                       const live::LiveRecording& recording) {
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

/// Removes what a killed program has left where this one will write, besides the recorded runs.
void sweep(const config::RunSetup& run, const std::string& configuration_file,
           const std::string& stats) {
  for (const std::string& file : {configuration_file, stats})
    if (!file.empty()) text::sweep_temporary(std::filesystem::path(file).parent_path());
  const std::string library = config::library_folder(run.configuration.library);
  for (const char* folder : {"/courses", "/robots"})
    if (!library.empty()) text::sweep_temporary(library + folder);
  const std::string black_boxes = live::black_box_directory(run.configuration.record);
  if (black_boxes != run.configuration.record.directory) runs::sweep_runs(black_boxes);
}

/// Tells several robots apart: each has a configuration file of its own.
std::string robot_name(const config::RunSetup& run, const std::string& configuration_file) {
  const std::string stem = std::filesystem::path(configuration_file).stem().string();
  return text::one_line(stem.empty() ? run.robot.name : stem);
}

// Connects the page and the viewers' requests to the live loop.
std::unique_ptr<server::Server> make_server(const config::RunSetup& run,
                                            const std::string& configuration_file,
                                            const messages::PublishClock& clock,
                                            live::LiveControls& controls,
                                            const live::SetupChanger& setup, runs::RunArchive& runs,
                                            server::Listener listener) {
  const config::ServerConfiguration& settings = run.configuration.server;
  server::ServerSettings out;
  out.listen = settings.listen;
  out.access = {server::words(settings.hosts), server::words(settings.origins)};
  out.commands = settings.commands;
  out.max_clients = static_cast<std::size_t>(settings.max_clients);
  out.name = robot_name(run, configuration_file);
  out.robots = server::robot_pages(settings.robots);
  out.runs_folder = run.configuration.record.directory;
  out.runs = [&runs] { return runs.json(); };
  out.page = web::find;
  out.setup = [&setup](std::string_view path) { return live::setup_content(setup, path); };
  out.services = controls.services();
  out.real_time = run.configuration.loop.priority > 0;
  out.listener = std::move(listener);
  return std::make_unique<server::Server>(
      std::move(out), messages::Messages(config::run_context_of(run), clock),
      live::parameter_list(run.configuration, run.robot), controls);
}

}  // namespace

int run_run(const RunOptions& options) {
  if (options.duration_s && !(*options.duration_s > 0.0 && *options.duration_s < 1e9)) {
    throw SetupError("--duration " + text::number_text(*options.duration_s) +
                     ": out of range; give seconds, above 0 and below 1e9");
  }
  const config::RunFiles files = files_of(options);
  const config::RunSetup run = setup_run(files, options);
  const config::Configuration& configuration = run.configuration;

  link::SessionSettings session = bridge::session_settings(run.parameters, run.course.get());
  session.baud = static_cast<std::uint32_t>(configuration.link.baud);
  session.timeout_ns = ns_of_ms(configuration.link.timeout_ms);
  session.first_frame_timeout_ns = ns_of_ms(configuration.link.first_frame_timeout_ms);
  session.clock_answer_ns = ns_of_ms(configuration.link.clock_answer_ms);
  const bool leave_silent_port = !options.wait || configuration.link.port == "auto";
  live::LiveCycle cycle(session, run.parameters, run.course, leave_silent_port);

  const messages::PublishClock clock = read_clocks();
  // Started before memory is locked and by this thread, whose ordinary scheduling its threads
  // inherit.
  const std::unique_ptr<ros2::Participant> participant = live::ros2_participant(configuration);
  const loop::RealTimeProcess process({.lock_memory = configuration.loop.lock_memory,
                                       .hold_cpu_latency = configuration.loop.hold_cpu_latency,
                                       .raise_kernel_workers = configuration.loop.priority > 0});
  loop::FixedRateLoop loop(loop_settings(configuration.loop), cycle);

  messages::EventQueue events;
  live::LiveRecording recording(files, run, clock, events);
  record::Worker disk;
  disk.post(
      [run, file = files.configuration.path, stats = options.stats] { sweep(run, file, stats); },
      [](const std::string&) {});
  live::BlackBox black_box(configuration.record, recording, events);
  live::SetupChanger setup({files, run}, cycle, clock, participant != nullptr);
  runs::RunArchive runs(archive_settings(configuration.record, recording));
  selftest::SelfTest self_test(configuration, run.robot, events);
  live::LiveControls controls(cycle, loop, recording, setup, runs, self_test, events);
  const auto listener = [&](messages::Channel channel, std::uint64_t unix_ns,
                            std::string_view json) {
    recording.on_message(channel, unix_ns, json);
  };
  const std::unique_ptr<server::Server> server =
      make_server(run, files.configuration.path, clock, controls, setup, runs, listener);
  // With --stay each run gets a recording of its own.
  if (!configuration.record.directory.empty() && !options.stay) recording.begin();
  std::optional<live::Ros2Node> ros2;
  if (participant)
    ros2.emplace(
        *participant, config::run_context_of(run), clock, cycle,
        live::Ros2Requests(controls, events, [&] { server->stop_pressed("ROS 2 /tp100/stop"); }),
        live::why_no_ros2_requests(configuration));
  std::vector<messages::Sink*> sinks = {&self_test};
  sinks.insert(sinks.end(), options.sinks.begin(), options.sinks.end());
  const live::SupervisorSettings settings{
      .connector = {.port = configuration.link.port,
                    .options = {.baud = configuration.link.baud,
                                .hang_up = configuration.link.hang_up},
                    .wait = options.wait,
                    .handover = &self_test.wheels_up().handover()},
      .camera = configuration.camera,
      .world = config::world_run(run),
      .go = options.go,
      .ran_before = options.ran_before,
      .stay = options.stay,
      .duration_s = options.duration_s,
      .stats_path = options.stats,
      .process = process,
      .events = events,
      .recording = recording,
      .black_box = black_box,
      .disk = disk,
      .server = *server,
      .controls = controls,
      .setup_changer = setup,
      .ros2 = ros2 ? &*ros2 : nullptr,
      .sinks = sinks};
  try {
    return live::supervise(settings, cycle, loop);
  } catch (const SetupError&) {
    // The run never began, so the recording contains nothing useful.
    recording.discard();
    throw;
  }
}

}  // namespace tp100::app
