#pragma once
// Writes a file completely or not at all, and never over one that the program reads; and properties
// of files besides their content.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/error.h"

namespace tp100::text {

/// Whether the content is on the disk when the call returns; kNo leaves the time to the kernel, for
/// files that are replaced frequently.
enum class Flush : bool { kNo, kYes };

/// Writes a result: replaces `path` with `content`, written under a temporary name beside it
/// (text/temporary.h), then renamed. The new file has the mode and, where this account may set
/// them, the owner and group of the one that it replaces. On failure (no such folder, no
/// permission, disk full) the old file stays and nothing else is left behind. Anything but a
/// regular file (a pipe, /dev/stdout) is written directly. Throws UserError, also if the program
/// reads that file (note_read).
void write_file(const std::string& path, std::string_view content, Flush flush = Flush::kYes);

/// The same for content that comes in pieces. Without commit() nothing happens.
class FileReplacement {
 public:
  /// Throws UserError.
  explicit FileReplacement(const std::string& path);
  ~FileReplacement();
  /// Appends. Throws UserError.
  void write(std::string_view content);
  /// Puts the file in its place. Throws UserError.
  void commit(Flush flush = Flush::kYes);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Edits a file: as write_file(), also one that was read, and the file that it replaces stays as
/// kept_path(path). At each moment `path` is the old file or the new one, and the old one is there
/// under one of the two names. Throws UserError, and changes nothing: also if there is anything
/// but a regular file at kept_path(path).
void edit_file(const std::string& path, std::string_view content);
/// Exchanges the files at `path` and kept_path(path), at once where the file system can; elsewhere
/// a kill in between leaves the one that was kept as kept_path(path).old. Throws UserError.
void restore_file(const std::string& path);
/// FILE.bak, beside the file itself if `path` is a link to it.
std::string kept_path(const std::string& path);

/// Notes that the program reads the file `path`, so that no result is written over it, by whatever
/// name or link. A file that the program itself has written is no input. Any thread.
void note_read(const std::string& path);
/// Throws UserError if the program reads the file `path`.
void require_not_read(const std::string& path);
/// Notes that the program itself has written `path`: for writers of other kinds, after
/// require_not_read().
void note_written(const std::string& path);

/// Creates the folder for results and its parents if absent; empty is the working folder. Throws
/// UserError, which asks for another value of `option`.
void make_folder(const std::string& path, const std::string& option = "--out");

/// When the file was last written, in seconds since 1970; 0: not known.
std::int64_t written_unix_s(const std::string& path);

}  // namespace tp100::text
