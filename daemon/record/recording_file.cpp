#include "record/recording_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>

#include "core/error.h"
#include "text/atomic_file.h"

namespace tp100::record {

RecordingFile::RecordingFile(std::string path) : path_(std::move(path)) {
  text::require_not_read(path_);
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOCTTY, 0666);
  if (descriptor_ < 0)
    throw SetupError(path_ + ": cannot be written (" + std::strerror(errno) +
                     "); check folder, permission and free space");
  text::note_written(path_);
  mark_in_use(descriptor_);
}

RecordingFile::~RecordingFile() { ::close(descriptor_); }

void RecordingFile::append(std::span<const std::uint8_t> bytes) {
  if (error_ != 0) return;
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t n = ::write(descriptor_, bytes.data() + written, bytes.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      error_ = n < 0 ? errno : EIO;
      break;
    }
    written += static_cast<std::size_t>(n);
  }
  if (error_ == 0) {
    size_ += bytes.size();
  } else if (written > 0 && (::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0 ||
                             ::lseek(descriptor_, static_cast<off_t>(size_), SEEK_SET) < 0)) {
    // The partial record stays; readers stop there.
    size_ += written;
  }
}

std::uint64_t RecordingFile::room() const {
  std::uint64_t room = std::numeric_limits<std::uint64_t>::max();
  struct statvfs disk {};
  if (::fstatvfs(descriptor_, &disk) == 0) room = disk.f_bavail * disk.f_frsize;
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    room = std::min<std::uint64_t>(room,
                                   limit.rlim_cur - std::min<std::uint64_t>(size_, limit.rlim_cur));
  return room;
}

void mark_in_use(int descriptor) { ::flock(descriptor, LOCK_SH | LOCK_NB); }

UsedFile::UsedFile(const std::string& path)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)) {
  if (descriptor_ >= 0) mark_in_use(descriptor_);
}

UsedFile::~UsedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void remove_recording(const std::string& path) {
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  std::filesystem::remove(std::filesystem::path(path).parent_path(), ignored);
}

}  // namespace tp100::record
