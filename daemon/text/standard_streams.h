#pragma once
// Standard input, output and error of a program, whatever state it was started in, the uniform
// format of its error messages, and its environment.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tp100::text {

/// Writes "PROGRAM: message" on standard error. `message` is one line. Returns `status`.
int report_error(const char* program, std::string_view message, int status = 2);

/// A subcommand and the names of its options, each with its dashes.
struct Subcommand {
  std::string name;
  std::vector<std::string> options;
};

/// Same for a wrong command line, with a pointer to the --help of the subcommand, if it is one of
/// `known`. If the command line has an unknown subcommand or option, the message names that, with
/// the one that was probably meant, instead of `what`, which may be any text. Returns 2.
int report_usage_error(const char* program, std::string_view what, int argc = 0,
                       char** argv = nullptr, const std::vector<Subcommand>& known = {});

/// Body of a program's main(): claims the standard streams, calls `run` and returns its exit
/// status. A UserError is a user error: status 2. Any other exception is a defect: status 3.
int run_program(const char* program, const std::function<int()>& run);

/// Opens /dev/null in place of each closed standard stream, so that no port or file of the program
/// gets the stream's number and then receives log lines.
void claim_standard_streams();

/// Flushes standard output. On failure prints one line on standard error, and returns status 2
/// instead of 0.
int finish_standard_output(const char* program, int status);

/// The value of an environment variable; empty if it is not set.
std::string environment_variable(const char* name);

}  // namespace tp100::text
