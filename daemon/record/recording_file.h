#pragma once
// The file that a recording grows in. Whole records or nothing: what does not fit is taken back.

#include <cstdint>
#include <span>
#include <string>

namespace tp100::record {

class RecordingFile {
 public:
  /// Creates the file, or empties the one that is there. Throws SetupError.
  explicit RecordingFile(std::string path);
  ~RecordingFile();
  RecordingFile(const RecordingFile&) = delete;
  RecordingFile& operator=(const RecordingFile&) = delete;

  /// All of `bytes`, or nothing and error() tells why. After an error nothing is written any more.
  void append(std::span<const std::uint8_t> bytes);
  /// 0 or an errno.
  int error() const { return error_; }
  std::uint64_t size() const { return size_; }
  /// Bytes that the file may still grow by: free space of its disk, and the process's limit. May
  /// be wrong by what others write meanwhile.
  std::uint64_t room() const;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int descriptor_ = -1;
  int error_ = 0;
  std::uint64_t size_ = 0;
};

/// Removes a recording, and its folder if nothing else is in it; what is gone already is no error.
void remove_recording(const std::string& path);

}  // namespace tp100::record
