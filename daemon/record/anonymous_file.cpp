#include "record/anonymous_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/error.h"
#include "text/temporary.h"

namespace tp100::record {
AnonymousFile::AnonymousFile(const std::string& folder) {
  std::string path;
  file_ = Descriptor(text::make_temporary_file(folder, path));
  if (!file_)
    throw SetupError(folder + ": nothing can be written there (" + std::strerror(errno) +
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

}  // namespace tp100::record
