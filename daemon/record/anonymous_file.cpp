#include "record/anonymous_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "core/error.h"
#include "text/temporary.h"

namespace tp100::record {
namespace {

/// Calls `move(at, left)`, a read or write at an offset, until everything is moved. Zero or an
/// errno.
template <class Move>
int move_all(std::size_t size, Move move) {
  for (std::size_t done = 0; done < size;) {
    const ssize_t n = move(done, size - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return n < 0 ? errno : EIO;
    done += static_cast<std::size_t>(n);
  }
  return 0;
}

}  // namespace

AnonymousFile::AnonymousFile(const std::string& folder) {
  std::string path;
  descriptor_ = text::make_temporary_file(folder, path);
  if (descriptor_ < 0)
    throw SetupError(folder + ": nothing can be written there (" + std::strerror(errno) +
                     "); check folder, permission and free space, or give another");
  ::unlink(path.c_str());
}

AnonymousFile::~AnonymousFile() { ::close(descriptor_); }

int AnonymousFile::append(std::span<const std::uint8_t> bytes) {
  const int error = move_all(bytes.size(), [&](std::size_t at, std::size_t left) {
    return ::pwrite(descriptor_, bytes.data() + at, left, static_cast<off_t>(size_ + at));
  });
  if (error == 0) size_ += bytes.size();
  return error;
}

int AnonymousFile::read(std::uint64_t from, std::span<std::uint8_t> into) const {
  return move_all(into.size(), [&](std::size_t at, std::size_t left) {
    return ::pread(descriptor_, into.data() + at, left, static_cast<off_t>(from + at));
  });
}

}  // namespace tp100::record
