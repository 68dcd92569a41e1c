#pragma once
// Files of the recorder. One thread each.

#include <cstdint>
#include <span>
#include <string>

#include "core/descriptor.h"

namespace tp100::record {

/// Name of a recording in the folder of its run.
inline constexpr const char* kRecordingFile = "run.mcap";

/// The file of a growing recording. Appends whole records or nothing: a partial one is removed.
class RecordingFile {
 public:
  /// Creates the file, or truncates an existing one. Throws UserError.
  explicit RecordingFile(std::string path);

  /// Appends all of `bytes`, or nothing, with the cause in error(). After an error nothing more is
  /// written.
  void append(std::span<const std::uint8_t> bytes);
  /// 0 or an errno.
  int error() const { return error_; }
  std::uint64_t size() const { return size_; }
  /// Bytes by which the file may still grow: free space of its disk, and the process's limit. Other
  /// programs may take some of it.
  std::uint64_t room() const;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  Descriptor file_;
  int error_ = 0;
  std::uint64_t size_ = 0;
};

/// A nameless file for data that would fill the memory; it disappears with the process, however
/// that ends.
class AnonymousFile {
 public:
  /// On the disk of `folder`. Throws UserError.
  explicit AnonymousFile(const std::string& folder);

  /// Appends all of `bytes`, or nothing. 0 or an errno.
  int append(std::span<const std::uint8_t> bytes);
  /// Fills `into` with the bytes from `from` on. 0 or an errno; EIO: too few.
  int read(std::uint64_t from, std::span<std::uint8_t> into) const;
  std::uint64_t size() const { return size_; }

 private:
  Descriptor file_;
  std::uint64_t size_ = 0;
};

/// Tells other programs that the open file is in use until it is closed (a shared flock), so that
/// nobody deletes it; readers and writers of recordings do so. On a disk without such locks it does
/// nothing.
void mark_in_use(int descriptor);

/// A recording that is in use for as long as this exists; a missing one is no error.
class UsedFile {
 public:
  explicit UsedFile(const std::string& path);

 private:
  Descriptor file_;
};

/// Removes a recording, and its folder if that is empty then; a missing one is no error.
void remove_recording(const std::string& path);

}  // namespace tp100::record
