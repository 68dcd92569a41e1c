#pragma once
// Standard input, output and error of a program, whatever state it was started in.

namespace tp100::analysis {

/// Opens /dev/null in place of each standard stream that is closed, so that no port or file of the
/// program gets its number and then its log lines. Call first in main.
void claim_standard_streams();

/// Flushes standard output. What could not be written is one line on standard error, and status 2
/// in place of 0. Call last in main, with the exit status.
int finish_standard_output(const char* program, int status);

}  // namespace tp100::analysis
