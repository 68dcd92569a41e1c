#pragma once
// Standard input, output and error of a program, whatever state it was started in, and the one form
// in which its errors are reported.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tp100::text {

/// Writes "PROGRAM: message" on standard error. `message` is one line. Returns `status`.
int report_error(const char* program, std::string_view message, int status = 2);

/// Same for a command line that is wrong, with where to look; `what` may be anything. Returns 2.
int report_usage_error(const char* program, std::string_view what);

/// What is wrong with a first argument that is neither an option nor one of `subcommands`, and
/// which of them was probably meant; empty if nothing is.
std::string unknown_subcommand(int argc, char** argv, const std::vector<std::string>& subcommands);

/// What main() of a program does: claims the standard streams, calls `run` and returns its exit
/// status. A SetupError is the user's: status 2. Any other exception is a defect: status 3.
int run_program(const char* program, const std::function<int()>& run);

/// Opens /dev/null in place of each standard stream that is closed, so that no port or file of the
/// program gets its number and then its log lines.
void claim_standard_streams();

/// Flushes standard output. What could not be written is one line on standard error, and status 2
/// in place of 0.
int finish_standard_output(const char* program, int status);

}  // namespace tp100::text
