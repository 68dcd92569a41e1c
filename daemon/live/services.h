#pragma once
// What viewers may do with files: the user's courses, robots and configuration, and recorded runs.
// What the rows were made of must outlive them.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/run_setup.h"
#include "config/setup_files.h"
#include "server/service.h"

namespace tp100::runs {
class RunArchive;
}

namespace tp100::live {

class SetupChanger;

/// file_save, file_delete and file_check; parameters_save changes the configuration file as it is
/// on the disk then, and keeps the previous file as FILE.bak; parameters_restore exchanges the two.
std::vector<server::ServiceRow> file_services(SetupChanger& changer);

/// run_note, run_delete, run_report, run_compare and run_identify.
std::vector<server::ServiceRow> run_services(runs::RunArchive& runs);

/// GET of /api/setup, /courses/NAME.toml and /robots/NAME.toml; nothing: no such file. Waits for
/// the disk; any thread.
std::optional<std::string> setup_content(const SetupChanger& changer, std::string_view path);

/// Most points of a course's outline.
inline constexpr std::size_t kMaxOutline = 200;

/// GET /api/setup (CHANNELS.md): all files with what a viewer shows of them, and whether each fits
/// the rest of `run`, the present one. Waits for the disk.
std::string setup_list(const config::SetupFiles& files, const config::LoadedRun& run);

struct CheckedFile {
  std::string json;   ///< as CHANNELS.md, file_check
  std::string error;  ///< the file's first error with its place; empty: none
};

/// Checks a file that may be only a draft: its first error with its place, else whether it fits the
/// rest of `run`, and a course's length, time and geometry, also of one with an error as long as
/// its pieces can be read. Reads nothing.
CheckedFile checked_file(const config::LoadedRun& run, course::Bundled kind,
                         const course::TextFile& file);

}  // namespace tp100::live
