#include "app/run.h"

#include <cmath>
#include <cstdio>
#include <memory>

#include "app/bundled_files.h"
#include "app/configuration.h"
#include "app/live_controls.h"
#include "app/live_cycle.h"
#include "app/live_server.h"
#include "app/supervisor.h"
#include "core/error.h"
#include "course/course.h"
#include "course/toml_document.h"
#include "loop/fixed_rate_loop.h"
#include "loop/real_time.h"
#include "terrain/climbable.h"

namespace tp100::app {
namespace {

bridge::Setup setup_of(const std::string& name) {
  if (const auto setup = bridge::setup_named(name)) return *setup;
  throw SetupError("--setup " + course::one_line(name) +
                   ": not a set-up; use bench, flat or terrain");
}

Configuration configuration_of(const RunOptions& options) {
  Configuration configuration;
  if (!options.config.empty()) {
    const TextFile file = read_text_file(options.config);
    configuration = parse_configuration(file.text, file.path);
  }
  if (!options.port.empty()) configuration.link.port = options.port;
  if (!options.course.empty()) configuration.course = options.course;
  if (!options.robot.empty()) configuration.robot = options.robot;
  if (!options.camera.empty()) configuration.camera.listen = options.camera;
  if (!options.listen.empty()) configuration.server.listen = options.listen;
  if (!options.setup.empty()) configuration.parameters.setup = setup_of(options.setup);
  return configuration;
}

HostNs ns_of_ms(double ms) { return from_s(ms * 1e-3); }

loop::LoopSettings loop_settings(const LoopSettings& settings) {
  loop::LoopSettings out;
  out.period_ns = static_cast<HostNs>(std::llround(1e9 / settings.rate_hz));
  out.robot_paced = settings.pacing == Pacing::kRobot;
  out.spin_ns = settings.spin_us * kNsPerUs;
  out.thread = {.priority = settings.priority, .cpu = settings.cpu};
  return out;
}

std::shared_ptr<const course::Course> load_course(const std::string& name) {
  if (name.empty()) return nullptr;
  const TextFile file = read_bundled(Bundled::kCourses, name);
  return std::make_shared<const course::Course>(course::parse_course(file.text, file.path));
}

}  // namespace

int run_run(const RunOptions& options) {
  if (options.duration_s && !(*options.duration_s > 0.0 && *options.duration_s < 1e9)) {
    throw SetupError("--duration: give a number of seconds above 0");
  }
  const Configuration configuration = configuration_of(options);
  const TextFile robot_file = read_bundled(Bundled::kRobots, configuration.robot);
  const course::Robot robot = course::parse_robot(robot_file.text, robot_file.path);
  const bridge::Parameters parameters = bridge_parameters(configuration, robot);
  const auto course = load_course(configuration.course);
  if (course != nullptr) terrain::require_climbable(*course, robot);
  if (!configuration.camera.listen.empty() && parameters.setup == bridge::Setup::kBench) {
    throw SetupError("--camera: on a bench it sees a robot that stands still; leave it out");
  }

  link::SessionSettings session = session_settings(parameters);
  session.baud = static_cast<std::uint32_t>(configuration.link.baud);
  session.timeout_ns = ns_of_ms(configuration.link.timeout_ms);
  session.first_frame_timeout_ns = ns_of_ms(configuration.link.first_frame_timeout_ms);
  const bool leave_silent_port = !options.wait || configuration.link.port == "auto";
  LiveCycle cycle(session, parameters, course, leave_silent_port);

  const loop::RealTimeProcess process({.lock_memory = configuration.loop.lock_memory,
                                       .hold_cpu_latency = configuration.loop.hold_cpu_latency});
  loop::FixedRateLoop loop(loop_settings(configuration.loop), cycle);

  SupervisorSettings settings;
  settings.connector = {
      .port = configuration.link.port,
      .options = {.baud = configuration.link.baud, .hang_up = configuration.link.hang_up},
      .wait = options.wait,
      // Silence is noticed first.
      .hello_timeout_ns = session.first_frame_timeout_ns + kNsPerS};
  settings.camera = configuration.camera;
  settings.go = options.go;
  settings.duration_s = options.duration_s;
  settings.stats_path = options.stats;
  settings.course = course == nullptr ? "" : course->name;
  settings.robot = robot.name;
  settings.setup = bridge::to_string(parameters.setup);
  settings.process_grants = process.grants();
  LiveControls controls(cycle, loop);
  const std::unique_ptr<publish::Server> server = make_server({.configuration = configuration,
                                                               .parameters = parameters,
                                                               .course = course,
                                                               .robot = robot,
                                                               .clock = read_clocks()},
                                                              controls);
  settings.server = server.get();
  settings.controls = &controls;
  settings.stay = options.stay;
  Supervisor supervisor(settings, cycle, loop);
  return supervisor.run();
}

}  // namespace tp100::app
