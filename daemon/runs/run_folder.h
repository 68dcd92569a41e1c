#pragma once
// The folder of recordings (record.directory) as it is on the disk: a folder for each run.
// Everything found there is treated as hostile: names are checked (text::is_found_name), no link is
// followed. Functions wait for the disk; any thread.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/descriptor.h"
#include "runs/run_note.h"
#include "runs/run_result.h"

namespace tp100::runs {

/// The type of a file of a run, by the end of its name.
struct RunFileType {
  std::string_view end;  ///< ".mcap"
  std::string_view kind;
  std::string_view media_type;
};
const RunFileType& kind_of(std::string_view file);

struct RunFile {
  std::string name;
  std::uint64_t bytes = 0;
};

struct Run {
  std::string folder;            ///< its name, not its path
  double recorded_unix_s = 0.0;  ///< when its recording, or else its newest file, was last written
  std::uint64_t bytes = 0;       ///< of all its files
  std::vector<RunFile> files{};  ///< sorted by name, at most 100
  bool has_recording = false;
  bool has_note = false;
  RunNote note{};
  std::optional<RunResult> result{};  ///< nothing: not known
  std::string note_error{};           ///< why the note cannot be read, in one line, or empty
};

/// The note in the folder of a recording; nothing without one, or if it cannot be read.
RunNote note_beside(const std::string& recording);

/// All runs, newest first; an absent folder counts as empty.
std::vector<Run> list_runs(const std::string& folder);

/// Names of the regular files in the folder of a run, sorted; no links. Throws UserError: no such
/// run.
std::vector<std::string> files_of(const std::string& folder, const std::string& run);

/// Opens a regular file of a run for reading; an empty result: there is none that may be read. No
/// link is followed. The file is in use (record/recording_file.h) while it is open. `bytes`: its
/// size.
Descriptor open_run_file(const std::string& folder, const std::string& run, const std::string& file,
                         std::uint64_t& bytes);

/// Changes the note of a run; a note that is then empty is removed. Returns the new note. Throws
/// UserError: no such run, invalid text, or an error of the disk.
RunNote change_note(const std::string& folder, const std::string& run, const RunNoteChange& change);

/// Deletes a run with all its files. Throws UserError, and deletes nothing: no such run, its
/// recording is open somewhere (record/recording_file.h, mark_in_use), it has none, or there is a
/// folder in it.
void delete_run(const std::string& folder, const std::string& run);

struct FreedSpace {
  std::vector<std::string> deleted{};
  std::uint64_t bytes = 0;  ///< of all runs afterwards
  std::string why_not{};    ///< why that is still more than permitted, in one line, or empty
};
/// Deletes the oldest runs without a note, as delete_run() does, until all together are at most
/// `max_bytes`. `only`: runs whose name does not go on with this text after the date are neither
/// counted nor deleted.
FreedSpace free_space(const std::string& folder, std::uint64_t max_bytes,
                      std::string_view only = {});

/// Makes DIRECTORY/YYYYMMDD-HHMMSS-NAME in local time, with -2, -3, ... after NAME if that folder
/// already exists; NAME is text::file_name_of(name). Throws UserError.
std::string make_run_folder(const std::string& directory, std::string_view name,
                            std::int64_t unix_ns);

/// Removes what killed programs have left in the folder and in the runs (text/temporary.h).
void sweep_runs(const std::string& folder);

/// Free space on the disk of the folder; 0: not known.
std::uint64_t free_bytes(const std::string& folder);

}  // namespace tp100::runs
