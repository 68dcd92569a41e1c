#include "app/commands.h"
#include "config/run_setup.h"
#include "config/setup_files.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "live/daemon.h"
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
  return live::run_daemon({files, setup_run(files, options)}, options.daemon);
}

}  // namespace tp100::app
