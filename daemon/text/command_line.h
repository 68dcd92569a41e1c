#pragma once
// The command line of a program with subcommands. It needs CLI11: only what defines options
// includes it.

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "text/standard_streams.h"

namespace tp100::text {

/// An option whose value --help calls `type`.
template <class T>
CLI::Option* option(CLI::App* command, const char* name, T& value, const char* type,
                    const char* help) {
  return command->add_option(name, value, help)->type_name(type);
}

/// Parses the command line and returns the exit status of `action`, which the callback of the
/// chosen subcommand sets; without one, that of --help and --version, or 2 after an error of use.
inline int run_command_line(CLI::App& app, int argc, char** argv,
                            const std::function<int()>& action) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    std::vector<Subcommand> known;
    for (const CLI::App* command : app.get_subcommands({})) {
      known.push_back({command->get_name(), {}});
      for (const CLI::Option* option : command->get_options())
        for (const std::string& name : option->get_lnames())
          known.back().options.push_back("--" + name);
    }
    return report_usage_error(app.get_name().c_str(), error.what(), argc, argv, known);
  }
  return action();
}

}  // namespace tp100::text
