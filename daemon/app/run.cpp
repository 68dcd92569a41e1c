#include "app/commands.h"
#include "config/configuration.h"
#include "config/run_setup.h"
#include "config/setup_files.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "live/daemon.h"
#include "live/setup_list.h"
#include "text/format.h"
#include "text/toml_document.h"

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

}  // namespace

int run_run(const RunOptions& options) {
  const std::optional<double> duration_s = options.daemon.duration_s;
  if (duration_s && !(*duration_s > 0.0 && *duration_s < 1e9)) {
    throw UserError("--duration " + text::number_text(*duration_s) +
                    ": out of range; give seconds, above 0 and below 1e9");
  }
  const config::RunFiles files = files_of(options);
  return live::run_daemon({files, setup_run(files, options)}, options.daemon);
}

}  // namespace tp100::app
