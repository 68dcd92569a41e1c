#include "runs/run_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <utility>

#include "core/error.h"
#include "core/time.h"
#include "record/recording_file.h"
#include "text/atomic_file.h"
#include "text/file_name.h"
#include "text/format.h"
#include "text/temporary.h"

namespace tp100::runs {
namespace {

// Of date_and_time().
constexpr std::size_t kDateLength = 15;

namespace fs = std::filesystem;

constexpr std::size_t kMaxFiles = 100;  // listed per run
constexpr std::size_t kMaxEntries = 20'000;
constexpr std::size_t kMaxNoteFile = 16'384;
using record::kRecordingFile;

constexpr std::array<RunFileType, 8> kKinds = {{
    {kRunNoteFile, "note", "text/plain; charset=utf-8"},
    {".mcap", "recording", "application/octet-stream"},
    {".html", "report", "text/html; charset=utf-8"},
    {".json", "metrics", "application/json"},
    {".csv", "table", "text/csv; charset=utf-8"},
    {".tum", "trajectory", "text/plain; charset=utf-8"},
    {".svg", "figure", "image/svg+xml"},
    {".toml", "other", "text/plain; charset=utf-8"},
}};
constexpr RunFileType kOther = {"", "other", "application/octet-stream"};

double seconds(const timespec& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

std::string date_and_time(std::int64_t unix_ns) {
  const auto at = static_cast<std::time_t>(unix_ns / kNsPerS);
  std::tm local{};
  ::localtime_r(&at, &local);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y%m%d-%H%M%S", &local)};
}

bool is_folder(const fs::path& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

/// A short regular file. Throws UserError.
std::string read_short(const fs::path& path) {
  std::string text(kMaxNoteFile + 1, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kMaxNoteFile)
    throw UserError(path.filename().string() + ": too long; write a shorter one");
  return text;
}

/// Fills in `run`. False: not a folder, or a link.
bool look_at(const fs::path& folder, Run& run) {
  if (!is_folder(folder)) return false;
  struct stat status {};
  double newest_s = 0.0, recording_s = 0.0;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!text::is_found_name(name) || ::lstat(at->path().c_str(), &status) != 0) continue;
    if (name == kRunNoteFile) {
      run.has_note = true;
      try {
        if (!S_ISREG(status.st_mode)) throw UserError(name + ": not a file");
        run.note = parse_run_note(read_short(at->path()), kRunNoteFile);
      } catch (const UserError& wrong) {
        run.note_error = wrong.what();
      }
    }
    if (!S_ISREG(status.st_mode)) continue;
    if (name == kRunResultFile && static_cast<std::size_t>(status.st_size) <= kMaxNoteFile)
      run.result = parse_run_result(read_short(at->path()));
    const auto bytes = static_cast<std::uint64_t>(status.st_size);
    if (run.files.size() < kMaxFiles) run.files.push_back({name, bytes});
    run.bytes += bytes;
    newest_s = std::max(newest_s, seconds(status.st_mtim));
    if (name != kRecordingFile) continue;
    run.has_recording = true;
    recording_s = seconds(status.st_mtim);
  }
  if (newest_s == 0.0 && ::lstat(folder.c_str(), &status) == 0) newest_s = seconds(status.st_mtim);
  run.recorded_unix_s = run.has_recording ? recording_s : newest_s;
  std::sort(run.files.begin(), run.files.end(),
            [](const RunFile& a, const RunFile& b) { return a.name < b.name; });
  return true;
}

/// The path of a run's folder. Throws UserError.
fs::path run_path(const std::string& folder, const std::string& run) {
  fs::path path = fs::path(folder) / run;
  if (folder.empty() || !text::is_found_name(run) || !is_folder(path))
    throw UserError(one_line(run) + ": no such run; GET /api/runs lists them");
  return path;
}

/// Opens a recording that nobody else uses, and that nobody can mark as in use while it is open.
/// Throws UserError.
Descriptor own_recording(const fs::path& path, const std::string& run) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (!file || ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode))
    throw UserError(run + ": has no run.mcap, so it may be something else; delete it by hand");
  if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0)
    throw UserError(run + ": is open: it is being recorded, replayed, reported or downloaded; " +
                    "try again later");
  return file;
}

}  // namespace

const RunFileType& kind_of(std::string_view file) {
  for (const RunFileType& each : kKinds)
    if (each.end == kRunNoteFile ? file == each.end : file.ends_with(each.end)) return each;
  return kOther;
}

std::vector<Run> list_runs(const std::string& folder) {
  std::vector<Run> runs;
  std::error_code error;
  std::size_t seen = 0;
  if (folder.empty()) return runs;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (++seen > kMaxEntries) break;
    Run run{.folder = at->path().filename().string()};
    if (text::is_found_name(run.folder) && look_at(at->path(), run)) runs.push_back(std::move(run));
  }
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return std::pair(a.recorded_unix_s, a.folder) > std::pair(b.recorded_unix_s, b.folder);
  });
  return runs;
}

std::vector<std::string> files_of(const std::string& folder, const std::string& run) {
  std::vector<std::string> names;
  struct stat status {};
  std::error_code error;
  for (fs::directory_iterator at(run_path(folder, run), error), end; !error && at != end;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (text::is_found_name(name) && ::lstat(at->path().c_str(), &status) == 0 &&
        S_ISREG(status.st_mode))
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

Descriptor open_run_file(const std::string& folder, const std::string& run, const std::string& file,
                         std::uint64_t& bytes) {
  if (folder.empty() || !text::is_found_name(run) || !text::is_found_name(file))
    return Descriptor();
  const Descriptor root(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  const Descriptor inside(
      ::openat(root.get(), run.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  // Opening a pipe must not block.
  Descriptor found(
      ::openat(inside.get(), file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (!inside || !found || ::fstat(found.get(), &status) != 0 || !S_ISREG(status.st_mode))
    return Descriptor();
  record::mark_in_use(found.get());
  bytes = static_cast<std::uint64_t>(status.st_size);
  return found;
}

RunNote note_beside(const std::string& recording) try {
  const fs::path path = fs::path(recording).parent_path() / kRunNoteFile;
  std::error_code error;
  return fs::is_regular_file(fs::symlink_status(path, error))
             ? parse_run_note(read_short(path), kRunNoteFile)
             : RunNote{};
} catch (const UserError&) {
  return {};
}

RunNote change_note(const std::string& folder, const std::string& run,
                    const RunNoteChange& change) {
  const fs::path path = run_path(folder, run);
  Run found;
  look_at(path, found);
  // A note that cannot be read is replaced.
  RunNote note = changed(found.note, change);
  if (const std::string why = why_not(note); !why.empty()) throw UserError(why);
  const fs::path file = path / kRunNoteFile;
  // A link or a pipe would be written through, to somewhere else.
  std::error_code error;
  const fs::file_status status = fs::symlink_status(file, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw UserError(run + "/" + kRunNoteFile + ": not a file; delete it by hand");
  if (!note.empty())
    text::write_file(file.string(), write_run_note(note));
  else if (!fs::remove(file, error) && error)
    throw UserError(run + "/" + kRunNoteFile + ": cannot be deleted (" + error.message() + ")");
  return note;
}

void delete_run(const std::string& folder, const std::string& run) {
  const fs::path path = run_path(folder, run);
  std::error_code error;
  // A deletion that was interrupted leaves an empty folder at last.
  if (fs::remove(path, error)) return;
  error.clear();
  const Descriptor own = own_recording(path / kRecordingFile, run);
  std::vector<fs::path> files;
  for (fs::directory_iterator at(path, error), end; !error && at != end; at.increment(error)) {
    if (is_folder(at->path()))
      throw UserError(run + ": there is a folder in it, " +
                      one_line(at->path().filename().string()) + "; delete it by hand");
    files.push_back(at->path());
  }
  // The note, which protects the run, is deleted late, and the recording, without which nothing is
  // taken for a run, is the last.
  const auto rank = [](const fs::path& file) {
    return file.filename() == kRecordingFile ? 2 : file.filename() == kRunNoteFile ? 1 : 0;
  };
  std::ranges::stable_sort(files, {}, rank);
  for (const fs::path& file : files)
    if (!error) fs::remove(file, error);
  if (!error) fs::remove(path, error);
  if (error)
    throw UserError(run + ": cannot be deleted (" + error.message() +
                    "); check the folder's permissions");
}

FreedSpace free_space(const std::string& folder, std::uint64_t max_bytes, std::string_view only) {
  FreedSpace freed;
  std::vector<Run> runs = list_runs(folder);
  std::erase_if(
      runs, [&](const Run& run) { return !only.empty() && run.folder.find(only) != kDateLength; });
  std::size_t noted = 0;
  std::string failure;
  for (const Run& run : runs) freed.bytes += run.bytes;
  std::reverse(runs.begin(), runs.end());
  for (const Run& run : runs) {
    if (freed.bytes <= max_bytes) return freed;
    if (run.has_note) {
      ++noted;
      continue;
    }
    try {
      delete_run(folder, run.folder);
      freed.deleted.push_back(run.folder);
      freed.bytes -= run.bytes;
    } catch (const UserError& error) {
      if (failure.empty()) failure = error.what();
    }
  }
  if (freed.bytes > max_bytes)
    freed.why_not =
        text::format(
            "the recordings have %.0f MB, more than the %.0f MB of "
            "record.quota_mb: %zu have a name, note or tags",
            static_cast<double>(freed.bytes) * 1e-6, static_cast<double>(max_bytes) * 1e-6, noted) +
        (failure.empty() ? "; delete some" : "; " + failure);
  return freed;
}

std::string make_run_folder(const std::string& directory, std::string_view name,
                            std::int64_t unix_ns) {
  text::make_folder(directory, "--record");
  const std::string stem =
      directory + "/" + date_and_time(unix_ns) + "-" + text::file_name_of(name);
  std::string folder = stem;
  std::error_code error;
  for (int i = 2; !fs::create_directory(folder, error); ++i) {
    if (error)
      throw UserError(folder + ": cannot create the folder (" + error.message() +
                      "); give another --record");
    folder = stem + "-" + std::to_string(i);
  }
  return folder;
}

void sweep_runs(const std::string& folder) {
  if (folder.empty()) return;
  text::sweep_temporary(folder);
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (is_folder(at->path())) text::sweep_temporary(at->path().string());
}

std::uint64_t free_bytes(const std::string& folder) {
  struct statvfs disk {};
  return ::statvfs(folder.c_str(), &disk) == 0 ? disk.f_bavail * disk.f_frsize : 0;
}

}  // namespace tp100::runs
