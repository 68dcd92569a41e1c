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
#include "text/temporary.h"

namespace tp100::record {

RecordingFile::RecordingFile(std::string path) : path_(std::move(path)) {
  text::require_not_read(path_);
  file_ =
      Descriptor(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOCTTY, 0666));
  if (!file_)
    throw UserError(path_ + ": cannot be written (" + std::strerror(errno) +
                    "); check folder, permission and free space");
  text::note_written(path_);
  mark_in_use(file_.get());
}

void RecordingFile::append(std::span<const std::uint8_t> bytes) {
  if (error_ != 0) return;
  std::size_t written = 0;
  error_ = move_all(bytes.size(), written, [&](std::size_t at, std::size_t left) {
    return ::write(file_.get(), bytes.data() + at, left);
  });
  if (error_ == 0) {
    size_ += bytes.size();
  } else if (written > 0 && (::ftruncate(file_.get(), static_cast<off_t>(size_)) != 0 ||
                             ::lseek(file_.get(), static_cast<off_t>(size_), SEEK_SET) < 0)) {
    // The partial record stays; readers stop there.
    size_ += written;
  }
}

std::uint64_t RecordingFile::room() const {
  std::uint64_t room = std::numeric_limits<std::uint64_t>::max();
  struct statvfs disk {};
  if (::fstatvfs(file_.get(), &disk) == 0) room = disk.f_bavail * disk.f_frsize;
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    room = std::min<std::uint64_t>(room,
                                   limit.rlim_cur - std::min<std::uint64_t>(size_, limit.rlim_cur));
  return room;
}

AnonymousFile::AnonymousFile(const std::string& folder) {
  std::string path;
  file_ = Descriptor(text::make_temporary_file(folder, path));
  if (!file_)
    throw UserError(folder + ": nothing can be written there (" + std::strerror(errno) +
                    "); check folder, permission and free space, or give another");
  ::unlink(path.c_str());
}

int AnonymousFile::append(std::span<const std::uint8_t> bytes) {
  std::size_t done = 0;
  const int error = move_all(bytes.size(), done, [&](std::size_t at, std::size_t left) {
    return ::pwrite(file_.get(), bytes.data() + at, left, static_cast<off_t>(size_ + at));
  });
  if (error == 0) size_ += bytes.size();
  return error;
}

int AnonymousFile::read(std::uint64_t from, std::span<std::uint8_t> into) const {
  std::size_t done = 0;
  return move_all(into.size(), done, [&](std::size_t at, std::size_t left) {
    return ::pread(file_.get(), into.data() + at, left, static_cast<off_t>(from + at));
  });
}

void mark_in_use(int descriptor) { ::flock(descriptor, LOCK_SH | LOCK_NB); }

UsedFile::UsedFile(const std::string& path)
    : file_(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)) {
  if (file_) mark_in_use(file_.get());
}

void remove_recording(const std::string& path) {
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  std::filesystem::remove(std::filesystem::path(path).parent_path(), ignored);
}

}  // namespace tp100::record
