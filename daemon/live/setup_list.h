#pragma once
// The files among which an operator chooses, as JSON for viewers (CHANNELS.md, GET /api/setup).

#include <string>

#include "config/run_setup.h"
#include "config/setup_files.h"

namespace tp100::live {

/// Most points of a course's outline.
inline constexpr std::size_t kMaxOutline = 200;

/// Throws UserError if the course, the robot and the set-up of this run do not fit together.
void require_fit(const config::RunSetup& run);

/// All files with what a viewer shows of them, and whether each fits the rest of `run`, the present
/// one. Waits for the disk.
std::string setup_list(const config::SetupFiles& files, const config::LoadedRun& run);

/// Checks a file that may be only a draft; the result is JSON (CHANNELS.md, file_check): its first
/// error with its place, else whether it fits the rest of `run`, and a course's length, time and
/// geometry, also of one with an error as long as its pieces can be read. Reads nothing.
std::string checked_file(const config::LoadedRun& run, course::Bundled kind,
                         const course::TextFile& file);

}  // namespace tp100::live
