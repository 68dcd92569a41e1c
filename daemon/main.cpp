// tp100d: the command line, of the subcommands in app/.

#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "text/command_line.h"

namespace {

int run(int argc, char** argv) {
  CLI::App app("Real-time bridge for the TP100 crawler", "tp100d");
  app.set_version_flag("--version", TP100_VERSION);
  app.require_subcommand(1);
  tp100::app::Action action;
  for (const auto add : tp100::app::kSubcommands) add(app, action);
  return tp100::text::run_command_line(app, argc, argv, action);
}

}  // namespace

int main(int argc, char** argv) {
  return tp100::text::run_program("tp100d", [&] { return run(argc, argv); });
}
