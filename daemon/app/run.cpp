#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/commands.h"
#include "config/run_setup.h"
#include "config/setup_files.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "live/daemon.h"
#include "text/command_line.h"
#include "text/format.h"

namespace tp100::app {
namespace {

/// The files of the run, with the command line's overrides.
config::RunFiles files_of(const RunOptions& options) {
  const auto configuration =
      options.config.empty() ? course::TextFile{} : course::read_text_file(options.config);
  config::RunFiles files = config::named_files(configuration, options.course, options.robot);
  files.setup = config::setup_option(options.setup, files.setup);
  files.world = config::world_option(options.world, files.world);
  return files;
}

config::RunSetup setup_run(const config::RunFiles& files, const RunOptions& options) {
  config::RunSetup run = config::parse_run(files);
  if (!options.port.empty()) run.configuration.link.port = options.port;
  if (!options.camera.empty()) run.configuration.camera.listen = options.camera;
  if (options.world.starts_with("udp:")) run.configuration.world.address = options.world;
  if (!options.listen.empty()) run.configuration.server.listen = options.listen;
  if (!options.record.empty()) run.configuration.record.directory = options.record;
  config::require_fit(run);
  return run;
}

}  // namespace

int run_run(const RunOptions& options) {
  const std::optional<double> duration_s = options.daemon.duration_s;
  if (duration_s && !(*duration_s > 0.0 && *duration_s < 1e9)) {
    throw UserError("--duration " + text::number_text(*duration_s) +
                    ": out of range; give seconds, above 0 and below 1e9");
  }
  const config::RunFiles files = files_of(options);
  for (const std::string& note : config::hidden_files(files))
    std::fprintf(stderr, "tp100d: %s\n", note.c_str());
  return live::run_daemon({files, setup_run(files, options)}, options.daemon);
}

void add_run(CLI::App& app, Action& action) {
  static RunOptions options;
  CLI::App* command = app.add_subcommand("run", "Drive a robot, or just watch its pose");
  text::option(command, "--config", options.config, "FILE",
               "Configuration (default: as config/tp100.toml)");
  text::option(command, "--port", options.port, "DEVICE",
               "Serial port, or auto for a Mega by its USB ids (default: auto)");
  command->add_flag("--wait", options.daemon.wait,
                    "Wait for port and robot instead of ending with status 2");
  command->add_flag("--go", options.daemon.go,
                    "Start the first run without Enter on a physical port, too, within 10 s and if "
                    "the robot is there at once, but not in a service; end after every fault. "
                    "Every later run takes the word go and Enter; Enter alone is STOP");
  text::option(command, "--course", options.course, "COURSE",
               "Name in config/courses or file (default: none, poses only)");
  text::option(command, "--robot", options.robot, "ROBOT",
               "Name in config/robots or file (default: end-loaded)");
  text::option(command, "--setup", options.setup, "SETUP",
               "stand, flat or terrain (default: flat)");
  text::option(command, "--camera", options.camera, "ADDRESS",
               "Listen for an overhead camera: udp:PORT or udp:ADDRESS:PORT (default: none)");
  text::option(command, "--world", options.world, "WORLD",
               "Terrain source of the virtual robot: internal, files, or an external world at "
               "udp:PORT or udp:ADDRESS:PORT (default: internal)");
  text::option(command, "--listen", options.listen, "ADDRESS",
               "Page and viewers: ADDRESS:PORT (port 0: any free one), auto or off (default: "
               "auto, 127.0.0.1:8765)");
  command->add_flag("--stay", options.daemon.stay,
                    "When a run is over, wait for the next start instead of ending");
  text::option(command, "--duration", options.daemon.duration_s, "SECONDS",
               "End with status 1 after this time [s] (default: no limit)")
      ->check(CLI::Range(0.001, 1e9));
  text::option(command, "--record", options.record, "FOLDER",
               "Folder for recordings; each run gets its own folder in it (default: none)");
  text::option(command, "--stats", options.daemon.stats_path, "FILE",
               "JSON file for the figures of the run, written once a second and at the end");
  command->footer("Example: tp100d run --port auto --wait --course 1-curve");
  command->callback([&action] { action = [] { return run_run(options); }; });
}

}  // namespace tp100::app
