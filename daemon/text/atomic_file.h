#pragma once
// Writes a result file completely or not at all; and properties of files besides their content.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/error.h"

namespace tp100::text {

/// Whether the content is on the disk when the call returns; kNo leaves the time to the kernel, for
/// files that are replaced frequently.
enum class Flush : bool { kNo, kYes };

/// Replaces `path` with `content`: written under a temporary name beside it, then renamed. On
/// failure (no such folder, no permission, disk full) the old file stays and nothing else is left
/// behind. Anything but a regular file (a pipe, /dev/stdout) is written directly. Throws
/// SetupError.
void write_file(const std::string& path, std::string_view content, Flush flush = Flush::kYes);

/// The same for content that comes in pieces. Without commit() nothing happens.
class FileReplacement {
 public:
  /// Throws SetupError.
  explicit FileReplacement(const std::string& path);
  ~FileReplacement();
  /// Appends. Throws SetupError.
  void write(std::string_view content);
  /// Puts the file in its place. Throws SetupError.
  void commit(Flush flush = Flush::kYes);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Whether a file may have a name that came from elsewhere, and be created in a folder of the
/// program's: letters, digits, '-', '_' and '.', at most `most`, no '.' first.
bool is_file_name(std::string_view name, std::size_t most = 64);
/// The rule of is_file_name, for an argument called name.
inline constexpr const char* kFileNameRule =
    "name must be 1 to 64 letters, digits, '-', '_' or '.', not starting with '.'";

/// Creates the folder for results and its parents if absent; empty is the working folder. Throws
/// SetupError, which asks for another value of `option`.
void make_folder(const std::string& path, const std::string& option = "--out");

/// When the file was last written, in seconds since 1970; 0: not known.
std::int64_t written_unix_s(const std::string& path);

}  // namespace tp100::text
