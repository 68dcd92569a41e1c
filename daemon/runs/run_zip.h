#pragma once
// A recorded run as one ZIP archive, written while it is sent: its size is known before its first
// byte, and nothing is kept on the disk. The files are stored as they are (a recording is
// compressed already) in a folder with the run's name. Layout: APPNOTE.TXT 6.3.9 of PKWARE,
// sections 4.3.7, 4.3.12 and 4.3.16.

#include <boost/crc.hpp>
#include <cstdint>
#include <ctime>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "record/recording_file.h"
#include "runs/run_folder.h"

namespace tp100::runs {

/// Most files of a run in an archive.
inline constexpr std::size_t kMaxZipFiles = 1000;

/// Waits for the disk; one thread at a time. While it exists, its recording is in use
/// (record/recording_file.h).
class RunZip {
 public:
  /// Takes the regular files of the run as they are now, no links. Throws UserError: no such run,
  /// too many files, or more than 4 GB.
  RunZip(const std::string& folder, const std::string& run);

  /// Size of the whole archive, in bytes.
  std::uint64_t size() const { return size_; }

  /// Writes the next bytes of the archive into `into`, 1 kB or more, and returns how many. 0: none
  /// yet (a file is read for its checksum first), or the archive has ended. Nothing: a
  /// file was changed or deleted meanwhile, so the archive cannot be completed. Reads at most
  /// `into.size()` bytes from the disk.
  std::optional<std::size_t> read(std::span<char> into);

 private:
  struct Entry {
    std::string name;  // in the run's folder
    std::uint64_t bytes = 0;
    std::uint64_t device = 0, inode = 0;  // of the file that was found
    std::time_t modified = 0;
    std::uint64_t at = 0;  // of its header in the archive
    std::uint32_t crc = 0;
  };

  enum class Next { kChecksum, kContent, kDirectory, kEnd };

  std::string name_in_archive(const Entry& entry) const { return run_ + "/" + entry.name; }
  std::string header(const Entry& entry, bool central) const;
  std::string directory() const;
  bool open();
  std::optional<std::size_t> read_file(std::span<char> into);

  const std::string folder_, run_;
  std::optional<record::UsedFile> used_;
  std::vector<Entry> entries_;
  std::uint64_t size_ = 0;
  std::size_t at_ = 0;  // the entry being read
  Next next_ = Next::kChecksum;
  Descriptor file_;
  std::uint64_t offset_ = 0;  // in the file, or in the directory
  boost::crc_32_type crc_;
};

}  // namespace tp100::runs
